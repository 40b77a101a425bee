/*
 * guest.c - all scenes on a processor in qemu: instructions a frame, and the memory that it takes.
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

/* "S1 gouraud 16 4145520 memory ...": the rows of a band, the count, B of arena, vertices, lists, bands, material. */
static int measure(const struct bench_scene *scene, enum sheen_shading shading, int band_rows, int dither)
{
    static const char *const name[] = {"flat", "gouraud", "phong", "slerp"};
    static struct bench bench;

    bench_config(&bench, scene, shading, band_rows);
    bench.dither = (uint8_t)dither;
    int status = bench_begin(&bench, arena, sizeof arena);
    if (status == SHEEN_OK)
        status = bench_first(&bench);
    guest_count();
    if (status == SHEEN_OK)
        status = bench_measured(&bench);
    uint32_t count = guest_counted();
    guest_print(scene->name);
    guest_print(" ");
    guest_print(name[shading]);
    guest_print(dither ? " dithered " : " ");
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

void guest_main(void)
{
    guest_check_counter();
    for (int scene = 0; scene < BENCH_SCENES; scene++) {
        for (int shading = SHEEN_FLAT; shading <= SHEEN_SLERP; shading++) {
            if (measure(&bench_scenes[scene], (enum sheen_shading)shading, 16, 0) < 0 ||
                measure(&bench_scenes[scene], (enum sheen_shading)shading, 16, 1) < 0 ||
                measure(&bench_scenes[scene], (enum sheen_shading)shading, BENCH_HEIGHT, 0) < 0)
                guest_leave(1);
        }
    }
    guest_leave(0);
}
