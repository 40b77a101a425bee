/*
 * test_frame_mixes.c - random mixes of all shadings and features over a few frames of one struct sheen_frame, with
 * random bands, buffers, workers, orders and carried set-ups, and with refused objects in between. Each frame must
 * equal the same frame drawn alone, whole, in one band.
 *
 *   test_frame_mixes          400 mixes
 *   test_frame_mixes all      40,000
 *   test_frame_mixes from N   starting with mix N, which a failure names
 */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "frame_mix.h"
#include "frame_test.h"

static unsigned first_mix, mixes = 400;
static const struct mix *failing; /* the mix being played */
static unsigned failing_number;

static struct mix_mesh meshes[STAGE_MESHES];

/* ---- how ---- */

enum order {
    BY_END,
    FORWARD,
    BACKWARD,
    ANY,
    THREADS,
    ORDERS
};

/* How frames are drawn and sent. */
struct settings {
    enum sheen_pixel pixel;
    int align_x, align_y, band_rows, buffers, workers, carried;
    enum order order;
    bool delayed;
};

static void random_settings(struct settings *settings, uint32_t *seed)
{
    static const int rows[] = {1, 2, 5, 7, 16, 33, MIX_HEIGHT}, carried[] = {0, 1, 2, 5, 254};

    settings->pixel = (enum sheen_pixel)(stage_random(seed) % 5);
    settings->align_x = settings->pixel == SHEEN_GREY2    ? 8
                        : settings->pixel == SHEEN_GREY16 ? 2
                        : stage_random(seed) % 4          ? 1
                                                          : 4;
    settings->align_y = settings->pixel == SHEEN_GREY2 || stage_random(seed) % 4 ? 1 : 2;
    settings->band_rows = rows[stage_random(seed) % 7];
    settings->buffers = 1 + (int)(stage_random(seed) % 2);
    settings->workers = 1 + (int)(stage_random(seed) % 4);
    settings->carried = carried[stage_random(seed) % 5];
    settings->order = (enum order)(stage_random(seed) % ORDERS);
    settings->delayed = stage_random(seed) % 2;
}

static pthread_mutex_t one_at_a_time = PTHREAD_MUTEX_INITIALIZER, dealt = PTHREAD_MUTEX_INITIALIZER;

static void take_lock(void *ctx)
{
    (void)pthread_mutex_lock(ctx);
}

static void give_lock(void *ctx)
{
    (void)pthread_mutex_unlock(ctx);
}

struct job {
    struct sheen_frame *frame;
    unsigned worker, *next;
    int status;
};

/* Each worker takes the next band that nobody has begun. */
static void *work(void *argument)
{
    struct job *job = argument;
    const unsigned count = sheen_band_count(job->frame);

    while (job->status == SHEEN_OK) {
        (void)pthread_mutex_lock(&dealt);
        const unsigned band = (*job->next)++;
        (void)pthread_mutex_unlock(&dealt);
        if (band >= count)
            break;
        job->status = sheen_band(job->frame, job->worker, band);
    }
    return NULL;
}

static int run_threads(struct sheen_frame *frame, unsigned workers)
{
    pthread_t thread[4];
    struct job job[4];
    unsigned next = 0;
    int status = SHEEN_OK;

    for (unsigned w = 0; w < workers; w++) {
        job[w] = (struct job){frame, w, &next, SHEEN_OK};
        assert_int_equal(pthread_create(&thread[w], NULL, work, &job[w]), 0);
    }
    for (unsigned w = 0; w < workers; w++) {
        assert_int_equal(pthread_join(thread[w], NULL), 0);
        status = status == SHEEN_OK ? job[w].status : status;
    }
    return status;
}

static int run_bands(struct sheen_frame *frame, const struct settings *settings, uint32_t *seed)
{
    const unsigned count = sheen_band_count(frame);
    unsigned band[MIX_HEIGHT];
    int status = SHEEN_OK;

    if (settings->order == THREADS)
        return run_threads(frame, (unsigned)settings->workers);
    for (unsigned i = 0; i < count; i++) {
        const unsigned j = settings->order == ANY ? stage_random(seed) % (i + 1) : i;
        band[i] = band[j];
        band[j] = settings->order == BACKWARD ? count - 1 - i : i;
    }
    for (unsigned i = 0; i < count && status == SHEEN_OK; i++) {
        const unsigned worker = settings->order == ANY ? stage_random(seed) : i;
        status = sheen_band(frame, worker % (unsigned)settings->workers, band[i]);
    }
    return status;
}

