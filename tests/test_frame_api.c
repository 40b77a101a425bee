/*
 * test_frame_api.c - the public functions beside the main path: a whole frame in one call, what an error was about, the
 * arena's size at compile time, poses of the view, lights in the world, targets in memory, the depth that an overlay
 * gets.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "frame_test.h"

#define WIDTH 96
#define HEIGHT 72

static const struct actor ball = {STAGE_BALL, 0, SHEEN_PHONG, 0.2, 0.1, 4, 1, 20, 30};
static const struct actor torus = {STAGE_TORUS, 1, SHEEN_GOURAUD, -0.6, 0, 5, 1.2, 60, 50};

/* Draws a frame of these objects into `pixels`. 0 or a negative code. */
static int shoot(const struct sheen_view *view, const struct sheen_object *objects, unsigned count, uint16_t *pixels)
{
    struct sheen_memory memory = {.pixels = pixels, .stride = 2 * WIDTH};
    struct sheen_target target;
    struct memory_target unused = {.target = {.width = WIDTH, .height = HEIGHT}};
    struct sheen_config config;
    struct core_frame f;

    assert_int_equal(sheen_memory_target(&target, &memory, WIDTH, HEIGHT, SHEEN_RGB565_LE), SHEEN_OK);
    stage_config(&config, &unused, 4);
    config.target = &target;
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    int error = sheen_render(f.frame, view, objects, count);
    core_frame_free(&f);
    return error;
}

static void one_call(void **state)
{
    static uint16_t by_one[WIDTH * HEIGHT];
    struct memory_target target;
    struct sheen_config config;
    struct core_frame f;
    struct sheen_view view;
    struct sheen_object objects[2];
    const struct actor actors[2] = {ball, torus};

    (void)state;
    stage_view(&view);
    stage_draw(&stage, &ball, &objects[0]);
    stage_draw(&stage, &torus, &objects[1]);
    assert_int_equal(shoot(&view, objects, 2, by_one), SHEEN_OK);
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    stage_config(&config, &target, 2);
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    assert_int_equal(stage_frame(f.frame, &view, &stage, actors, 2), SHEEN_OK);
    assert_memory_equal(target.memory, by_one, sizeof by_one);

    /* A bad object: nothing is sent, the frame is idle again, and the next one sends everything. */
    memory_target_begin(&target);
    objects[1].shader = NULL;
    assert_int_equal(sheen_render(f.frame, &view, objects, 2), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_frame_about(f.frame, NULL), SHEEN_ABOUT_SHADER);
    struct sheen_stats stats;
    sheen_frame_stats(f.frame, &stats);
    assert_int_equal(stats.objects, 1); /* the index of the bad one */
    assert_int_equal(sheen_render(f.frame, &view, objects, 1), SHEEN_OK);
    sheen_frame_stats(f.frame, &stats);
    assert_int_equal(stats.objects, 1);
    assert_int_equal(stats.pixels, WIDTH * HEIGHT);
    core_frame_free(&f);
    memory_target_free(&target);
}

/* Draws a torus and a cut ball with capacity `subject` set to `room`. 0 if it suffices, else the number needed. */
static uint32_t short_of(enum sheen_subject subject, uint32_t room)
{
    static const struct actor cut = {STAGE_BALL, 2, SHEEN_PHONG, 0.2, 0.1, 1.3, 0.6, 0, 40};
    const struct actor *const actors[2] = {&torus, &cut};
    struct memory_target target;
    struct sheen_config config;
    struct core_frame f;
    struct sheen_view view;
    uint32_t needed = 0;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    stage_view(&view);
    stage_config(&config, &target, 2);
    config.max_clipped = 400;
    *(subject == SHEEN_ABOUT_MAX_VERTICES    ? &config.max_vertices
      : subject == SHEEN_ABOUT_MAX_USED      ? &config.max_used
      : subject == SHEEN_ABOUT_MAX_TRIANGLES ? &config.max_triangles
      : subject == SHEEN_ABOUT_MAX_DRAWS     ? &config.max_draws
                                             : &config.max_clipped) = (uint16_t)room;
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    for (int i = 0; i < 2 && needed == 0; i++) {
        struct sheen_object object;
        stage_draw(&stage, actors[i], &object);
        int error = sheen_draw(f.frame, &object);
        if (error == SHEEN_OK)
            continue;
        assert_int_equal(error, SHEEN_ERR_CAPACITY);
        assert_int_equal(sheen_frame_about(f.frame, &needed), subject);
    }
    core_frame_free(&f);
    memory_target_free(&target);
    return needed;
}

