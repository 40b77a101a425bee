/*
 * test_frame_canvas.c - 2D that changes under and over objects that move, over many frames: whatever was sent before,
 * the glass shows what a fresh frame that sends everything would show.
 *
 * A show is played on a target in memory or on a simulated panel, in one viewport or in two side by side, which have a
 * frame each or share one, in bands by one or several workers. The objects are those of frame_mix.h, the 2D is
 * canvas_items.h's. Draws that find no room, pushes and waits that fail, bands that are left out, frames given up and
 * frames made anew come in between. The picture expected is kept from frame to frame as well: each frame adds a fresh
 * one to it.
 *
 *   test_frame_canvas                250 shows of 10 frames
 *   test_frame_canvas all            12,000 of 30
 *   test_frame_canvas [all] from N   starting with show N, which a failure names
 */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "canvas_items.h"
#include "frame_mix.h"
#include "frame_test.h"
#include "sim_panel.h"

static unsigned first_show, shows = 250, frames = 10;

static struct mix_mesh meshes[STAGE_MESHES];

#define VIEWS 2
#define MOST_WORKERS 3
#define FAULT_CODE (-1234)

/* ---- the glass ---- */

/* What is drawn on: memory that checks the core, the same memory as the core's own target, or a panel. */
struct glass {
    struct memory_target memory;
    struct sheen_memory own;       /* pixels NULL: the memory's target is its own */
    struct sheen_sim_panel *panel; /* NULL: memory */
    const struct sheen_target *target;
    uint16_t *seen; /* what it shows, row by row */
};

static const char *const panels[] = {"ssd1306-128x64", "ssd1306-72x40",  "sh1106-128x64",  "ssd1327-128x128",
                                     "ssd1327-96x96",  "ssd1325-128x64", "ssd1322-256x64", "st7735-128x128"};
#define PANELS (sizeof panels / sizeof panels[0])

static unsigned below(uint32_t *seed, unsigned n)
{
    return (stage_random(seed) >> 8) % n;
}

static bool one_in(uint32_t *seed, unsigned n)
{
    return below(seed, n) == 0;
}

static void open_memory(struct glass *g, uint32_t *seed)
{
    static const uint8_t per_byte[5] = {1, 1, 8, 2, 1};
    const enum sheen_pixel pixel = (enum sheen_pixel)below(seed, 5);

    assert_int_equal(memory_target_init(&g->memory, 40 + (int)below(seed, 60), 24 + (int)below(seed, 60), pixel), 0);
    g->memory.target.align_x = (uint8_t)(per_byte[pixel] << below(seed, pixel == SHEEN_GREY2 ? 2 : 4));
    g->memory.target.align_y = (uint8_t)(1 << below(seed, 4));
    g->memory.delayed = one_in(seed, 2);
    g->target = &g->memory.target;
}

/* Rows of the core's own target are farther apart than they are wide. */
static void open_own_memory(struct glass *g, uint32_t *seed)
{
    const enum sheen_pixel pixel = (enum sheen_pixel)below(seed, 5);
    const int width = 40 + (int)below(seed, 60), height = 24 + (int)below(seed, 60);

    assert_int_equal(memory_target_init(&g->memory, width + (int)below(seed, 20), height, pixel), 0);
    g->own = (struct sheen_memory){.pixels = g->memory.memory, .stride = g->memory.row_bytes};
    assert_int_equal(sheen_memory_target(&g->memory.target, &g->own, (uint16_t)width, (uint16_t)height, pixel),
                     SHEEN_OK);
    g->target = &g->memory.target;
}

static void open_panel(struct glass *g, uint32_t *seed)
{
    const char *name = panels[below(seed, PANELS)];
    struct sheen_sim_choice choice;
    char why[160];

    if (sheen_sim_choose(&choice, name, (int)below(seed, 8), 0, 0, why, sizeof why) < 0)
        fail_msg("%s", why);
    if (one_in(seed, 3))
        choice.i2c = choice.record->i2c_address;
    assert_int_equal(sheen_sim_panel_open(&g->panel, &choice), SHEEN_OK);
    g->target = sheen_sim_panel_target(g->panel);
}

