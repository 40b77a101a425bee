/*
 * call_player.c - a random sequence of calls on one frame.
 */
#include "call_player.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static const struct stage *stage;

/* The user's own 2D; what it draws depends on the pixel's place and on which of the two painters it is. */
struct painter {
    struct player *player;
    unsigned which;
};

static struct painter painter[2] = {{NULL, 0}, {NULL, 1}};

static uint32_t below(struct player *p, uint32_t limit)
{
    return stage_random(&p->state) % limit;
}

static bool one_in(struct player *p, uint32_t n)
{
    return below(p, n) == 0;
}

/* ---- the user's own 2D ---- */

static void put(const struct player *p, void *pixels, size_t at, unsigned value)
{
    unsigned bits = sheen_pixel_bits((enum sheen_pixel)p->model.config.target->pixel);

    if (bits == 16)
        ((uint16_t *)pixels)[at] = (uint16_t)value;
    else
        ((uint8_t *)pixels)[at] = (uint8_t)(value & ((1u << bits) - 1));
}

static void underlay(void *ctx, const struct sheen_canvas *canvas)
{
    const struct sheen_rect r = canvas->rect;
    const struct painter *own = ctx;
    struct player *p = own->player;

    if (!p->model.aside) {
        p->model.glass.events++;
        assert_false(p->model.glass.locked);
    }
    for (int y = r.y0; y < r.y1; y++)
        for (int x = r.x0; x < r.x1; x++)
            put(p, canvas->pixels, (size_t)(y - r.y0) * canvas->pitch + (size_t)(x - r.x0),
                ((unsigned)x * 7u + (unsigned)y * 13u + own->which * 5u) * 0x1357u);
}

/* Draws another worker's band in the middle of this one, as a second core might; only if there is a lock. */
static void another_worker(struct player *p)
{
    unsigned worker = below(p, p->model.config.workers);

    if (p->model.config.lock == NULL || p->model.busy[worker] || one_in(p, 3))
        return;
    p->counts->nested++;
    model_band(&p->model, worker, below(p, p->model.bands + 1));
}

static void overlay(void *ctx, const struct sheen_canvas *canvas)
{
    const struct sheen_rect r = canvas->rect;
    const struct painter *own = ctx;
    struct player *p = own->player;

    if (!p->model.aside) {
        p->model.glass.events++;
        assert_false(p->model.glass.locked);
        another_worker(p);
    }
    for (int y = r.y0; y < r.y1; y++)
        for (int x = r.x0; x < r.x1; x++)
            if (((unsigned)x + 3u * (unsigned)y + own->which) % 5u == 0)
                put(p, canvas->pixels, (size_t)(y - r.y0) * canvas->pitch + (size_t)(x - r.x0),
                    0x2481u * (own->which + 1));
}

/* ---- what is asked for ---- */

static struct sheen_rect random_rect(struct player *p)
{
    const struct sheen_target *t = p->model.config.target;
    struct sheen_rect r = {(int16_t)below(p, t->width), (int16_t)below(p, t->height), 0, 0};

    r.x1 = (int16_t)(r.x0 + (int)below(p, t->width) - 2);
    r.y1 = (int16_t)(r.y0 + (int)below(p, t->height) - 2);
    return r;
}

/* Half of the viewports are the whole target, the others aligned rectangles. */
static void change_viewport(struct player *p)
{
    const struct sheen_target *t = p->model.config.target;
    int x = t->align_x > 1 ? t->align_x : 1, y = t->align_y > 1 ? t->align_y : 1;
    struct sheen_rect r = random_rect(p);

    r = (struct sheen_rect){(int16_t)(r.x0 / x * x), (int16_t)(r.y0 / y * y), (int16_t)t->width, (int16_t)t->height};
    if (one_in(p, 2))
        r.x1 = (int16_t)(r.x0 + x);
    if (one_in(p, 2))
        r.y1 = (int16_t)(r.y0 + y);
    r.x1 = r.x1 > (int)t->width ? (int16_t)t->width : r.x1;
    r.y1 = r.y1 > (int)t->height ? (int16_t)t->height : r.y1;
    p->view.viewport = one_in(p, 2) ? (struct sheen_rect){0, 0, 0, 0} : r;
}

