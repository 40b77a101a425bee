/*
 * test_frame_changed.c - only what changed is sent, and the panel still shows the whole picture.
 *
 * Every picture is drawn twice: by a frame that sends only what changed to the target that it drew on before, and by
 * one that sends everything. Both targets must then be equal, also after pushes or waits that failed.
 */
#include <stdio.h>
#include <string.h>

#include "frame_show.h"
#include "frame_test.h"

/* Outside the viewport the panel belongs to others, so both targets must keep what they had there. */
static void assert_same_glass(const struct memory_target *a, const struct memory_target *b, struct sheen_rect r,
                              int frame)
{
    if (r.x0 >= r.x1 || r.y0 >= r.y1)
        r = (struct sheen_rect){0, 0, SHOW_WIDTH, SHOW_HEIGHT};
    for (int y = r.y0; y < r.y1; y++) {
        for (int x = r.x0; x < r.x1; x++) {
            if (memory_target_pixel(a, x, y) != memory_target_pixel(b, x, y))
                fail_msg("frame %d: (%d, %d) shows %04x, a full redraw %04x", frame, x, y, memory_target_pixel(a, x, y),
                         memory_target_pixel(b, x, y));
        }
    }
}

static long viewport_area(struct sheen_rect r)
{
    return r.x0 >= r.x1 || r.y0 >= r.y1 ? SHOW_WIDTH * SHOW_HEIGHT : (long)(r.x1 - r.x0) * (r.y1 - r.y0);
}

/* Counters agree with what arrived; no pixel was sent twice. If `all`, the whole viewport must have been sent. */
static void check_counts(const struct memory_target *t, struct sheen_frame *frame, const struct show *s, bool all,
                         int number)
{
    struct sheen_stats stats;

    sheen_frame_stats(frame, &stats);
    assert_int_equal(stats.rectangles, t->pushes);
    assert_int_equal(stats.pixels, t->area);
    assert_int_equal(t->bytes, 2 * t->area);
    for (int i = 0; i < SHOW_WIDTH * SHOW_HEIGHT; i++)
        assert_true(t->times[i] <= 1);
    if (all && t->area < viewport_area(s->view.viewport))
        fail_msg("frame %d: %ld px sent where all had to be", number, t->area);
}

struct pair {
    struct memory_target changed, full;
    struct core_frame changed_frame, full_frame;
};

static void open_pair(struct pair *p, const struct show_settings *settings)
{
    struct sheen_config config;

    assert_int_equal(memory_target_init(&p->changed, SHOW_WIDTH, SHOW_HEIGHT, settings->pixel), 0);
    assert_int_equal(memory_target_init(&p->full, SHOW_WIDTH, SHOW_HEIGHT, settings->pixel), 0);
    p->changed.delayed = settings->delayed;
    p->changed.target.align_x = (uint8_t)settings->align_x;
    p->changed.target.align_y = (uint8_t)settings->align_y;
    stage_config(&config, &p->changed, SHOW_ACTORS);
    config.max_clipped = 2000;
    config.band_rows = (uint16_t)settings->band_rows;
    config.buffers = (uint8_t)settings->buffers;
    assert_int_equal(core_frame_make(&p->changed_frame, &config), SHEEN_OK);
    config.target = &p->full.target;
    assert_int_equal(core_frame_make(&p->full_frame, &config), SHEEN_OK);
}

static void close_pair(struct pair *p)
{
    if (p->changed.breaches > 0)
        fail_msg("%s", p->changed.first_breach);
    assert_int_equal(p->full.breaches, 0);
    core_frame_free(&p->changed_frame);
    core_frame_free(&p->full_frame);
    memory_target_free(&p->changed);
    memory_target_free(&p->full);
}

/*
 * Plays a frame on the target that gets only what changed, with a failure injected at some push or wait. Returns true
 * if that failure occurred; its code must then reach the caller unchanged, from the frame's calls or from sheen_wait().
 */
