/*
 * test_frame_order.c - calls in another order than begin, draw, bands, finish: what each returns, and what is sent.
 */
#include <string.h>

#include "frame_test.h"

#define SIZE 64
#define BANDS 8
#define PIXELS (SIZE * SIZE)
#define BROKEN (-77)

struct order {
    struct memory_target target;
    struct core_frame f;
    struct sheen_view view;
};

static void order_open(struct order *o, int workers, int buffers)
{
    struct sheen_config config;

    assert_int_equal(memory_target_init(&o->target, SIZE, SIZE, SHEEN_RGB565_BE), 0);
    o->target.delayed = true;
    o->target.fail_code = BROKEN;
    stage_config(&config, &o->target, 2);
    config.band_rows = SIZE / BANDS;
    config.workers = (uint8_t)workers;
    config.buffers = (uint8_t)buffers;
    assert_int_equal(core_frame_make(&o->f, &config), SHEEN_OK);
    stage_view(&o->view);
}

static void order_close(struct order *o)
{
    if (o->target.breaches > 0)
        fail_msg("%s", o->target.first_breach);
    core_frame_free(&o->f);
    memory_target_free(&o->target);
}

/* Draws a ball in the middle. */
static int draw_ball(struct order *o)
{
    const struct actor ball = {STAGE_BALL, 0, SHEEN_FLAT, 0, 0, 5, 1, 0, 0};
    struct sheen_object draw;

    stage_draw(&stage, &ball, &draw);
    return sheen_draw(o->f.frame, &draw);
}

static void begin(struct order *o)
{
    memory_target_begin(&o->target);
    assert_int_equal(sheen_begin(o->f.frame, &o->view), SHEEN_OK);
}

/* Draws a whole frame without errors; returns the number of pixels sent. */
static long frame_area(struct order *o)
{
    begin(o);
    assert_int_equal(draw_ball(o), SHEEN_OK);
    assert_int_equal(sheen_end(o->f.frame), SHEEN_OK);
    assert_int_equal(sheen_wait(o->f.frame), SHEEN_OK);
    return o->target.area;
}

/* The first frame sends everything; the second one only the ball. */
static void settle(struct order *o)
{
    assert_int_equal(frame_area(o), PIXELS);
    assert_true(frame_area(o) < PIXELS / 2);
}

/* A wait that fails between bands sets the frame's error. */
static void wait_between_bands(void **state)
{
    struct order o = {0};
    long sent;

    (void)state;
    order_open(&o, 1, 1);
    settle(&o);
    begin(&o);
    assert_int_equal(draw_ball(&o), SHEEN_OK);
    for (unsigned b = 0; b < 4; b++)
        assert_int_equal(sheen_band(o.f.frame, 0, b), SHEEN_OK);
    assert_true(o.target.in_flight);
    o.target.fail_wait = 1;
    assert_int_equal(sheen_wait(o.f.frame), BROKEN);
    sent = o.target.pushes;
    for (unsigned b = 4; b < BANDS; b++)
        assert_int_equal(sheen_band(o.f.frame, 0, b), BROKEN);
    assert_int_equal(o.target.pushes, sent);
    assert_int_equal(sheen_finish(o.f.frame), BROKEN);
    assert_int_equal(sheen_wait(o.f.frame), SHEEN_OK);
    assert_int_equal(frame_area(&o), PIXELS);
    order_close(&o);
}

/* Workers take turns on one thread: one push at a time, and none after an error of another worker. */
static void workers_in_turn(void **state)
{
    (void)state;
    for (int buffers = 1; buffers <= 2; buffers++) {
        struct order o = {0};
        order_open(&o, 2, buffers);
        for (int frame = 0; frame < 3; frame++) {
            begin(&o);
            assert_int_equal(draw_ball(&o), SHEEN_OK);
            o.target.fail_push = frame == 1 ? 2 : 0;
            sheen_invalidate(o.f.frame);
            for (unsigned b = 0; b < BANDS; b++)
                (void)sheen_band(o.f.frame, b & 1, b);
            assert_int_equal(sheen_finish(o.f.frame), frame == 1 ? BROKEN : SHEEN_OK);
            assert_int_equal(o.target.pushes, frame == 1 ? 1 : BANDS);
            assert_int_equal(sheen_wait(o.f.frame), SHEEN_OK);
        }
        order_close(&o);
    }
}

