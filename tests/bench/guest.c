/*
 * guest.c - all scenes on a processor in qemu: the instructions per frame, and the memory that each needs.
 */
#include "guest.h"

#include "scenes.h"

static uint64_t arena[46 * 1024];

static void print_memory(const struct bench *bench)
{
    struct sheen_stats stats;

    sheen_frame_stats(bench->frame, &stats);
    guest_print("memory ");
    guest_print_number(stats.ram_arena);
    guest_print_number(stats.ram_vertices);
    guest_print_number(stats.ram_lists);
    guest_print_number(stats.ram_bands);
    guest_print_number((uint32_t)sizeof bench->material);
}

/* A scene, its shading and what is drawn of the texture; `name` is that in a word. */
struct frame {
    const struct bench_scene *scene;
    const char *name;
    uint8_t shading, texture;
};

/* Extras of a frame, each of which costs something. */
enum more {
    PLAIN,
    DITHERED,
    FOGGED,
    STIPPLED,
    MORPHED,
    SMOOTH,
    OUTLINED,
    WIRED
};

/*
 * Prints "S1 gouraud 16 4145520 memory ...": rows per band, instructions, and B for arena, vertices, lists, bands and
 * material.
 */
static int measure(const struct frame *frame, int band_rows, enum more more)
{
    static const char *const more_name[] = {" ",         " dithered ", " fogged ",   " stippled ",
                                            " morphed ", " smooth ",   " outlined ", " wired "};
    static const struct sheen_edges *const edges[] = {
        [SMOOTH] = &sheen_edges_smooth, [OUTLINED] = &sheen_edges_outline, [WIRED] = &sheen_edges_wire};
    static struct bench bench;

    bench_config(&bench, frame->scene, (enum sheen_shading)frame->shading, band_rows);
    bench.dither = more == DITHERED;
    bench.fogged = more == FOGGED;
    bench.transparency = more == STIPPLED ? 32 : 0;
    bench.morphed = more == MORPHED;
    if (bench.morphed)
        bench.config.max_used = frame->scene->mesh.vertices;
    bench.edges = edges[more];
    bench.texture = frame->texture;
    int status = bench_begin(&bench, arena, sizeof arena);
    if (status == SHEEN_OK)
        status = bench_first(&bench);
    guest_count();
    if (status == SHEEN_OK)
        status = bench_measured(&bench);
    uint32_t count = guest_counted();
    guest_print(frame->scene->name);
    guest_print(" ");
    guest_print(frame->name);
    guest_print(more_name[more]);
    guest_print_number((uint32_t)band_rows);
    if (status == SHEEN_OK) {
        guest_print_number(count);
        print_memory(&bench);
    } else {
        guest_print(sheen_strerror(status));
    }
    guest_print("\n");
    return status;
}

/*
 * Without and with dither (unlit texels only without), and in one band. S3 also in fog and with half of its pixels; S1
 * with Gouraud also halfway between two frames.
 */
static void measure_all(const struct frame *frame)
{
    const int lit = frame->texture != BENCH_UNLIT && frame->texture < BENCH_BILINEAR;

    if (measure(frame, 16, PLAIN) < 0 || (lit && measure(frame, 16, DITHERED) < 0) ||
        measure(frame, BENCH_HEIGHT, PLAIN) < 0)
        guest_leave(1);
    if (frame->scene == &bench_scenes[0] && frame->texture == BENCH_PLAIN && frame->shading == SHEEN_GOURAUD &&
        measure(frame, 16, MORPHED) < 0)
        guest_leave(1);
    if (frame->scene != &bench_scenes[2] || (frame->texture != BENCH_MATCAP && !lit))
        return;
    if (measure(frame, 16, FOGGED) < 0 || measure(frame, 16, STIPPLED) < 0)
        guest_leave(1);
}

/* Without quads: each triangle is drawn by itself. */
static void measure_triangles(const struct bench_scene *scene)
{
    static const char *const name[] = {"flat_triangles", "gouraud_triangles", "phong_triangles", "slerp_triangles"};

    for (int shading = SHEEN_FLAT; shading <= SHEEN_SLERP; shading++) {
        const struct frame frame = {scene, name[shading], (uint8_t)shading, BENCH_TRIANGLES};
        if (measure(&frame, 16, PLAIN) < 0)
            guest_leave(1);
    }
}

/* With two lights that may have colours. */
static void measure_lights(const struct bench_scene *scene)
{
    const struct frame frame = {scene, "phong_lights", SHEEN_PHONG, BENCH_LIGHTS};

    if (measure(&frame, 16, PLAIN) < 0)
        guest_leave(1);
}

/* With colours, and with as many independent channels but without colours. */
static void measure_colored(const struct bench_scene *scene)
{
    static const char *const name[] = {"flat_colored", "gouraud_colored", "phong_colored", "slerp_colored"};

    for (int shading = SHEEN_FLAT; shading <= SHEEN_SLERP; shading++) {
        const struct frame frame = {scene, name[shading], (uint8_t)shading, BENCH_COLORED};
        if (measure(&frame, 16, PLAIN) < 0)
            guest_leave(1);
    }
    const struct frame more[] = {{scene, "gouraud_highlighted", SHEEN_GOURAUD, BENCH_HIGHLIGHTED},
                                 {scene, "textured_colored", SHEEN_GOURAUD, BENCH_TEXTURED_COLORED},
                                 {scene, "matcap_colored", SHEEN_GOURAUD, BENCH_MATCAP_COLORED}};
    for (const struct frame *frame = more; frame < more + sizeof more / sizeof *more; frame++)
        if (measure(frame, 16, PLAIN) < 0)
            guest_leave(1);
}

static void measure_edges(void)
{
    const struct frame frame = {.scene = &bench_teapot, .name = "gouraud", .shading = SHEEN_GOURAUD};

    if (measure(&frame, 16, PLAIN) < 0)
        guest_leave(1);
    for (int more = SMOOTH; more <= WIRED; more++)
        if (measure(&frame, 16, (enum more)more) < 0)
            guest_leave(1);
}

void guest_main(void)
{
    static const char *const shading_name[] = {"flat", "gouraud", "phong", "slerp"};
    static const char *const texture_name[] = {
        "",       "textured_unlit", "textured_lit",   "textured_glossy", "textured_bilinear",
        "matcap", "matcap_vertex",  "matcap_bilinear"};

    guest_check_counter();
    for (int i = 0; i < BENCH_SCENES; i++) {
        struct frame frame = {.scene = &bench_scenes[i]};
        for (; frame.shading <= SHEEN_SLERP; frame.shading++) {
            frame.name = shading_name[frame.shading];
            measure_all(&frame);
        }
        frame.shading = SHEEN_GOURAUD;
        for (frame.texture = BENCH_UNLIT; frame.texture <= BENCH_MATCAP_BILINEAR && i % 2 == 0; frame.texture++) {
            frame.name = texture_name[frame.texture];
            measure_all(&frame);
        }
        if (i % 2 == 0)
            measure_colored(frame.scene);
    }
    measure_triangles(&bench_scenes[0]);
    measure_lights(&bench_scenes[0]);
    measure_edges();
    guest_leave(0);
}