static bool play_with_failure(struct pair *p, struct show *s, uint32_t *seed)
{
    long countdown = 1 + (long)(stage_random(seed) % 8);

    if (p->changed.delayed && stage_random(seed) % 2)
        p->changed.fail_wait = countdown;
    else
        p->changed.fail_push = countdown;
    p->changed.fail_code = -1000 - (int)(stage_random(seed) % 1000);
    int status = show_play(p->changed_frame.frame, &stage, s);
    if (status == SHEEN_OK)
        status = sheen_wait(p->changed_frame.frame);
    bool came = p->changed.fail_push == 0 && p->changed.fail_wait == 0;
    p->changed.fail_push = p->changed.fail_wait = 0;
    assert_int_equal(status, came ? p->changed.fail_code : SHEEN_OK);
    return came;
}

static void play_show(const struct show_settings *settings, int frames, uint32_t seed)
{
    struct pair p;
    struct show s = {.painter.pixel = settings->pixel};
    long sent = 0, whole = 0;
    int failures = 0;
    bool all = true;

    open_pair(&p, settings);
    stage_view(&s.view);
    s.view.ctx = &s.painter;
    s.view.underlay = settings->underlay ? show_underlay : NULL;
    s.view.overlay = settings->overlay ? show_overlay : NULL;
    for (int i = 0; i < SHOW_ACTORS; i++)
        show_enter(&s.actors[i], &seed);
    for (int i = 0; i < frames; i++) {
        show_change(&s, settings, &seed);
        all |= s.viewport_changed || s.background_changed;
        memory_target_begin(&p.changed);
        if (settings->failures && stage_random(&seed) % 4 == 0 && play_with_failure(&p, &s, &seed)) {
            failures++;
            all = true;
            continue;
        }
        if (!settings->failures || p.changed.pushes == 0) {
            assert_int_equal(show_play(p.changed_frame.frame, &stage, &s), SHEEN_OK);
            assert_int_equal(sheen_wait(p.changed_frame.frame), SHEEN_OK);
        }
        sheen_invalidate(p.full_frame.frame);
        assert_int_equal(show_play(p.full_frame.frame, &stage, &s), SHEEN_OK);
        check_counts(&p.changed, p.changed_frame.frame, &s, all, i);
        assert_same_glass(&p.changed, &p.full, s.view.viewport, i);
        all = false;
        sent += p.changed.area;
        whole += viewport_area(s.view.viewport);
    }
    print_message("  sent %.1f %% of the pixels, %d frames broken off\n", 100.0 * (double)sent / (double)whole,
                  failures);
    assert_true(sent < whole * 3 / 4);
    assert_true(failures > 0 || !settings->failures);
    close_pair(&p);
}

static void at_once(void **state)
{
    (void)state;
    play_show(&(struct show_settings){.pixel = SHEEN_RGB565_BE, .band_rows = 16, .buffers = 1}, 200, 1);
}

static void bands_of_all_heights(void **state)
{
    static const int rows[] = {1, 7, SHOW_HEIGHT};

    (void)state;
    for (uint32_t i = 0; i < 3; i++)
        play_show(
            &(struct show_settings){.pixel = SHEEN_RGB565_LE, .band_rows = rows[i], .buffers = 2, .delayed = true}, 200,
            5 + i);
}

static void with_own_2d(void **state)
{
    (void)state;
    for (int buffers = 1; buffers <= 2; buffers++) {
        play_show(&(struct show_settings){.pixel = SHEEN_RGB565_BE,
                                          .band_rows = 16,
                                          .buffers = buffers,
                                          .delayed = buffers == 2,
                                          .underlay = true,
                                          .overlay = true},
                  200, 11);
    }
}

static void aligned_rectangles(void **state)
{
    (void)state;
    play_show(
        &(struct show_settings){.pixel = SHEEN_RGB565_BE, .band_rows = 12, .buffers = 1, .align_x = 8, .align_y = 4},
        200, 21);
    play_show(
        &(struct show_settings){
            .pixel = SHEEN_RGB565_BE, .band_rows = 5, .buffers = 2, .align_x = 16, .align_y = 8, .overlay = true},
        200, 22);
}

static void after_failures(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        play_show(&(struct show_settings){.pixel = SHEEN_RGB565_BE,
                                          .band_rows = k % 2 ? 16 : 7,
                                          .buffers = 1 + k / 2,
                                          .delayed = k > 0,
                                          .overlay = true,
                                          .failures = true},
                  200, (uint32_t)(31 + k));
    }
}