static void open_glass(struct glass *g, uint32_t *seed)
{
    memset(g, 0, sizeof *g);
    if (one_in(seed, 3))
        open_panel(g, seed);
    else if (one_in(seed, 4))
        open_own_memory(g, seed);
    else
        open_memory(g, seed);
    g->seen = calloc((size_t)g->target->width * g->target->height, sizeof *g->seen);
    assert_non_null(g->seen);
}

static void close_glass(struct glass *g)
{
    if (g->panel != NULL) {
        if (sheen_sim_panel_complaints(g->panel) > 0)
            fail_msg("%s", sheen_sim_panel_complaint(g->panel));
        sheen_sim_panel_close(g->panel);
    } else {
        if (g->memory.breaches > 0)
            fail_msg("%s", g->memory.first_breach);
        memory_target_free(&g->memory);
    }
    free(g->seen);
}

static void look(struct glass *g)
{
    const int width = g->target->width;

    if (g->panel != NULL) {
        assert_int_equal(sheen_sim_panel_picture(g->panel, g->seen), SHEEN_OK);
        return;
    }
    for (int y = 0; y < g->target->height; y++)
        for (int x = 0; x < width; x++)
            g->seen[y * width + x] = (uint16_t)memory_target_pixel(&g->memory, x, y);
}

/* Makes one of the next pushes or waits fail, or none. */
static void order_fault(struct glass *g, uint32_t *seed)
{
    static const enum sheen_sim_fault faults[] = {SHEEN_FAULT_ERROR, SHEEN_FAULT_SHORT, SHEEN_FAULT_TIMEOUT,
                                                  SHEEN_FAULT_BROWN_OUT};

    if (g->panel != NULL)
        sheen_sim_bus_fault(sheen_sim_panel_bus(g->panel), faults[below(seed, 4)], below(seed, 60));
    else if (g->own.pixels != NULL)
        return; /* it never fails */
    else if (g->memory.delayed && one_in(seed, 2))
        g->memory.fail_wait = 1 + (int)below(seed, 6);
    else
        g->memory.fail_push = 1 + (int)below(seed, 6);
    g->memory.fail_code = FAULT_CODE;
}

static void lift_fault(struct glass *g)
{
    if (g->panel != NULL)
        sheen_sim_bus_fault(sheen_sim_panel_bus(g->panel), SHEEN_FAULT_NONE, 0);
    g->memory.fail_wait = g->memory.fail_push = 0;
}

static bool is_fault(int status)
{
    return status == FAULT_CODE || status == SHEEN_ERR_BUS || status == SHEEN_ERR_TIMEOUT;
}

/* ---- a show ---- */

enum order {
    BY_END,
    BY_PARTS, /* sheen_bands() by each worker in turn */
    ANY,
    THREADS,
    ORDERS
};

/* One viewport's objects and 2D, and the frame that draws them. */
struct part {
    struct mix mix;
    struct mix_frame frame[2];
    const struct mix_frame *now; /* one of these two */
    struct items items;
    struct sheen_rect viewport;
    bool under, over;
    bool accepted[MIX_OBJECTS]; /* by sheen_draw() */
    struct core_frame core;
    struct sheen_config config;
    struct sheen_stats stats;
};

struct show {
    unsigned number, frame;
    uint32_t seed;
    struct glass glass;
    struct memory_target expected;
    uint8_t *known; /* per pixel: what the glass shows there is expected */
    unsigned parts;
    bool shared; /* both parts have the first one's frame */
    enum order order;
    bool dark;  /* the panel was switched off, and nothing was pushed since */
    bool tight; /* capacities that do not always suffice */
    bool lines_fog;
    bool calm; /* little changes at a time, and there is at most one object */
    struct part part[VIEWS];
};

