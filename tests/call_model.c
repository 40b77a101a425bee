/*
 * call_model.c - a model of the contract of a frame's calls.
 */
#include "call_model.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "frame/frame.h"

/* ---- a fresh frame that sends everything ---- */

static void plain_begin(struct model *m)
{
    m->aside = true;
    glass_begin(&m->plain, m->viewport);
    sheen_invalidate(m->full.frame);
    assert_int_equal(sheen_begin(m->full.frame, &m->view), SHEEN_OK);
}

/* Count what a draw would add to the lists; true if it needs a clipper. */
static bool count(struct model *m, const struct sheen_object *draw, unsigned *listed, unsigned *pieces)
{
    plain_begin(m);
    assert_int_equal(sheen_draw(m->full.frame, draw), SHEEN_OK);
    *listed = m->full.frame->entries;
    *pieces = m->full.frame->pieces;
    const bool cut = m->full.frame->count.clipped > 0;
    assert_int_equal(sheen_finish(m->full.frame), SHEEN_OK);
    m->aside = false;
    return cut;
}

static void check_picture(struct model *m)
{
    const struct glass *g = &m->glass;

    plain_begin(m);
    for (unsigned i = 0; i < m->draws; i++)
        assert_int_equal(sheen_draw(m->full.frame, &m->draw[i]), SHEEN_OK);
    assert_int_equal(sheen_end(m->full.frame), SHEEN_OK);
    assert_int_equal(sheen_wait(m->full.frame), SHEEN_OK);
    m->aside = false;
    for (int y = m->viewport.y0; y < m->viewport.y1; y++)
        for (int x = m->viewport.x0; x < m->viewport.x1; x++) {
            int i = y * g->target.width + x;
            if (g->shown[i] != m->plain.shown[i])
                fail_msg("(%d, %d) shows %04x, a full frame %04x", x, y, g->shown[i], m->plain.shown[i]);
        }
}

/* ---- around each call ---- */

/* The error that a push or a wait returned during this call or an earlier one of the frame; 0: none. */
static int error_now(const struct model *m)
{
    return m->error != 0 ? m->error : m->glass.failed;
}

/* A push that failed during this call spoils the open frame and makes the next one send all; then check what is due. */
static void call_ends(struct model *m)
{
    struct glass *g = &m->glass;

    assert_false(g->locked);
    if (g->failed != 0) {
        m->all_next = true;
        m->whole = m->due = false;
        if (m->state != MODEL_IDLE)
            m->error = error_now(m);
        g->failed = 0;
    }
    if (m->due && !g->flying) {
        check_picture(m);
        m->due = false;
    }
}

/* ---- the calls ---- */

static bool same_view(const struct model *m, const struct sheen_view *view, struct sheen_rect viewport)
{
    const struct sheen_view *was = &m->view;
    bool own = view->underlay != NULL || view->overlay != NULL;

    return memcmp(&viewport, &m->viewport, sizeof viewport) == 0 &&
           memcmp(view->background, was->background, sizeof was->background) == 0 && view->underlay == was->underlay &&
           view->overlay == was->overlay && (!own || view->ctx == was->ctx);
}

static void frame_opens(struct model *m, const struct sheen_view *view)
{
    const struct sheen_target *t = &m->glass.target;
    struct sheen_rect viewport = view->viewport;
    unsigned rows = m->config.band_rows, align = t->align_y > 1 ? t->align_y : 1u;

    if (viewport.x0 >= viewport.x1 || viewport.y0 >= viewport.y1)
        viewport = (struct sheen_rect){0, 0, (int16_t)t->width, (int16_t)t->height};
    m->all = m->all_next || !same_view(m, view, viewport);
    m->all_next = false;
    m->whole = true;
    m->due = false;
    m->view = *view;
    m->viewport = viewport;
    rows = (rows + align - 1) / align * align;
    m->bands = ((unsigned)(viewport.y1 - viewport.y0) + rows - 1) / rows;
    memset(m->done, 0, sizeof m->done);
    memset(m->marked, 0, sizeof m->marked);
    m->vertices = m->listed = m->pieces = m->draws = 0;
    m->error = 0;
    m->state = MODEL_OPEN;
    glass_begin(&m->glass, viewport);
    assert_int_equal(sheen_band_count(m->f.frame), m->bands);
}

void model_begin(struct model *m, const struct sheen_view *view, int valid)
{
    bool idle = m->state == MODEL_IDLE;
    unsigned events = m->glass.events;
    int result = sheen_begin(m->f.frame, view), failed = m->glass.failed;

    assert_int_equal(result, !idle ? SHEEN_ERR_STATE : failed != 0 ? failed : valid);
    if (idle)
        assert_false(m->glass.flying);
    else
        assert_int_equal(m->glass.events, events);
    call_ends(m);
    if (result == SHEEN_OK)
        frame_opens(m, view);
}

void model_draw(struct model *m, const struct sheen_object *draw, int valid)
{
    unsigned listed = 0, pieces = 0, events = m->glass.events;
    int expected = m->state != MODEL_OPEN ? SHEEN_ERR_STATE : valid;
    bool full = m->draws == m->config.max_draws ||
                (draw->mesh != NULL && m->vertices + draw->mesh->vertices > m->config.max_vertices);

    if (expected == SHEEN_OK) {
        const bool cut = count(m, draw, &listed, &pieces);
        if (full || (cut && m->config.clipper == NULL) || m->listed + listed > m->config.max_triangles ||
            m->pieces + pieces > m->config.max_clipped)
            expected = SHEEN_ERR_CAPACITY;
    }
    int result = sheen_draw(m->f.frame, draw);
    if (expected == SHEEN_ERR_ARGUMENT && full && result == SHEEN_ERR_CAPACITY)
        expected = result; /* both errors apply, so either is right */
    assert_int_equal(result, expected);
    assert_int_equal(m->glass.events, events);
    if (expected == SHEEN_OK) {
        m->draw[m->draws++] = *draw;
        m->vertices += draw->mesh->vertices;
        m->listed += listed;
        m->pieces += pieces;
    }
}