/* The capacity reported as needed must suffice and one less must not: for the first draw, then for both. */
static void capacities_name_what_would_do(void **state)
{
    static const enum sheen_subject subjects[] = {SHEEN_ABOUT_MAX_VERTICES, SHEEN_ABOUT_MAX_USED,
                                                  SHEEN_ABOUT_MAX_TRIANGLES, SHEEN_ABOUT_MAX_DRAWS,
                                                  SHEEN_ABOUT_MAX_CLIPPED};

    (void)state;
    for (size_t k = 0; k < sizeof subjects / sizeof subjects[0]; k++) {
        uint32_t room = 1, needed;
        while ((needed = short_of(subjects[k], room)) != 0) {
            assert_true(needed > room);
            assert_int_equal(needed == 2 ? needed : short_of(subjects[k], needed - 1), needed);
            room = needed;
        }
        print_message("  %s: %u do\n", sheen_subject_name(subjects[k]), (unsigned)room);
        assert_true(room > 1);
    }
}

static void configurations_name_the_field(void **state)
{
    const struct sheen_target target = {.push = NULL};
    struct sheen_config config = {.target = &target};

    (void)state;
    assert_int_equal(sheen_config_about(&config), SHEEN_ABOUT_TARGET);
    assert_string_equal(sheen_subject_name(SHEEN_ABOUT_MAX_CARRIED), "max_carried");
    assert_string_equal(sheen_subject_name((enum sheen_subject)99), "nothing");
}