static struct {
    unsigned frames, drawn, partly, refused, given_up, broken, left_out, anew, unwaited, off;
} met;

static const struct show *failing;

/* ---- making it ---- */

static pthread_mutex_t one_at_a_time = PTHREAD_MUTEX_INITIALIZER;

static void take_lock(void *ctx)
{
    (void)pthread_mutex_lock(ctx);
}

static void give_lock(void *ctx)
{
    (void)pthread_mutex_unlock(ctx);
}

static void make_config(struct show *s, struct part *p)
{
    static const uint16_t rows[] = {1, 2, 3, 5, 7, 8, 16, 33, 300}, carried[] = {0, 1, 2, 5, 254};
    uint32_t *seed = &s->seed;
    struct sheen_config *c = &p->config;

    *c = (struct sheen_config){.target = s->glass.target,
                               .band_rows = rows[below(seed, 9)],
                               .buffers = (uint8_t)(1 + below(seed, 2)),
                               .workers = (uint8_t)(1 + below(seed, MOST_WORKERS)),
                               .max_vertices = MIX_OBJECTS * MIX_VERTICES + 3000, /* with ends of edges that are cut */
                               .max_triangles = MIX_OBJECTS * MIX_TRIANGLES,
                               .max_draws = MIX_OBJECTS,
                               .max_clipped = 1000,
                               .max_shades = (uint8_t)below(seed, 4),
                               .smooth = 1,
                               .max_carried = carried[below(seed, 5)],
                               .max_edges = 5000,
                               .clipper = &sheen_clipper,
                               .quads = one_in(seed, 2) ? &sheen_quads : NULL};
    if (c->band_rows > s->glass.target->height)
        c->band_rows = s->glass.target->height;
    if (s->tight) {
        c->max_vertices = (uint16_t)(200 + below(seed, 900));
        c->max_used = (uint16_t)(100 + below(seed, c->max_vertices - 100u));
        c->max_triangles = (uint16_t)(50 + below(seed, 500));
        c->max_draws = (uint16_t)(1 + below(seed, MIX_OBJECTS));
        c->max_clipped = (uint16_t)below(seed, 30);
        c->max_edges = (uint16_t)below(seed, 600);
        c->smooth = (uint8_t)below(seed, 2);
    }
    if (s->order == THREADS) {
        c->lock = take_lock;
        c->unlock = give_lock;
        c->lock_ctx = &one_at_a_time;
    }
}

/* A range of an axis from `from` on, its ends on the alignment or at `size`. */
static void random_range(uint32_t *seed, int from, int size, int align, int16_t *first, int16_t *end)
{
    const unsigned steps = (unsigned)(size - from + align - 1) / (unsigned)align;
    const unsigned a = below(seed, steps), b = a + 1 + below(seed, steps - a);

    *first = (int16_t)(from + (int)a * align);
    *end = (int16_t)(from + (int)b * align);
    if (*end > size)
        *end = (int16_t)size;
}

/* All of the target, or a part of it; of two viewports each stays on its side. */
static void random_viewport(struct show *s, unsigned which)
{
    const struct sheen_target *t = s->glass.target;
    const int ax = t->align_x > 1 ? t->align_x : 1, ay = t->align_y > 1 ? t->align_y : 1;
    const int middle = t->width / 2 / ax * ax, from = which == 1 ? middle : 0;
    struct sheen_rect *r = &s->part[which].viewport;

    *r = (struct sheen_rect){0, 0, (int16_t)t->width, (int16_t)t->height};
    if (s->parts == 1 && one_in(&s->seed, 2))
        return;
    random_range(&s->seed, from, s->parts == 2 && which == 0 ? middle : t->width, ax, &r->x0, &r->x1);
    random_range(&s->seed, 0, t->height, ay, &r->y0, &r->y1);
}