static void fill(void *ctx, const struct sheen_canvas *canvas)
{
    unsigned rows = (unsigned)(canvas->rect.y1 - canvas->rect.y0);

    memset(canvas->pixels, *(const uint8_t *)ctx, 2u * canvas->pitch * rows);
}

/* An underlay counts as background: if it or its ctx changes, everything is sent again. */
static void another_underlay(void **state)
{
    uint8_t one = 1, two = 2;
    struct order o = {0};

    (void)state;
    order_open(&o, 1, 1);
    settle(&o);
    o.view.ctx = &one; /* not passed to anybody, as there is no callback */
    assert_true(frame_area(&o) < PIXELS / 2);
    o.view.underlay = fill;
    assert_int_equal(frame_area(&o), PIXELS);
    assert_true(frame_area(&o) < PIXELS / 2);
    o.view.ctx = &two;
    assert_int_equal(frame_area(&o), PIXELS);
    assert_int_equal(memory_target_pixel(&o.target, 0, 0), 0x0202);
    o.view.underlay = NULL;
    assert_int_equal(frame_area(&o), PIXELS);
    o.view.overlay = fill;
    assert_int_equal(frame_area(&o), PIXELS);
    assert_true(frame_area(&o) < PIXELS / 2);
    order_close(&o);
}

/* A band that is drawn twice is refused; it does not make up for one that is left out. */
static void band_twice(void **state)
{
    struct order o = {0};

    (void)state;
    order_open(&o, 1, 1);
    begin(&o);
    assert_int_equal(draw_ball(&o), SHEEN_OK);
    for (unsigned b = 1; b < BANDS; b++)
        assert_int_equal(sheen_band(o.f.frame, 0, b), SHEEN_OK);
    assert_int_equal(sheen_band(o.f.frame, 0, 1), SHEEN_ERR_STATE);
    assert_int_equal(o.target.pushes, BANDS - 1);
    assert_int_equal(sheen_finish(o.f.frame), SHEEN_OK);
    assert_int_equal(frame_area(&o), PIXELS);
    assert_true(frame_area(&o) < PIXELS / 2);

    begin(&o); /* sheen_end() draws the bands that are left */
    assert_int_equal(draw_ball(&o), SHEEN_OK);
    sheen_invalidate(o.f.frame); /* affects the frame after this one */
    assert_int_equal(sheen_band(o.f.frame, 0, 4), SHEEN_OK);
    assert_int_equal(sheen_end(o.f.frame), SHEEN_OK);
    assert_int_equal(sheen_wait(o.f.frame), SHEEN_OK);
    for (int i = 0; i < PIXELS; i++)
        assert_true(o.target.times[i] <= 1);
    assert_int_equal(frame_area(&o), PIXELS);
    order_close(&o);
}

/* sheen_bands() draws all bands that are left, each once, whichever worker comes first. */
static void shares_of_bands(void **state)
{
    (void)state;
    for (unsigned workers = 1; workers <= 4; workers++) {
        for (unsigned first = 0; first < workers; first++) {
            struct order o = {0};
            order_open(&o, (int)workers, 1);
            assert_int_equal(sheen_bands(o.f.frame, 0), SHEEN_ERR_STATE); /* no frame has begun */
            begin(&o);
            assert_int_equal(draw_ball(&o), SHEEN_OK);
            assert_int_equal(sheen_bands(o.f.frame, workers), SHEEN_ERR_ARGUMENT);
            assert_int_equal(sheen_band(o.f.frame, 0, 3), SHEEN_OK);
            assert_int_equal(sheen_bands(o.f.frame, first), SHEEN_OK);
            assert_int_equal(o.target.pushes, BANDS);
            for (unsigned worker = 0; worker < workers; worker++)
                assert_int_equal(sheen_bands(o.f.frame, worker), SHEEN_OK);
            assert_int_equal(o.target.pushes, BANDS);
            assert_int_equal(sheen_finish(o.f.frame), SHEEN_OK);
            assert_int_equal(sheen_wait(o.f.frame), SHEEN_OK);
            assert_int_equal(o.target.area, PIXELS);
            assert_true(frame_area(&o) < PIXELS / 2); /* no band was left out */
            begin(&o);
            assert_int_equal(draw_ball(&o), SHEEN_OK);
            o.target.fail_push = 2;
            assert_int_equal(sheen_bands(o.f.frame, first), BROKEN);
            assert_int_equal(sheen_bands(o.f.frame, 0), BROKEN);
            assert_int_equal(o.target.pushes, 1);
            assert_int_equal(sheen_finish(o.f.frame), BROKEN);
            order_close(&o);
        }
    }
}