/* The macro gives the same size as the function over many configurations, and it is a constant expression. */
static void arena_at_compile_time(void **state)
{
    static uint64_t constant[SHEEN_ARENA_DEFAULT_BYTES(240, 240, 2, 530, 512) / 8];
    struct memory_target target;
    uint32_t seed = 1;

    (void)state;
    assert_true(sizeof constant > 1000);
    for (int i = 0; i < 3000; i++) {
        int grey = i % 2, width = 8 + (int)(stage_random(&seed) % 600), height = 8 + (int)(stage_random(&seed) % 400);
        struct sheen_memory memory = {.pixels = &seed, .stride = 2000};
        unsigned align = 1u << stage_random(&seed) % 5;
        struct sheen_target where;
        assert_int_equal(sheen_memory_target(&where, &memory, (uint16_t)width, (uint16_t)height,
                                             grey ? SHEEN_GREY256 : SHEEN_RGB565_BE),
                         SHEEN_OK);
        where.align_y = (uint8_t)align;
        struct sheen_config c = {.target = &where,
                                 .band_rows = (uint16_t)(1 + stage_random(&seed) % (unsigned)(height + 9)),
                                 .buffers = (uint8_t)(1 + stage_random(&seed) % 2),
                                 .workers = (uint8_t)(1 + stage_random(&seed) % 4),
                                 .max_vertices = (uint16_t)(1 + stage_random(&seed) % 65535),
                                 .max_used = (uint16_t)(stage_random(&seed) % 65536),
                                 .max_triangles = (uint16_t)(1 + stage_random(&seed) % 65535),
                                 .max_draws = (uint16_t)(1 + stage_random(&seed) % 100),
                                 .max_clipped = (uint16_t)(stage_random(&seed) % 3 * 77),
                                 .clipper = &sheen_clipper,
                                 .max_shades = (uint8_t)(1 + stage_random(&seed) % 4),
                                 .max_edges = (uint16_t)(stage_random(&seed) % 3 * 111),
                                 .smooth = (uint8_t)(stage_random(&seed) % 2),
                                 .max_carried = (uint16_t)(1 + stage_random(&seed) % 254)};
        const unsigned pixel = grey ? 1 : 2, high = c.band_rows < height ? c.band_rows : (unsigned)height,
                       rows = (high + align - 1) / align * align;
        uint16_t used = c.max_used == 0 || c.max_used > c.max_vertices ? c.max_vertices : c.max_used;
        size_t bytes = SHEEN_ARENA_BYTES(width, height, pixel, rows, c.buffers, c.max_vertices, used, c.max_triangles,
                                         c.max_draws, c.max_clipped, c.max_carried);
        size_t worker = SHEEN_WORKER_BYTES(width, pixel, rows, c.buffers, c.max_triangles, c.max_carried);
        size_t spare = 0;
        if (!grey) {
            bytes += SHEEN_STORE(c.max_shades - 1u, SHEEN_BYTES_SHADES);
            spare = c.max_shades > 1 ? 8 : 0;
        }
        if (c.max_edges > 0) {
            bytes += SHEEN_EDGE_BYTES(width, pixel, rows, c.buffers, c.max_edges);
            worker += SHEEN_EDGE_WORKER_BYTES(width, pixel, rows, c.buffers);
        }
        if (c.smooth) {
            bytes += SHEEN_SMOOTH_BYTES(width, rows);
            worker += SHEEN_SMOOTH_BYTES(width, rows);
        }
        bytes += (c.workers - 1u) * worker;
        assert_in_range(sheen_arena_size(&c), bytes - spare, bytes);
    }
    assert_int_equal(memory_target_init(&target, 240, 240, SHEEN_RGB565_BE), 0);
    struct sheen_config c = {.target = &target.target, .max_vertices = 530, .max_triangles = 512};
    assert_int_equal(sheen_arena_size(&c), sizeof constant);
    for (uint16_t triangles = 1; triangles < 300; triangles++) { /* few are all carried, of many 80 */
        c.max_triangles = triangles;
        assert_int_equal(sheen_arena_size(&c), SHEEN_ARENA_DEFAULT_BYTES(240, 240, 2, 530, triangles));
    }
    memory_target_free(&target);
}

/* Moving the view or the object gives the same picture. Lights in the world turn with the view, others do not. */
static void views_and_lights(void **state)
{
    static uint16_t by_object[WIDTH * HEIGHT], by_view[WIDTH * HEIGHT], other[WIDTH * HEIGHT];
    const struct sheen_light eye_light = {.to = {SHEEN_Q30(-0.5), SHEEN_Q30(0.7), SHEEN_Q30(0.5)}, .with_eye = 1};
    struct sheen_light world_light = eye_light;
    struct sheen_object object;
    struct sheen_view view;

    (void)state;
    world_light.with_eye = 0;
    stage_view(&view);
    stage_draw(&stage, &ball, &object);
    object.lights = &eye_light;
    sheen_pose_orbit(&object.pose, sheen_degrees(40), sheen_degrees(25), 0, SHEEN_Q24(4));
    assert_int_equal(shoot(&view, &object, 1, by_object), SHEEN_OK);
    view.pose = object.pose;
    memset(&object.pose, 0, sizeof object.pose);
    assert_int_equal(shoot(&view, &object, 1, by_view), SHEEN_OK);
    assert_memory_equal(by_object, by_view, sizeof by_view);
    object.lights = &world_light;
    assert_int_equal(shoot(&view, &object, 1, other), SHEEN_OK);
    assert_memory_not_equal(by_view, other, sizeof other);
    /* A light in the world that the view turns to the direction it had in eye space. */
    for (int k = 0; k < 3; k++) {
        const sheen_q30_t *r = view.pose.rotation;
        double to = 0;
        for (int i = 0; i < 3; i++)
            to += (double)r[3 * i + k] / 1073741824 * eye_light.to[i];
        world_light.to[k] = (int32_t)lrint(to);
    }
    assert_int_equal(shoot(&view, &object, 1, other), SHEEN_OK);
    int differ = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        differ += other[i] != by_view[i];
    assert_true(differ < WIDTH * HEIGHT / 500); /* because the light is rounded once more */
}