/* A still picture is sent once, a place that an object left is cleared once, a mark is sent as it is. */
static void nothing_more_than_changed(void **state)
{
    struct show_settings settings = {.pixel = SHEEN_RGB565_BE, .band_rows = SHOW_HEIGHT, .buffers = 1};
    struct pair p;
    struct show s = {.on = {true}};
    struct sheen_rect mark = {20, 30, 33, 47};

    (void)state;
    open_pair(&p, &settings);
    stage_view(&s.view);
    s.actors[0] = (struct actor){STAGE_BALL, 0, SHEEN_PHONG, 0, 0, 5, 1, 0, 0};
    assert_int_equal(show_play(p.changed_frame.frame, &stage, &s), SHEEN_OK);
    assert_int_equal(p.changed.area, SHOW_WIDTH * SHOW_HEIGHT);

    /* The ball of radius 1 at depth 5: 1 / sqrt(24) * 60 / tan(25 degrees) = 26.3 px around the centre. */
    memory_target_begin(&p.changed);
    assert_int_equal(show_play(p.changed_frame.frame, &stage, &s), SHEEN_OK);
    assert_in_range(p.changed.area, 48 * 48, 54 * 54);
    assert_int_equal(p.changed.pushes, 1);
    for (int frame = 0; frame < 2; frame++) { /* the ball leaves: its place is cleared once, then nothing is sent */
        s.on[0] = false;
        memory_target_begin(&p.changed);
        assert_int_equal(show_play(p.changed_frame.frame, &stage, &s), SHEEN_OK);
        assert_int_equal(p.changed.pushes, frame == 0);
    }
    memory_target_begin(&p.changed);
    assert_int_equal(sheen_begin(p.changed_frame.frame, &s.view), SHEEN_OK);
    assert_int_equal(sheen_mark(p.changed_frame.frame, mark), SHEEN_OK);
    assert_int_equal(sheen_end(p.changed_frame.frame), SHEEN_OK);
    assert_int_equal(p.changed.pushes, 1);
    assert_int_equal(p.changed.area, 13 * 17);
    assert_int_equal(p.changed.times[30 * SHOW_WIDTH + 20] + p.changed.times[46 * SHOW_WIDTH + 32], 2);
    sheen_invalidate(p.changed_frame.frame);
    memory_target_begin(&p.changed);
    assert_int_equal(show_play(p.changed_frame.frame, &stage, &s), SHEEN_OK);
    assert_int_equal(p.changed.area, SHOW_WIDTH * SHOW_HEIGHT);
    close_pair(&p);
}

/* The last push of a frame fails in flight: the next begin returns the error, the frame after that sends everything. */
static void error_in_flight(void **state)
{
    struct show_settings settings = {.pixel = SHEEN_RGB565_BE, .band_rows = 16, .buffers = 1, .delayed = true};
    struct pair p;
    struct show s = {.on = {true}};

    (void)state;
    open_pair(&p, &settings);
    stage_view(&s.view);
    s.actors[0] = (struct actor){STAGE_BALL, 0, SHEEN_PHONG, 0, 0, 5, 1, 0, 0};
    assert_int_equal(show_play(p.changed_frame.frame, &stage, &s), SHEEN_OK);
    assert_int_equal(sheen_wait(p.changed_frame.frame), SHEEN_OK);
    memory_target_begin(&p.changed);
    assert_int_equal(show_play(p.changed_frame.frame, &stage, &s), SHEEN_OK);
    assert_true(p.changed.in_flight); /* the last of the second frame's rectangles has not been waited for */
    p.changed.fail_wait = 1;
    p.changed.fail_code = -1234;
    assert_int_equal(show_play(p.changed_frame.frame, &stage, &s), -1234);
    memory_target_begin(&p.changed);
    assert_int_equal(show_play(p.changed_frame.frame, &stage, &s), SHEEN_OK);
    assert_int_equal(sheen_wait(p.changed_frame.frame), SHEEN_OK);
    assert_int_equal(p.changed.area, SHOW_WIDTH * SHOW_HEIGHT);
    close_pair(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_more_than_changed), cmocka_unit_test(at_once),
        cmocka_unit_test(bands_of_all_heights),      cmocka_unit_test(with_own_2d),
        cmocka_unit_test(aligned_rectangles),        cmocka_unit_test(after_failures),
        cmocka_unit_test(error_in_flight),
    };

    return cmocka_run_group_tests_name("frame_changed", tests, make_stage, free_stage);
}