/* ---- frames ---- */

/* Draws the object with a fault, which is found before anything is done, on the way, or when its lines are listed. */
static void draw_refused(struct sheen_frame *frame, const struct sheen_object *from, uint32_t *seed)
{
    struct sheen_object o = *from;
    struct sheen_mesh mesh = *from->mesh;
    const unsigned kind = stage_random(seed) % 5;

    if (kind == 0) {
        o.transparency = 32;
        o.stipple = NULL;
    } else if (kind == 1) {
        o.transparency = 65;
        o.stipple = &sheen_stipple;
    } else if (kind == 2) {
        o.pose.scale = -1;
    } else if (kind == 3) {
        o.depth_bias = 4096;
    } else {
        mesh.edges = NULL;
        o.mesh = &mesh;
        o.morph = NULL;
        o.edges = stage_random(seed) % 2 ? &sheen_edges_outline : &sheen_edges_wire; /* smooth needs > 2 levels */
    }
    assert_true(sheen_draw(frame, &o) < 0);
}

/* seed: if not NULL, refused objects are drawn in between. */
static int draw_objects(struct sheen_frame *frame, const struct mix_frame *f, uint32_t *seed)
{
    int status = sheen_begin(frame, &f->view);

    for (unsigned i = 0; i < f->count && status == SHEEN_OK; i++) {
        if (seed != NULL && stage_random(seed) % 4 == 0)
            draw_refused(frame, &f->object[stage_random(seed) % f->count], seed);
        status = sheen_draw(frame, &f->object[i]);
    }
    return status;
}

static void check(struct sheen_frame *frame, int status)
{
    if (status != SHEEN_OK)
        fail_msg("%s, about %s", sheen_strerror(status), sheen_subject_name(sheen_frame_about(frame, NULL)));
}

static void open_frame(struct core_frame *f, struct memory_target *t, const struct settings *settings)
{
    struct sheen_config config;

    assert_int_equal(memory_target_init(t, MIX_WIDTH, MIX_HEIGHT, settings->pixel), 0);
    t->target.align_x = (uint8_t)settings->align_x;
    t->target.align_y = (uint8_t)settings->align_y;
    t->delayed = settings->delayed;
    stage_config(&config, t, MIX_OBJECTS);
    config.max_vertices += 3000; /* for ends of edges that the view volume cuts */
    config.max_clipped = 1000;
    config.max_edges = 5000;
    config.smooth = 1;
    config.band_rows = (uint16_t)settings->band_rows;
    config.buffers = (uint8_t)settings->buffers;
    config.workers = (uint8_t)settings->workers;
    config.max_carried = (uint16_t)settings->carried;
    if (settings->order == THREADS) {
        config.lock = take_lock;
        config.unlock = give_lock;
        config.lock_ctx = &one_at_a_time;
    }
    assert_int_equal(core_frame_make(f, &config), SHEEN_OK);
}

static void close_frame(struct core_frame *f, struct memory_target *t)
{
    if (t->breaches > 0)
        fail_msg("%s", t->first_breach);
    core_frame_free(f);
    memory_target_free(t);
}

