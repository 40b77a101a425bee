/*
 * test_frame_equal.c - the pixels are the same whatever the bands, buffers, workers and order, compared with each frame
 * drawn whole in one band.
 */
#include <stdio.h>
#include <string.h>

#include "frame_test.h"

#define WIDTH 160
#define HEIGHT 120
#define FRAMES 3

/* Objects that intersect each other or leave the picture, and one that the near plane cuts; every shading. */
static int cast(struct actor actors[5], int frame)
{
    double t = frame;

    actors[0] = (struct actor){STAGE_TORUS, 0, SHEEN_PHONG, -0.4 + 0.2 * t, 0.2, 4, 1.3, 40 * t, 50};
    actors[1] = (struct actor){STAGE_BALL, 1, SHEEN_GOURAUD, 0.5, -0.2 * t, 3.5, 0.8, 30 * t, 20};
    actors[2] = (struct actor){STAGE_CUBE, 2, SHEEN_FLAT, 1.6, 1 - 0.4 * t, 4.5, 0.9, 25 + 20 * t, 35};
    actors[3] = (struct actor){STAGE_BALL, 2, SHEEN_SLERP, -1.3, -0.7, 3.2 - 0.1 * t, 0.6, 0, 90};
    actors[4] = (struct actor){STAGE_TORUS, 1, SHEEN_GOURAUD, 0.3, 0.6, 1.3, 0.5, 60 * t, 80};
    return 5;
}

/* How the bands of a frame are drawn. */
enum order {
    BY_END,
    FORWARD,
    BACKWARD,
    ALTERNATING,
    HALVES
};

static int run_bands(struct sheen_frame *frame, enum order order, unsigned workers)
{
    unsigned count = sheen_band_count(frame);

    for (unsigned i = 0; i < count; i++) {
        unsigned band = order == BACKWARD ? count - 1 - i : i;
        unsigned worker = order == ALTERNATING ? i % workers : order == HALVES ? (2 * i >= count) % workers : 0;
        int status = sheen_band(frame, worker, band);
        if (status < 0)
            return status;
    }
    return sheen_finish(frame);
}

static int run_frame(struct sheen_frame *frame, const struct sheen_view *view, int number, enum order order,
                     unsigned workers)
{
    struct actor actors[5];
    int count = cast(actors, number), status = sheen_begin(frame, view);

    for (int i = 0; i < count && status == SHEEN_OK; i++) {
        struct sheen_object draw;
        stage_draw(&stage, &actors[i], &draw);
        draw.two_sided = i == 4;
        status = sheen_draw(frame, &draw);
    }
    if (status == SHEEN_OK)
        status = order == BY_END ? sheen_end(frame) : run_bands(frame, order, workers);
    return status == SHEEN_OK ? sheen_wait(frame) : status;
}

/* How frames are drawn and sent. */
struct settings {
    int band_rows, buffers, workers, carried;
    enum order order;
    bool delayed;
};

/* Draws FRAMES pictures, one after the other. */
static void run(uint8_t *pictures, const struct settings *settings, enum sheen_pixel pixel, bool affine)
{
    struct memory_target target;
    struct sheen_config config;
    struct core_frame f;
    struct sheen_view view;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, pixel), 0);
    target.delayed = settings->delayed;
    stage_config(&config, &target, 5);
    config.max_clipped = 500;
    config.band_rows = (uint16_t)settings->band_rows;
    config.buffers = (uint8_t)settings->buffers;
    config.workers = (uint8_t)settings->workers;
    config.max_carried = (uint16_t)settings->carried;
    stage_view(&view);
    view.affine = affine;
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    for (int i = 0; i < FRAMES; i++) {
        memory_target_begin(&target);
        int status = run_frame(f.frame, &view, i, settings->order, (unsigned)settings->workers);
        if (status != SHEEN_OK)
            fail_msg("frame %d: %s", i, sheen_strerror(status));
        memcpy(pictures + (size_t)i * HEIGHT * target.row_bytes, target.memory, HEIGHT * target.row_bytes);
    }
    if (target.breaches > 0)
        fail_msg("%s", target.first_breach);
    core_frame_free(&f);
    memory_target_free(&target);
}

static uint8_t expected[FRAMES * HEIGHT * WIDTH * 2], got[FRAMES * HEIGHT * WIDTH * 2];

static void compare(const struct settings *settings, enum sheen_pixel pixel, bool affine)
{
    size_t bytes = (size_t)FRAMES * HEIGHT * sheen_row_bytes(pixel, WIDTH), differing = 0;

    memset(got, 0x5a, sizeof got);
    run(got, settings, pixel, affine);
    for (size_t i = 0; i < bytes; i++)
        differing += expected[i] != got[i];
    if (differing > 0)
        fail_msg("bands of %d rows, %d buffers, %d workers, %d carried, order %d, %s: %zu bytes differ",
                 settings->band_rows, settings->buffers, settings->workers, settings->carried, (int)settings->order,
                 settings->delayed ? "delayed" : "at once", differing);
}