/* Makes *f the frame to be drawn, with the show's own viewport, 2D and fog. */
static void finish_view(const struct show *s, struct part *p, struct mix_frame *f)
{
    f->fog.mixer = s->lines_fog ? &sheen_line_fog_mixer : &sheen_fog_mixer;
    f->view.viewport = p->viewport;
    f->view.ctx = &p->items;
    f->view.underlay = p->under ? items_underlay : NULL;
    f->view.overlay = p->over ? items_overlay : NULL;
    p->now = f;
}

static void open_frame(struct show *s, unsigned which)
{
    struct part *p = &s->part[which];

    if (which > 0 && s->shared) {
        p->config = s->part[0].config;
        p->core = s->part[0].core;
        return;
    }
    make_config(s, p);
    assert_int_equal(core_frame_make(&p->core, &p->config), SHEEN_OK);
}

static void open_show(struct show *s, unsigned number)
{
    memset(s, 0, sizeof *s);
    s->number = number;
    s->seed = (number + 1) * 2654435761u;
    for (int i = 0; i < 8; i++)
        (void)stage_random(&s->seed);
    open_glass(&s->glass, &s->seed);
    const struct sheen_target *t = s->glass.target;
    assert_int_equal(memory_target_init(&s->expected, t->width, t->height, (enum sheen_pixel)t->pixel), 0);
    s->expected.target.align_x = t->align_x;
    s->expected.target.align_y = t->align_y;
    s->known = calloc((size_t)t->width, t->height);
    assert_non_null(s->known);
    s->parts = 1 + one_in(&s->seed, 4);
    s->order = (enum order)below(&s->seed, ORDERS);
    s->tight = one_in(&s->seed, 3);
    s->lines_fog = one_in(&s->seed, 3);
    s->calm = one_in(&s->seed, 3);
    s->shared = s->parts > 1 && one_in(&s->seed, 3);
    for (unsigned i = 0; i < s->parts; i++) {
        struct part *p = &s->part[i];
        open_frame(s, i);
        mix_make(&p->mix, stage_random(&s->seed), meshes, 1, 1);
        p->frame[0] = p->mix.frame[0];
        if (p->frame[0].view.fog != NULL)
            p->frame[0].view.fog = &p->frame[0].fog;
        items_make(&p->items, &s->seed, t);
        p->under = one_in(&s->seed, 2);
        p->over = !one_in(&s->seed, 6);
        random_viewport(s, i);
        finish_view(s, p, &p->frame[0]);
    }
}

static void close_show(struct show *s)
{
    for (unsigned i = 0; i < s->parts; i++)
        if (i == 0 || !s->shared)
            core_frame_free(&s->part[i].core);
    close_glass(&s->glass);
    assert_int_equal(s->expected.breaches, 0);
    memory_target_free(&s->expected);
    free(s->known);
}

static void change(struct show *s, unsigned which)
{
    struct part *p = &s->part[which];
    struct mix_frame *next = p->now == &p->frame[0] ? &p->frame[1] : &p->frame[0];

    mix_next(&s->seed, &p->mix, p->now, next, 1, 1);
    items_next(&p->items, &s->seed, s->calm ? 40 : 12);
    if (s->calm && next->count > 1)
        next->count = 1;
    if (one_in(&s->seed, 24))
        p->under = !p->under;
    if (one_in(&s->seed, 24))
        p->over = !p->over;
    if (one_in(&s->seed, 16))
        random_viewport(s, which);
    finish_view(s, p, next);
}

/* ---- a frame ---- */

enum outcome {
    SHOWN,    /* all of it was sent */
    GIVEN_UP, /* nothing of it was sent */
    BROKEN    /* part of it was sent, or an error came from the glass */
};

static void check(struct sheen_frame *frame, int status)
{
    if (status != SHEEN_OK)
        fail_msg("%s, about %s", sheen_strerror(status), sheen_subject_name(sheen_frame_about(frame, NULL)));
}