/* With only the required fields set, the zeros elsewhere mean defaults. */
static void zeros(void **state)
{
    static uint16_t pixels[WIDTH * HEIGHT];
    struct sheen_view view = {.fov = 0};
    struct sheen_object object = {.mesh = &stage.mesh[STAGE_BALL].mesh, .shader = &sheen_flat};
    const struct sheen_material white = {.base = {255, 255, 255}, .ambient = SHEEN_Q16(1)};
    int lit = 0;

    (void)state;
    object.material = &white;
    view.pose.translation[2] = SHEEN_Q24(-4);
    assert_int_equal(shoot(&view, &object, 1, pixels), SHEEN_OK);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        assert_true(pixels[i] == 0 || pixels[i] == 0xffff);
        lit += pixels[i] == 0xffff;
    }
    /* A ball of radius 1 at depth 4, 40 degrees: it seems asin(1/4) wide, 36 tan(asin(1/4)) / tan(20) = 25.5 px. */
    assert_in_range(lit, 1900, 2100);
}

static void steps_of_poses(void **state)
{
    struct sheen_pose a, b;

    (void)state;
    for (int64_t k = INT32_MIN, step = 1; k <= INT32_MAX; k += step) {
        const int64_t turn = (k % 360 + 360) % 360 * 4294967296;
        if (k >= -1000000000 && k <= 1000000000)
            assert_int_equal(sheen_degrees((int32_t)k), (uint32_t)((turn + 180) / 360));
        else
            assert_in_range((uint32_t)(sheen_degrees((int32_t)k) - (uint32_t)(turn / 360)), 0, 1);
        step = k >= -1000 && k < 1000 ? 1 : 9973;
    }
    for (unsigned axis = 0; axis < 3; axis++)
        for (int degrees = 0; degrees < 360; degrees += 15) {
            sheen_angle_t angle = sheen_degrees(degrees);
            memset(&a, 0, sizeof a);
            assert_int_equal(sheen_pose_rotate(&a, axis, angle), SHEEN_OK);
            sheen_pose_orbit(&b, axis == 1 ? angle : 0, axis == 0 ? angle : 0, axis == 2 ? angle : 0, 0);
            for (int k = 0; k < 9; k++)
                assert_true(abs(a.rotation[k] - b.rotation[k]) <= 16);
        }
    memset(&a, 0, sizeof a);
    assert_int_equal(sheen_pose_translate(&a, SHEEN_Q24(1), SHEEN_Q24(-2), SHEEN_Q24(3)), SHEEN_OK);
    assert_int_equal(sheen_pose_scale(&a, SHEEN_Q16(1.5)), SHEEN_OK);
    assert_int_equal(a.scale, SHEEN_Q16(1.5));
    assert_int_equal(a.translation[1], SHEEN_Q24(-3));
    b = a;
    assert_int_equal(sheen_pose_scale(&a, 0), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_pose_rotate(&a, 3, 0), SHEEN_ERR_ARGUMENT);
    assert_memory_equal(&a, &b, sizeof a);
}