void model_mark(struct model *m, struct sheen_rect rect)
{
    assert_int_equal(sheen_mark(m->f.frame, rect), m->state == MODEL_OPEN ? SHEEN_OK : SHEEN_ERR_STATE);
    for (int y = m->viewport.y0; y < m->viewport.y1 && m->state == MODEL_OPEN; y++)
        for (int x = m->viewport.x0; x < m->viewport.x1; x++)
            if (x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1)
                m->marked[y * m->glass.target.width + x] = true;
}

/* May be called from a 2D callback while another worker draws a band. */
void model_band(struct model *m, unsigned worker, unsigned band)
{
    bool outermost = !m->busy[0] && !m->busy[1] && !m->busy[2] && !m->busy[3];
    unsigned events = m->glass.events;
    int refused = m->state == MODEL_IDLE                            ? SHEEN_ERR_STATE
                  : worker >= m->config.workers || band >= m->bands ? SHEEN_ERR_ARGUMENT
                  : error_now(m) != 0                               ? error_now(m)
                  : m->done[band]                                   ? SHEEN_ERR_STATE
                                                                    : SHEEN_OK;

    if (refused != SHEEN_OK) {
        assert_int_equal(sheen_band(m->f.frame, worker, band), refused);
        assert_int_equal(m->glass.events, events);
        return;
    }
    m->state = MODEL_BANDS;
    m->done[band] = true;
    m->busy[worker] = true;
    int result = sheen_band(m->f.frame, worker, band);
    m->busy[worker] = false;
    assert_int_equal(result, error_now(m));
    if (outermost)
        call_ends(m);
}

/* The frame is over: check that all it had to send was sent, and no pixel twice. */
static void frame_closes(struct model *m)
{
    const struct glass *g = &m->glass;
    struct sheen_stats stats;

    m->state = MODEL_IDLE;
    for (unsigned b = 0; b < m->bands; b++)
        m->whole = m->whole && m->done[b];
    m->all_next = m->all_next || !m->whole;
    sheen_frame_stats(m->f.frame, &stats);
    assert_int_equal(stats.rectangles, g->pushes);
    assert_int_equal(stats.pixels, g->area);
    for (int y = m->viewport.y0; y < m->viewport.y1; y++)
        for (int x = m->viewport.x0; x < m->viewport.x1; x++) {
            int i = y * g->target.width + x;
            assert_true(g->times[i] <= 1);
            if (m->whole && (m->all || m->marked[i]))
                assert_int_equal(g->times[i], 1);
        }
    m->due = m->whole;
}

void model_finish(struct model *m)
{
    unsigned events = m->glass.events;
    bool idle = m->state == MODEL_IDLE;

    assert_int_equal(sheen_finish(m->f.frame), idle ? SHEEN_ERR_STATE : m->error);
    assert_int_equal(m->glass.events, events);
    if (!idle)
        frame_closes(m);
    call_ends(m);
}

void model_end(struct model *m)
{
    bool idle = m->state == MODEL_IDLE;
    unsigned events = m->glass.events;

    memset(m->busy, true, sizeof m->busy); /* so that no callback starts another worker's band */
    int result = sheen_end(m->f.frame);
    memset(m->busy, false, sizeof m->busy);
    assert_int_equal(result, idle ? SHEEN_ERR_STATE : error_now(m));
    if (idle) {
        assert_int_equal(m->glass.events, events);
        return;
    }
    call_ends(m);
    for (unsigned b = 0; b < m->bands && m->error == 0; b++)
        m->done[b] = true;
    frame_closes(m);
    call_ends(m);
}

void model_wait(struct model *m)
{
    int result = sheen_wait(m->f.frame);

    assert_int_equal(result, m->glass.failed);
    assert_false(m->glass.flying);
    call_ends(m);
}

/* The panel was written to by others, or lost power. */
void model_invalidate(struct model *m)
{
    sheen_invalidate(m->f.frame);
    glass_scribble(&m->glass);
    m->all_next = true;
    m->whole = m->due = false;
}

void model_make(struct model *m, const struct sheen_config *config, bool lock)
{
    const struct sheen_target *t = &m->glass.target;
    struct sheen_config plain = {
        .max_vertices = 200, .max_triangles = 200, .max_clipped = 200, .clipper = &sheen_clipper};

    m->config = *config;
    m->config.target = t;
    m->glass.has_lock = lock;
    m->config.lock_ctx = &m->glass;
    m->config.lock = lock ? glass_lock : NULL;
    m->config.unlock = lock ? glass_unlock : NULL;
    assert_int_equal(core_frame_make(&m->f, &m->config), SHEEN_OK);
    m->all_next = true;
    glass_scribble(&m->glass);

    glass_make(&m->plain, t->width, t->height, (enum sheen_pixel)t->pixel, false);
    m->plain.target.align_x = t->align_x;
    m->plain.target.align_y = t->align_y;
    plain.target = &m->plain.target;
    plain.band_rows = t->height;
    assert_int_equal(core_frame_make(&m->full, &plain), SHEEN_OK);
}

void model_free(struct model *m)
{
    core_frame_free(&m->f);
    core_frame_free(&m->full);
}