static void mark_one(struct part *p, unsigned i)
{
    if (i < p->items.marks)
        check(p->core.frame, sheen_mark(p->core.frame, p->items.mark[i]));
}

/* Marks and draws, mixed; false if a draw found no room and the frame is to be given up. */
static bool draw_objects(struct show *s, struct part *p)
{
    const struct mix_frame *f = p->now;
    unsigned marked = 0;

    for (unsigned i = 0; i < f->count; i++) {
        while (marked < p->items.marks && one_in(&s->seed, 2))
            mark_one(p, marked++);
        int status = sheen_draw(p->core.frame, &f->object[i]);
        p->accepted[i] = status == SHEEN_OK;
        if (status == SHEEN_ERR_CAPACITY && s->tight) {
            met.refused++;
            if (one_in(&s->seed, 4))
                return false;
            continue;
        }
        check(p->core.frame, status);
    }
    while (marked < p->items.marks)
        mark_one(p, marked++);
    if (f->mark.x0 < f->mark.x1)
        check(p->core.frame, sheen_mark(p->core.frame, f->mark));
    return true;
}

struct job {
    struct sheen_frame *frame;
    unsigned worker;
    int status;
};

static void *work(void *argument)
{
    struct job *job = argument;

    job->status = sheen_bands(job->frame, job->worker);
    return NULL;
}

static int run_threads(struct sheen_frame *frame, unsigned workers)
{
    pthread_t thread[MOST_WORKERS];
    struct job job[MOST_WORKERS];
    int status = SHEEN_OK;

    for (unsigned w = 0; w < workers; w++) {
        job[w] = (struct job){frame, w, SHEEN_OK};
        assert_int_equal(pthread_create(&thread[w], NULL, work, &job[w]), 0);
    }
    for (unsigned w = 0; w < workers; w++) {
        assert_int_equal(pthread_join(thread[w], NULL), 0);
        status = status == SHEEN_OK ? job[w].status : status;
    }
    return status;
}

/* All bands, or all but the last `left_out` of a random order. */
static int run_in_any_order(struct show *s, struct part *p, unsigned left_out)
{
    const unsigned count = sheen_band_count(p->core.frame);
    unsigned band[256];
    int status = SHEEN_OK;

    assert_true(count <= 256);
    for (unsigned i = 0; i < count; i++) {
        const unsigned j = below(&s->seed, i + 1);
        band[i] = band[j];
        band[j] = i;
    }
    for (unsigned i = 0; i + left_out < count && status == SHEEN_OK; i++)
        status = sheen_band(p->core.frame, below(&s->seed, p->config.workers), band[i]);
    return status;
}

static int run_bands(struct show *s, struct part *p)
{
    int status = SHEEN_OK;

    if (s->order == THREADS)
        return run_threads(p->core.frame, p->config.workers);
    if (s->order == ANY)
        return run_in_any_order(s, p, 0);
    for (unsigned w = 0; s->order == BY_PARTS && w < p->config.workers && status == SHEEN_OK; w++)
        status = sheen_bands(p->core.frame, w);
    return status;
}

static enum outcome play_part(struct show *s, struct part *p)
{
    int status = sheen_begin(p->core.frame, &p->now->view);

    if (status != SHEEN_OK && is_fault(status))
        return BROKEN;
    check(p->core.frame, status);
    if (!draw_objects(s, p)) {
        met.given_up++;
        check(p->core.frame, sheen_finish(p->core.frame));
        return GIVEN_UP;
    }
    if (one_in(&s->seed, 24)) {
        met.left_out++;
        status = run_in_any_order(s, p, 1);
        const int finished = sheen_finish(p->core.frame);
        assert_true(finished == status || status == SHEEN_OK);
        return BROKEN;
    }
    status = run_bands(s, p);
    const int end = s->order == BY_END ? sheen_end(p->core.frame) : sheen_finish(p->core.frame);
    assert_true(status == SHEEN_OK || end == status);
    if (is_fault(end))
        return BROKEN;
    check(p->core.frame, end);
    return SHOWN;
}