/* Rows with a stride, in every format: the pixels are the same, and nothing between the rows is touched. */
static void strides(void **state)
{
    (void)state;
    for (int pixel = SHEEN_RGB565_BE; pixel <= SHEEN_GREY256; pixel++) {
        unsigned bytes = sheen_row_bytes((enum sheen_pixel)pixel, WIDTH);
        size_t stride = bytes + 6;
        uint8_t *at = malloc(stride * HEIGHT);
        struct sheen_memory memory = {.pixels = at, .stride = stride};
        struct memory_target exact;
        struct sheen_target target;
        struct sheen_config config;
        struct core_frame f;
        struct sheen_view view;
        struct sheen_object object;

        memset(at, 0xa5, stride * HEIGHT);
        assert_int_equal(sheen_memory_target(&target, &memory, WIDTH, HEIGHT, (enum sheen_pixel)pixel), SHEEN_OK);
        assert_int_equal(memory_target_init(&exact, WIDTH, HEIGHT, (enum sheen_pixel)pixel), 0);
        stage_view(&view);
        stage_draw(&stage, &ball, &object);
        for (int k = 0; k < 2; k++) {
            stage_config(&config, &exact, 1);
            config.target = k == 0 ? &target : &exact.target;
            assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
            assert_int_equal(sheen_render(f.frame, &view, &object, 1), SHEEN_OK);
            core_frame_free(&f);
        }
        for (int y = 0; y < HEIGHT; y++) {
            assert_memory_equal(at + (size_t)y * stride, exact.memory + (size_t)y * exact.row_bytes, bytes);
            assert_memory_equal(at + (size_t)y * stride + bytes, "\xa5\xa5\xa5\xa5\xa5\xa5", 6);
        }
        memory.stride = bytes - 1;
        assert_int_equal(sheen_memory_target(&target, &memory, WIDTH, HEIGHT, (enum sheen_pixel)pixel),
                         SHEEN_ERR_ARGUMENT);
        memory_target_free(&exact);
        free(at);
    }
}

/* ---- the depth that an overlay gets ---- */

struct depths {
    int drawn, empty;
    uint16_t most;
};

static void note_depths(void *ctx, const struct sheen_canvas *canvas)
{
    struct depths *d = ctx;

    for (int y = 0; y < canvas->rect.y1 - canvas->rect.y0; y++)
        for (int x = 0; x < canvas->rect.x1 - canvas->rect.x0; x++) {
            uint16_t depth = canvas->depth[(unsigned)y * canvas->pitch + (unsigned)x];
            int drawn = ((const uint16_t *)canvas->pixels)[(unsigned)y * canvas->pitch + (unsigned)x] != 0;
            assert_int_equal(drawn, depth != 257);
            d->drawn += drawn;
            d->empty += !drawn;
            d->most = depth > d->most ? depth : d->most;
        }
}

static void depth_in_overlays(void **state)
{
    static uint16_t pixels[WIDTH * HEIGHT];
    struct depths d = {0};
    const struct sheen_material white = {.base = {255, 255, 255}, .ambient = SHEEN_Q16(1)};
    const struct sheen_view view = {.z_near = SHEEN_Q24(2), .z_far = SHEEN_Q24(8), .ctx = &d, .overlay = note_depths};
    const struct sheen_object object = {.mesh = &stage.mesh[STAGE_BALL].mesh,
                                        .material = &white,
                                        .shader = &sheen_flat,
                                        .pose = {.translation = {0, 0, SHEEN_Q24(-4)}}};

    (void)state;
    assert_int_equal(shoot(&view, &object, 1, pixels), SHEEN_OK);
    assert_int_equal(d.drawn + d.empty, WIDTH * HEIGHT);
    assert_true(d.drawn > 1500);
    /* The nearest point of the ball is at m = 3, and slightly farther away where its triangles cut the curve short. */
    double nearest = 257 + 65020 * (1 / 3. - 1 / 8.) / (1 / 2. - 1 / 8.);
    assert_true(d.most <= nearest + 1 && d.most > nearest - 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_call),
        cmocka_unit_test(capacities_name_what_would_do),
        cmocka_unit_test(configurations_name_the_field),
        cmocka_unit_test(arena_at_compile_time),
        cmocka_unit_test(views_and_lights),
        cmocka_unit_test(zeros),
        cmocka_unit_test(steps_of_poses),
        cmocka_unit_test(strides),
        cmocka_unit_test(depth_in_overlays),
    };

    return cmocka_run_group_tests_name("frame_api", tests, make_stage, free_stage);
}
