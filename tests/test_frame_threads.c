/*
 * test_frame_threads.c - the bands of a frame on two threads, each a worker of its own.
 *
 * Meant for the thread sanitizer, which sees any store that both touch.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>
#include <pthread.h>

#include "frame_stage.h"

#define WIDTH 160
#define HEIGHT 120
#define WORKERS 2
#define FRAMES 8

static struct stage stage;

static int make_stage(void **state)
{
    (void)state;
    return stage_make(&stage);
}

static int free_stage(void **state)
{
    (void)state;
    stage_free(&stage);
    return 0;
}

/* One bus for all: a push goes through a lock. */
struct bus {
    struct memory_target memory;
    struct sheen_target target;
    pthread_mutex_t lock;
};

static int locked_push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    struct bus *bus = ctx;

    pthread_mutex_lock(&bus->lock);
    int status = bus->memory.target.push(&bus->memory, rect, pixels);
    pthread_mutex_unlock(&bus->lock);
    return status;
}

static void bus_open(struct bus *bus)
{
    assert_int_equal(memory_target_init(&bus->memory, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    bus->target = bus->memory.target;
    bus->target.ctx = bus;
    bus->target.push = locked_push;
    bus->target.wait = NULL;
    pthread_mutex_init(&bus->lock, NULL);
}

static void bus_close(struct bus *bus)
{
    assert_int_equal(bus->memory.breaches, 0);
    pthread_mutex_destroy(&bus->lock);
    memory_target_free(&bus->memory);
}

/* How the bands are dealt out: every other one, by halves, or each to who comes first. */
enum deal {
    EVERY_OTHER,
    HALVES,
    FIRST_COME,
    DEALS
};

struct job {
    struct sheen_frame *frame;
    unsigned worker;
    enum deal deal;
    pthread_mutex_t *lock;
    unsigned *next;
    int status;
};

static int take_band(struct job *job, unsigned count)
{
    pthread_mutex_lock(job->lock);
    unsigned band = (*job->next)++;
    pthread_mutex_unlock(job->lock);
    return band < count ? (int)band : -1;
}

static void *work(void *argument)
{
    struct job *job = argument;
    unsigned count = sheen_band_count(job->frame);

    if (job->deal == FIRST_COME) {
        for (int band = take_band(job, count); band >= 0 && job->status == SHEEN_OK; band = take_band(job, count))
            job->status = sheen_band(job->frame, job->worker, (unsigned)band);
        return NULL;
    }
    for (unsigned band = 0; band < count && job->status == SHEEN_OK; band++) {
        if ((job->deal == EVERY_OTHER ? band % WORKERS : band * WORKERS / count) == job->worker)
            job->status = sheen_band(job->frame, job->worker, band);
    }
    return NULL;
}

static int run_bands(struct sheen_frame *frame, enum deal deal)
{
    pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    pthread_t thread[WORKERS];
    struct job job[WORKERS];
    unsigned next = 0;

    for (unsigned w = 0; w < WORKERS; w++) {
        job[w] = (struct job){frame, w, deal, &lock, &next, SHEEN_OK};
        assert_int_equal(pthread_create(&thread[w], NULL, work, &job[w]), 0);
    }
    for (unsigned w = 0; w < WORKERS; w++)
        assert_int_equal(pthread_join(thread[w], NULL), 0);
    for (unsigned w = 0; w < WORKERS; w++)
        assert_int_equal(job[w].status, SHEEN_OK);
    return sheen_finish(frame);
}

static void draw_all(struct sheen_frame *frame, const struct sheen_view *view, int number)
{
    const struct actor actors[3] = {
        {STAGE_TORUS, 0, SHEEN_PHONG, -0.5 + 0.1 * number, 0.2, 4, 1.3, 20.0 * number, 50},
        {STAGE_BALL, 1, SHEEN_SLERP, 0.5, -0.1 * number, 3.5, 0.8, 30, 20},
        {STAGE_CUBE, 2, SHEEN_FLAT, 1.6, 1 - 0.2 * number, 4.5, 0.9, 25, 35},
    };

    assert_int_equal(sheen_begin(frame, view), SHEEN_OK);
    for (int i = 0; i < 3; i++) {
        struct sheen_draw draw;
        stage_draw(&stage, &actors[i], &draw);
        assert_int_equal(sheen_draw(frame, &draw), SHEEN_OK);
    }
}

static void play(int band_rows, int buffers, enum deal deal)
{
    struct bus one, two;
    struct core_frame alone, shared;
    struct sheen_config config;
    struct sheen_view view;

    bus_open(&one);
    bus_open(&two);
    stage_config(&config, &one.memory, 3);
    config.target = &one.target;
    assert_int_equal(core_frame_make(&alone, &config), SHEEN_OK);
    config.target = &two.target;
    config.band_rows = (uint16_t)band_rows;
    config.buffers = (uint8_t)buffers;
    config.workers = WORKERS;
    assert_int_equal(core_frame_make(&shared, &config), SHEEN_OK);
    stage_view(&view);
    for (int i = 0; i < FRAMES; i++) {
        draw_all(alone.frame, &view, i);
        assert_int_equal(sheen_end(alone.frame), SHEEN_OK);
        draw_all(shared.frame, &view, i);
        assert_int_equal(run_bands(shared.frame, deal), SHEEN_OK);
        assert_memory_equal(one.memory.memory, two.memory.memory, HEIGHT * one.memory.row_bytes);
    }
    core_frame_free(&alone);
    core_frame_free(&shared);
    bus_close(&one);
    bus_close(&two);
}

static void two_workers(void **state)
{
    static const int rows[] = {1, 7, 16, 60};

    (void)state;
    for (int i = 0; i < 4; i++) {
        for (int deal = 0; deal < DEALS; deal++) {
            play(rows[i], 1, (enum deal)deal);
            play(rows[i], 2, (enum deal)deal);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_workers)};

    return cmocka_run_group_tests_name("frame_threads", tests, make_stage, free_stage);
}