/* Outside the viewport the target must keep what it had. */
static void compare(const struct memory_target *got, const struct mix_frame *f, const struct settings *settings,
                    unsigned number)
{
    struct settings whole = {.pixel = settings->pixel,
                             .align_x = settings->align_x,
                             .align_y = settings->align_y,
                             .band_rows = MIX_HEIGHT,
                             .buffers = 1,
                             .workers = 1};
    struct sheen_rect r = f->view.viewport;
    struct memory_target expected;
    struct core_frame alone;
    unsigned differing = 0;
    int at[2] = {0, 0};

    open_frame(&alone, &expected, &whole);
    check(alone.frame, draw_objects(alone.frame, f, NULL));
    check(alone.frame, sheen_end(alone.frame));
    if (r.x0 >= r.x1 || r.y0 >= r.y1)
        r = (struct sheen_rect){0, 0, MIX_WIDTH, MIX_HEIGHT};
    for (int y = r.y1 - 1; y >= r.y0; y--) {
        for (int x = r.x1 - 1; x >= r.x0; x--) {
            if (memory_target_pixel(got, x, y) != memory_target_pixel(&expected, x, y)) {
                differing++;
                at[0] = x;
                at[1] = y;
            }
        }
    }
    if (differing > 0)
        fail_msg("frame %u: %u px differ, the first at (%d, %d): %04x, whole %04x; bands of %d rows, %d buffers, "
                 "%d workers, %d carried, order %d, format %d",
                 number, differing, at[0], at[1], memory_target_pixel(got, at[0], at[1]),
                 memory_target_pixel(&expected, at[0], at[1]), settings->band_rows, settings->buffers,
                 settings->workers, settings->carried, (int)settings->order, (int)settings->pixel);
    close_frame(&alone, &expected);
}

static struct {
    unsigned frames, drawn, partly, shader[32];
} met;

static void play(const struct mix *mix, const struct settings *settings, uint32_t *seed)
{
    struct memory_target target;
    struct core_frame f;
    struct sheen_stats stats;

    open_frame(&f, &target, settings);
    for (unsigned i = 0; i < MIX_FRAMES; i++) {
        const struct mix_frame *frame = &mix->frame[i];
        memory_target_begin(&target);
        if (frame->invalidated)
            sheen_invalidate(f.frame);
        check(f.frame, draw_objects(f.frame, frame, seed));
        if (frame->mark.x0 < frame->mark.x1)
            check(f.frame, sheen_mark(f.frame, frame->mark));
        if (settings->order != BY_END)
            check(f.frame, run_bands(f.frame, settings, seed));
        check(f.frame, settings->order == BY_END ? sheen_end(f.frame) : sheen_finish(f.frame));
        check(f.frame, sheen_wait(f.frame));
        sheen_frame_stats(f.frame, &stats);
        met.frames++;
        met.drawn += stats.setups > 0;
        met.partly += target.area > 0 && target.area < MIX_WIDTH * MIX_HEIGHT / 2;
        compare(&target, frame, settings, i);
    }
    close_frame(&f, &target);
}

static void random_mixes(void **state)
{
    static struct mix mix;

    (void)state;
    mix_meshes(meshes, &stage);
    failing = &mix;
    for (unsigned i = 0; i < mixes; i++) {
        uint32_t seed = (first_mix + i + 1) * 2246822519u;
        struct settings settings;
        failing_number = first_mix + i;
        random_settings(&settings, &seed);
        mix_make(&mix, first_mix + i, meshes, settings.align_x, settings.align_y);
        play(&mix, &settings, &seed);
        for (unsigned k = 0; k < mix.count; k++)
            met.shader[mix.shader[k]]++;
    }
    failing = NULL;
    print_message("  %u mixes, %u frames, %u of them with triangles, %u of them sent in part\n", mixes, met.frames,
                  met.drawn, met.partly);
    assert_true(met.drawn > met.frames / 2 && met.partly > met.frames / 4);
    for (unsigned i = 0; i < mix_shaders(); i++)
        assert_true(met.shader[i] > mixes / 32);
}

static int name_mix(void **state)
{
    (void)state;
    if (failing != NULL) {
        print_message("  mix %u: test_frame_mixes from %u\n", failing_number, failing_number);
        mix_print(failing);
    }
    return 0;
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_teardown(random_mixes, name_mix)};

    if (argc > 1 && strcmp(argv[1], "all") == 0)
        mixes = 40000;
    if (argc > 2 && strcmp(argv[1], "from") == 0)
        first_mix = (unsigned)strtoul(argv[2], NULL, 10);
    return cmocka_run_group_tests_name("frame_mixes", tests, make_stage, free_stage);
}