static const struct settings whole = {.band_rows = HEIGHT, .buffers = 1, .workers = 1};

static void bands_and_buffers(void **state)
{
    static const int rows[] = {1, 2, 7, 16, 119, HEIGHT};

    (void)state;
    for (int affine = 0; affine < 2; affine++) {
        run(expected, &whole, SHEEN_RGB565_BE, affine);
        for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
            for (int k = 0; k < 4; k++) {
                struct settings settings = {.band_rows = rows[i], .buffers = 1 + k % 2, .workers = 1, .delayed = k / 2};
                compare(&settings, SHEEN_RGB565_BE, affine);
            }
        }
    }
}

/* Room for one carried set-up, for a few, and for more than are ever needed. */
static void carried(void **state)
{
    static const int room[] = {1, 2, 5, 254};

    (void)state;
    run(expected, &whole, SHEEN_RGB565_BE, false);
    for (size_t i = 0; i < sizeof room / sizeof *room; i++) {
        for (int rows = 1; rows <= 16; rows *= 4) {
            struct settings settings = {.band_rows = rows, .buffers = 1, .workers = 1, .carried = room[i]};
            compare(&settings, SHEEN_RGB565_BE, false);
        }
    }
}

/* The counters of a frame in bands of so many rows with room for so many carried set-ups. */
static struct sheen_stats counted(int rows, uint32_t room)
{
    struct memory_target target;
    struct sheen_config config;
    struct core_frame f;
    struct sheen_view view;
    struct sheen_stats stats;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 5);
    config.max_clipped = 500;
    config.band_rows = (uint16_t)rows;
    config.max_carried = (uint16_t)room;
    stage_view(&view);
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    assert_int_equal(run_frame(f.frame, &view, 0, BY_END, 1), SHEEN_OK);
    sheen_frame_stats(f.frame, &stats);
    core_frame_free(&f);
    memory_target_free(&target);
    return stats;
}

/*
 * If all set-ups can be carried, each triangle is set up once, however many bands it crosses. The counters say for how
 * many there has to be room: with one less there are more set-ups.
 */
static void set_up_once(void **state)
{
    static const int rows[] = {16, 7, 1};
    const struct sheen_stats once = counted(HEIGHT, 254);

    (void)state;
    assert_true(once.setups > 300);
    assert_int_equal(once.carried, 1); /* the least that there can be room for */
    for (int i = 0; i < 3; i++) {
        const struct sheen_stats all = counted(rows[i], 254), enough = counted(rows[i], all.carried),
                                 few = counted(rows[i], all.carried - 1);
        assert_int_equal(all.setups, once.setups);
        assert_int_equal(enough.setups, once.setups);
        assert_int_equal(enough.carried, all.carried);
        assert_true(few.setups > once.setups);
        assert_int_equal(few.carried, all.carried);
    }
}

static void orders_and_workers(void **state)
{
    (void)state;
    run(expected, &whole, SHEEN_RGB565_BE, false);
    for (int order = FORWARD; order <= HALVES; order++) {
        for (int workers = 1; workers <= 4; workers++) {
            for (int rows = 1; rows <= 16; rows += 5) {
                struct settings settings = {
                    .band_rows = rows, .buffers = 1, .workers = workers, .order = (enum order)order};
                compare(&settings, SHEEN_RGB565_BE, false);
                settings.carried = 3;
                compare(&settings, SHEEN_RGB565_BE, false);
            }
        }
    }
}

/* Both byte orders hold the same 565 values. */
static void byte_orders(void **state)
{
    static const struct settings banded = {.band_rows = 16, .buffers = 2, .workers = 1};

    (void)state;
    run(expected, &whole, SHEEN_RGB565_BE, false);
    run(got, &banded, SHEEN_RGB565_LE, false);
    for (size_t i = 0; i < sizeof got; i += 2) {
        assert_int_equal(expected[i], got[i + 1]);
        assert_int_equal(expected[i + 1], got[i]);
    }
}

/* Guards against empty pictures, which would be equal too. */
static void something_is_drawn(void **state)
{
    (void)state;
    run(expected, &whole, SHEEN_RGB565_BE, false);
    for (int f = 0; f < FRAMES; f++) {
        size_t at = (size_t)f * WIDTH * HEIGHT * 2, lit = 0;
        for (size_t i = 0; i < WIDTH * HEIGHT; i++)
            lit += expected[at + 2 * i] != 0 || expected[at + 2 * i + 1] != 4;
        assert_true(lit > WIDTH * HEIGHT / 4 && lit < WIDTH * HEIGHT);
        if (f > 0)
            assert_memory_not_equal(expected + at, expected + at - WIDTH * HEIGHT * 2, WIDTH * HEIGHT * 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(something_is_drawn), cmocka_unit_test(bands_and_buffers),  cmocka_unit_test(carried),
        cmocka_unit_test(set_up_once),        cmocka_unit_test(orders_and_workers), cmocka_unit_test(byte_orders),
    };

    return cmocka_run_group_tests_name("frame_equal", tests, make_stage, free_stage);
}