/* ---- what is expected ---- */

/* Adds a fresh frame with the objects that were accepted, in one band. */
static void expect(struct show *s, struct part *p)
{
    const struct mix_frame *f = p->now;
    struct sheen_config config = {.target = &s->expected.target,
                                  .band_rows = s->expected.target.height,
                                  .max_vertices = MIX_OBJECTS * MIX_VERTICES + 3000,
                                  .max_triangles = MIX_OBJECTS * MIX_TRIANGLES,
                                  .max_draws = MIX_OBJECTS,
                                  .max_clipped = 1000,
                                  .max_shades = p->config.max_shades,
                                  .smooth = 1,
                                  .max_edges = 5000,
                                  .clipper = &sheen_clipper,
                                  .quads = p->config.quads};
    struct core_frame fresh;

    assert_int_equal(core_frame_make(&fresh, &config), SHEEN_OK);
    check(fresh.frame, sheen_begin(fresh.frame, &f->view));
    for (unsigned i = 0; i < f->count; i++)
        if (p->accepted[i])
            check(fresh.frame, sheen_draw(fresh.frame, &f->object[i]));
    check(fresh.frame, sheen_end(fresh.frame));
    check(fresh.frame, sheen_wait(fresh.frame));
    core_frame_free(&fresh);
    for (int y = p->viewport.y0; y < p->viewport.y1; y++)
        memset(s->known + y * s->expected.target.width + p->viewport.x0, 1, (size_t)(p->viewport.x1 - p->viewport.x0));
}

static void compare(struct show *s)
{
    const int width = s->glass.target->width;
    unsigned differing = 0;
    int first = 0;

    if (s->dark)
        return;
    look(&s->glass);
    for (int i = width * s->glass.target->height - 1; i >= 0; i--)
        if (s->known[i] && s->glass.seen[i] != memory_target_pixel(&s->expected, i % width, i / width)) {
            differing++;
            first = i;
        }
    if (differing > 0)
        fail_msg("frame %u: %u px differ, the first at (%d, %d): %04x, fresh %04x", s->frame, differing, first % width,
                 first / width, s->glass.seen[first], memory_target_pixel(&s->expected, first % width, first / width));
}

/* What the glass shows is unknown; the part that broke off knows that itself. */
static void forget(struct show *s, const struct part *broken)
{
    met.broken++;
    lift_fault(&s->glass);
    memset(s->known, 0, (size_t)s->glass.target->width * s->glass.target->height);
    for (unsigned i = 0; i < s->parts; i++)
        if (&s->part[i] != broken)
            sheen_invalidate(s->part[i].core.frame);
}

/* ---- playing it ---- */

/* A restart: the arena is too small at first, then it is as large as was asked for. */
static void make_anew(struct show *s, struct part *p)
{
    size_t size = below(&s->seed, (unsigned)p->core.arena_bytes);

    met.anew++;
    assert_int_equal(sheen_init(&p->core.frame, p->core.arena, &size, &p->config), SHEEN_ERR_MEMORY);
    assert_int_equal(size, p->core.arena_bytes);
    assert_int_equal(sheen_init(&p->core.frame, p->core.arena, &size, &p->config), SHEEN_OK);
}

/* What the panel showed comes back with the next push. */
static void switch_off(struct show *s)
{
    if (s->glass.panel == NULL)
        return;
    met.off++;
    assert_int_equal(sheen_panel_off(sheen_sim_panel_driver(s->glass.panel)), SHEEN_OK);
    s->dark = true;
}