/* An error code of the target that equals the code for a band already done ends the frame as any other does. */
static void error_like_a_done_band(void **state)
{
    struct order o = {0};

    (void)state;
    order_open(&o, 2, 1);
    o.target.fail_code = SHEEN_ERR_STATE;
    begin(&o);
    assert_int_equal(draw_ball(&o), SHEEN_OK);
    o.target.fail_push = BANDS / 2;
    assert_int_equal(sheen_bands(o.f.frame, 0), SHEEN_ERR_STATE);
    assert_int_equal(sheen_bands(o.f.frame, 1), SHEEN_ERR_STATE);
    assert_int_equal(o.target.pushes, BANDS / 2 - 1);
    assert_int_equal(sheen_finish(o.f.frame), SHEEN_ERR_STATE);
    order_close(&o);
}

/* Nothing can be added after the first band, and what a failed frame left pending is not drawn. */
static void nothing_after_a_band(void **state)
{
    struct order o = {0};

    (void)state;
    order_open(&o, 1, 1);
    begin(&o);
    assert_int_equal(draw_ball(&o), SHEEN_OK);
    assert_int_equal(draw_ball(&o), SHEEN_OK);
    o.target.fail_push = 4;
    assert_int_equal(sheen_end(o.f.frame), BROKEN);
    begin(&o);
    assert_int_equal(sheen_mark(o.f.frame, (struct sheen_rect){0, 0, 8, 8}), SHEEN_OK);
    assert_int_equal(sheen_band(o.f.frame, 0, BANDS), SHEEN_ERR_ARGUMENT); /* no such band: the frame stays open */
    assert_int_equal(draw_ball(&o), SHEEN_OK);
    for (unsigned b = 0; b < 3; b++)
        assert_int_equal(sheen_band(o.f.frame, 0, b), SHEEN_OK);
    assert_int_equal(draw_ball(&o), SHEEN_ERR_STATE);
    assert_int_equal(sheen_mark(o.f.frame, (struct sheen_rect){0, 0, 8, 8}), SHEEN_ERR_STATE);
    assert_int_equal(sheen_begin(o.f.frame, &o.view), SHEEN_ERR_STATE);
    assert_int_equal(sheen_end(o.f.frame), SHEEN_OK);
    assert_int_equal(sheen_end(o.f.frame), SHEEN_ERR_STATE);
    order_close(&o);
}

/* Callbacks may return positive results, which are successes, also when sheen_begin() waits for them. */
static int generous(void *ctx)
{
    (void)ctx;
    return 5;
}

static void results_above_zero(void **state)
{
    struct order o = {0};

    (void)state;
    order_open(&o, 1, 1);
    o.target.delayed = false;
    o.target.target.wait = generous;
    assert_int_equal(frame_area(&o), PIXELS);
    begin(&o);
    assert_int_equal(draw_ball(&o), SHEEN_OK);
    assert_int_equal(sheen_end(o.f.frame), SHEEN_OK);
    o.view.fov = 1;
    assert_int_equal(sheen_begin(o.f.frame, &o.view), SHEEN_ERR_ARGUMENT);
    order_close(&o);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wait_between_bands),   cmocka_unit_test(workers_in_turn),
        cmocka_unit_test(another_underlay),     cmocka_unit_test(band_twice),
        cmocka_unit_test(nothing_after_a_band), cmocka_unit_test(results_above_zero),
        cmocka_unit_test(shares_of_bands),      cmocka_unit_test(error_like_a_done_band),
    };

    return cmocka_run_group_tests_name("frame_order", tests, make_stage, free_stage);
}