static void change_view(struct player *p)
{
    struct sheen_view *v = &p->view;

    switch (below(p, 12)) {
    case 0:
        change_viewport(p);
        break;
    case 1:
        v->background[below(p, 3)] = (uint8_t)(below(p, 2) * 255);
        break;
    case 2:
        v->underlay = one_in(p, 2) ? underlay : NULL;
        break;
    case 3:
        v->overlay = one_in(p, 3) ? NULL : overlay;
        break;
    case 4:
        v->ctx = &painter[below(p, 2)];
        break;
    case 5:
        v->dither ^= 1;
        break;
    case 6:
        v->fov = SHEEN_DEGREES(30) + below(p, SHEEN_DEGREES(40));
        break;
    default:
        break;
    }
}

static void begin(struct player *p)
{
    struct sheen_view bad = p->view;

    if (!one_in(p, 12)) {
        change_view(p);
        model_begin(&p->model, &p->view, SHEEN_OK);
        return;
    }
    if (one_in(p, 2))
        bad.z_near = -1;
    else
        bad.viewport = (struct sheen_rect){0, 0, (int16_t)(p->model.config.target->width + 1), 8};
    model_begin(&p->model, &bad, SHEEN_ERR_ARGUMENT);
}

/* Forty thin triangles: more than one word of pending bits can hold. */
static void make_fan(struct player *p)
{
    for (int i = 0; i < 42; i++) {
        p->position[3 * i] = (int16_t)(i == 0 ? 0 : -30000 + 1463 * (i - 1));
        p->position[3 * i + 1] = (int16_t)(i == 0 ? -30000 : 30000 - 400 * (i % 3));
        p->position[3 * i + 2] = 0;
    }
    for (int i = 0; i < 40; i++) {
        p->index[3 * i] = 0;
        p->index[3 * i + 1] = (uint8_t)(i + 2);
        p->index[3 * i + 2] = (uint8_t)(i + 1);
    }
    p->fan = (struct sheen_mesh){.positions = p->position,
                                 .indices = p->index,
                                 .index_bytes = 1,
                                 .vertices = 42,
                                 .triangles = 40,
                                 .scale = SHEEN_Q24(1)};
}

/* Draws a cube or the fan somewhere: in the view, across its edges, through the near plane, seen from behind. */
static void draw(struct player *p)
{
    struct actor actor = {.mesh = STAGE_CUBE,
                          .material = (int)below(p, 3),
                          .shading = (enum sheen_shading)below(p, 4),
                          .x = below(p, 5) - 2.0,
                          .y = below(p, 3) - 1.0,
                          .depth = one_in(p, 5) ? 1.3 : 5,
                          .size = one_in(p, 4) ? 1.5 : 0.6,
                          .yaw = below(p, 8) * 45.0,
                          .pitch = below(p, 3) * 30.0};
    struct sheen_object d;
    int valid = SHEEN_OK;

    stage_draw(stage, &actor, &d);
    if (one_in(p, 4)) {
        d.mesh = &p->fan;
        d.shader = &sheen_flat;
    }
    d.two_sided = (uint8_t)below(p, 2);
    if (one_in(p, 12)) {
        valid = SHEEN_ERR_ARGUMENT;
        switch (below(p, 4)) {
        case 0:
            d.mesh = NULL;
            break;
        case 1:
            d.shader = NULL;
            break;
        case 2:
            d.pose.rotation[0] = d.pose.rotation[1] = d.pose.rotation[2] = 0;
            break;
        default:
            d.pose.scale = -1;
        }
    }
    model_draw(&p->model, &d, valid);
    p->counts->clipped += p->model.pieces > 0;
}

/* Draws a frame's bands in a random order by random workers; now and then asks for one twice. */
static void all_bands(struct player *p)
{
    struct model *m = &p->model;
    unsigned step = 1 + 2 * below(p, 12), first = below(p, 32);

    for (unsigned i = 0; i < 32; i++) { /* an odd step reaches each of the 32 */
        unsigned band = (first + i * step) % 32, worker = below(p, m->config.workers);
        if (band < m->bands && (!m->done[band] || one_in(p, 40)))
            model_band(m, worker, band);
    }
}