static void play_frame(struct show *s, unsigned which)
{
    struct part *p = &s->part[which];

    change(s, which);
    if (one_in(&s->seed, 12))
        order_fault(&s->glass, &s->seed);
    enum outcome outcome = play_part(s, p);
    sheen_frame_stats(p->core.frame, &p->stats);
    met.frames++;
    s->dark = s->dark && p->stats.rectangles == 0;
    if (outcome == BROKEN)
        forget(s, p);
    if (outcome != SHOWN) {
        if (sheen_wait(p->core.frame) != SHEEN_OK)
            forget(s, p);
        return;
    }
    const unsigned area = (unsigned)((p->viewport.x1 - p->viewport.x0) * (p->viewport.y1 - p->viewport.y0));
    met.drawn += p->stats.setups > 0;
    met.partly += p->stats.pixels > 0 && p->stats.pixels < area / 2;
    expect(s, p);
    if (s->parts == 1 && one_in(&s->seed, 5)) {
        met.unwaited++;
        return;
    }
    if (sheen_wait(p->core.frame) != SHEEN_OK) {
        forget(s, p);
        return;
    }
    lift_fault(&s->glass);
    compare(s);
    if (one_in(&s->seed, 40))
        make_anew(s, p);
    if (one_in(&s->seed, 20))
        switch_off(s);
}

static void play(struct show *s, unsigned number)
{
    open_show(s, number);
    for (s->frame = 0; s->frame < frames; s->frame++)
        for (unsigned i = 0; i < s->parts; i++)
            play_frame(s, i);
    lift_fault(&s->glass);
    for (unsigned i = 0; i < s->parts; i++)
        assert_int_equal(sheen_wait(s->part[i].core.frame), SHEEN_OK);
    compare(s);
    close_show(s);
}

static void random_shows(void **state)
{
    static struct show show;

    (void)state;
    mix_meshes(meshes, &stage);
    failing = &show;
    for (unsigned i = 0; i < shows; i++)
        play(&show, first_show + i);
    failing = NULL;
    print_message("  %u shows, %u frames, %u of them with triangles, %u of them sent in part, %u not waited for\n",
                  shows, met.frames, met.drawn, met.partly, met.unwaited);
    print_message("  %u draws refused, %u frames given up, %u with a band left out, %u broken off, %u made anew\n",
                  met.refused, met.given_up, met.left_out, met.broken, met.anew);
    print_message("  panels switched off %u times\n", met.off);
    assert_true(met.drawn > met.frames / 2 && met.partly > met.frames / 8);
    assert_true(met.refused > shows / 4 && met.broken > shows / 4 && met.unwaited > shows / 4);
    assert_true(met.given_up > 0 && met.left_out > 0 && met.anew > 0 && met.off > 0);
}

static int name_show(void **state)
{
    (void)state;
    if (failing == NULL)
        return 0;
    const struct sheen_target *t = failing->glass.target;
    print_message("  show %u: test_frame_canvas%s from %u\n", failing->number, frames > 10 ? " all" : "",
                  failing->number);
    print_message("  %u x %u, format %u, align %u %u, %s, %u views%s, order %d%s\n", t->width, t->height, t->pixel,
                  t->align_x, t->align_y, failing->glass.panel != NULL ? "a panel" : "memory", failing->parts,
                  failing->shared ? " of one frame" : "", (int)failing->order, failing->tight ? ", tight" : "");
    for (unsigned i = 0; i < failing->parts; i++) {
        const struct part *p = &failing->part[i];
        print_message("  bands of %u, %u buffers, %u workers, %u carried, view (%d, %d, %d, %d)\n", p->config.band_rows,
                      p->config.buffers, p->config.workers, p->config.max_carried, p->viewport.x0, p->viewport.y0,
                      p->viewport.x1, p->viewport.y1);
        mix_print(&p->mix);
    }
    return 0;
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_teardown(random_shows, name_show)};

    if (argc > 1 && strcmp(argv[1], "all") == 0) {
        shows = 12000;
        frames = 30;
    }
    if (argc > 2 && strcmp(argv[argc - 2], "from") == 0)
        first_show = (unsigned)strtoul(argv[argc - 1], NULL, 10);
    return cmocka_run_group_tests_name("frame_canvas", tests, make_stage, free_stage);
}
