/*
 * test_frame_threads.c - the bands of a frame on two threads, each of which is a worker.
 *
 * It is meant for the thread sanitizer, which detects unprotected accesses by both threads to the same memory.
 */
#include <pthread.h>
#include <string.h>

#include "frame_test.h"

#define WIDTH 160
#define HEIGHT 120
#define WORKERS 2
#define FRAMES 8

/* One bus for all workers. It reads pixels in wait(), so it notices a second push, or a buffer written to meanwhile. */
struct bus {
    struct memory_target memory;
    pthread_mutex_t lock;
};

static void take_lock(void *ctx)
{
    assert_int_equal(pthread_mutex_lock(ctx), 0);
}

static void give_lock(void *ctx)
{
    assert_int_equal(pthread_mutex_unlock(ctx), 0);
}

static void bus_open(struct bus *bus)
{
    pthread_mutexattr_t checked; /* reports an error if a thread locks twice or unlocks another thread's lock */

    assert_int_equal(memory_target_init(&bus->memory, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    bus->memory.delayed = true;
    pthread_mutexattr_init(&checked);
    pthread_mutexattr_settype(&checked, PTHREAD_MUTEX_ERRORCHECK);
    pthread_mutex_init(&bus->lock, &checked);
    pthread_mutexattr_destroy(&checked);
}

static void bus_close(struct bus *bus)
{
    assert_int_equal(bus->memory.breaches, 0);
    pthread_mutex_destroy(&bus->lock);
    memory_target_free(&bus->memory);
}

/* How bands are assigned to the workers: every other one, one half each, or the next one to whoever is free. */
enum deal {
    EVERY_OTHER,
    HALVES,
    FIRST_COME,
    SHARES, /* as sheen_bands() assigns them */
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

    if (job->deal == SHARES) {
        job->status = sheen_bands(job->frame, job->worker);
        return NULL;
    }
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
    int status = sheen_finish(frame);
    for (unsigned w = 0; w < WORKERS; w++)
        assert_true(job[w].status == SHEEN_OK || job[w].status == status);
    return status;
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
        struct sheen_object draw;
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
    assert_int_equal(core_frame_make(&alone, &config), SHEEN_OK);
    config.target = &two.memory.target;
    config.lock_ctx = &two.lock;
    config.lock = take_lock;
    config.unlock = give_lock;
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
        assert_int_equal(sheen_wait(alone.frame), SHEEN_OK);
        assert_int_equal(sheen_wait(shared.frame), SHEEN_OK);
        assert_memory_equal(one.memory.memory, two.memory.memory, HEIGHT * one.memory.row_bytes);
    }
    core_frame_free(&alone);
    core_frame_free(&shared);
    bus_close(&one);
    bus_close(&two);
}

/* One push or wait fails, on either thread: the frame gets that error, and the next frame sends everything. */
static void one_fails(void **state)
{
    struct core_frame f;
    struct sheen_config config;
    struct sheen_view view;
    struct bus bus;

    (void)state;
    bus_open(&bus);
    stage_config(&config, &bus.memory, 3);
    config.band_rows = 4;
    config.workers = WORKERS;
    config.lock_ctx = &bus.lock;
    config.lock = take_lock;
    config.unlock = give_lock;
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    bus.memory.fail_code = -77;
    stage_view(&view);
    for (int i = 0; i < 40; i++) {
        long *countdown = i % 4 == 0 ? &bus.memory.fail_push : &bus.memory.fail_wait;
        int fails = i % 2 == 0;
        draw_all(f.frame, &view, i % FRAMES);
        memory_target_begin(&bus.memory);
        *countdown = fails ? 1 + i / 4 : 0;
        assert_int_equal(run_bands(f.frame, (enum deal)(i % DEALS)), fails ? -77 : SHEEN_OK);
        assert_int_equal(sheen_wait(f.frame), SHEEN_OK);
        if (fails)
            assert_true(bus.memory.pushes <= 1 + i / 4);
        else
            assert_int_equal(bus.memory.area, WIDTH * HEIGHT);
    }
    core_frame_free(&f);
    bus_close(&bus);
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
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_workers), cmocka_unit_test(one_fails)};

    return cmocka_run_group_tests_name("frame_threads", tests, make_stage, free_stage);
}