static void order_faults(struct player *p)
{
    struct glass *g = &p->model.glass;

    g->fail_push = one_in(p, 40) ? -1000 - (int)below(p, 1000) : g->fail_push;
    g->fail_wait = one_in(p, 40) ? -1000 - (int)below(p, 1000) : g->fail_wait;
}

/* Any call at any time, but half of the time one that leads on: begin while idle, draw while open, then all bands. */
void player_call(struct player *p)
{
    static const uint8_t leads_on[3] = {[MODEL_IDLE] = 0, [MODEL_OPEN] = 22, [MODEL_BANDS] = 60};
    struct model *m = &p->model;
    bool open = m->state != MODEL_IDLE;
    uint32_t choice = one_in(p, 2) ? leads_on[m->state] : below(p, 100);

    p->calls++;
    order_faults(p);
    if (choice < 22)
        begin(p);
    else if (choice < 42)
        draw(p);
    else if (choice < 50)
        model_mark(m, random_rect(p));
    else if (choice < 60)
        model_band(m, below(p, m->config.workers + 1u), below(p, m->bands + 1));
    else if (choice < 72)
        all_bands(p);
    else if (choice < 82)
        model_finish(m);
    else if (choice < 92)
        model_end(m);
    else if (choice < 98)
        model_wait(m);
    else
        model_invalidate(m);
    p->counts->failures += open && m->state == MODEL_IDLE && m->error != 0;
    p->counts->frames += open && m->state == MODEL_IDLE && m->whole;
    p->counts->drawn += open && m->state == MODEL_IDLE && m->whole && m->listed > 0;
    p->counts->incremental += open && m->state == MODEL_IDLE && m->whole && !m->all;
}

/* ---- a sequence ---- */

void player_open(struct player *p, const struct stage *actors, unsigned number, struct call_counts *counts)
{
    static const uint8_t per_byte[5] = {1, 1, 8, 2, 1};
    struct sheen_config config;
    enum sheen_pixel pixel;

    memset(p, 0, sizeof *p);
    stage = actors;
    p->counts = counts;
    p->number = number;
    p->state = number * 2654435761u + 1;
    for (int i = 0; i < 8; i++)
        (void)stage_random(&p->state);
    pixel = (enum sheen_pixel)below(p, 5);
    glass_make(&p->model.glass, (int)(GLASS_WIDTH - below(p, 24)), (int)(GLASS_HEIGHT - below(p, 9)), pixel,
               !one_in(p, 4));
    p->model.glass.late = one_in(p, 2);
    p->model.glass.target.align_x = (uint8_t)(per_byte[pixel] << below(p, 2));
    p->model.glass.target.align_y = (uint8_t)(below(p, 2) * 4);
    config = (struct sheen_config){.band_rows = (uint16_t)(1 + below(p, one_in(p, 2) ? 4 : 12)),
                                   .buffers = (uint8_t)(1 + below(p, 2)),
                                   .workers = (uint8_t)(1 + below(p, MODEL_WORKERS)),
                                   .max_vertices = (uint16_t)(24 + below(p, 100)),
                                   .max_triangles = (uint16_t)(1 + below(p, 100)),
                                   .max_draws = (uint16_t)(1 + below(p, MODEL_DRAWS)),
                                   .max_clipped = (uint16_t)(one_in(p, 2) ? 0 : below(p, 20)),
                                   .clipper = &sheen_clipper,
                                   .max_carried = (uint16_t)(1 + below(p, 10))};
    if (config.max_clipped == 0 && one_in(p, 3))
        config.clipper = NULL;
    model_make(&p->model, &config, one_in(p, 2));
    painter[0].player = painter[1].player = p;
    stage_view(&p->view);
    p->view.ctx = &painter[0];
    p->view.overlay = one_in(p, 2) ? overlay : NULL;
    make_fan(p);
}

void player_close(struct player *p)
{
    model_wait(&p->model);
    model_free(&p->model);
}
