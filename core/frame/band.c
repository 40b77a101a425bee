/*
 * band.c - one band: clear, draw what is pending, send. (sending is send.c)
 *
 * A worker keeps a bit for each entry that has begun and is not done; scanned
 * from the lowest, they are the submission order. Set-ups of triangles that go
 * on below wait in `carried`, a list in the same order; where it is full the
 * triangle is set up again in the next band.
 */
#include <string.h>

#include "../pixel/thumb.h"
#include "frame.h"

/* ---- pending triangles ---- */

/* Entries that reach band b: what is left of the band above, or, after a jump, all that may have begun above. */
static void collect(const struct sheen_frame *f, struct worker *w, unsigned b)
{
    unsigned from = b;

    if (w->last_band + 1 != (int32_t)b) {
        pending_clear(f, w);
        from = b - f->band[b].back;
    }
    for (; from <= b; from++)
        add_list(f, w, from);
    w->last_band = (int32_t)b;
}

/* ---- the tile ---- */

/* Outwards to multiples of the alignment, inside the viewport, whose edges are aligned. */
static struct sheen_rect align_rect(const struct sheen_frame *f, struct sheen_rect r)
{
    int32_t x = f->target->align_x > 1 ? f->target->align_x : 1, y = f->target->align_y > 1 ? f->target->align_y : 1;
    struct sheen_rect aligned = {(int16_t)(r.x0 & -x), (int16_t)(r.y0 & -y), (int16_t)((r.x1 + x - 1) & -x),
                                 (int16_t)((r.y1 + y - 1) & -y)};

    return sheen_rect_intersection(aligned, f->viewport);
}

/* What of band b is cleared, drawn and sent. */
static struct sheen_rect band_rect(const struct sheen_frame *f, unsigned b)
{
    const struct band *band = &f->band[b];
    struct sheen_rect strip = f->viewport;

    strip.y0 = (int16_t)(f->viewport.y0 + (int32_t)b * f->config.band_rows);
    strip.y1 = (int16_t)min32(strip.y0 + f->config.band_rows, f->viewport.y1);
    if (f->send_all)
        return strip;
    struct sheen_rect r =
        sheen_rect_union(sheen_rect_intersection(band->cover, strip), sheen_rect_intersection(band->stale, strip));
    return rect_empty(r) ? r : sheen_rect_intersection(align_rect(f, r), strip);
}

/* count pixels of two bytes, and up to three more: stores are whole multiples of 8 B. */
static void fill(uint64_t *at, size_t count, uint16_t pixel)
{
    const uint32_t pair = pixel | (uint32_t)pixel << 16;
    const uint64_t four = pair | (uint64_t)pair << 32, *end = at + (count + 3) / 4, *blocks = at + (count / 32) * 8;

#if THUMB_LOOPS
    at = thumb_fill(at, blocks, pair);
#else
    for (; at != blocks; at += 8)
        at[0] = at[1] = at[2] = at[3] = at[4] = at[5] = at[6] = at[7] = four;
#endif
    while (at != end)
        *at++ = four;
}

static void clear_tile(const struct sheen_frame *f, const struct tile *t)
{
    size_t count = (size_t)t->pitch * (size_t)(t->rect.y1 - t->rect.y0);

    fill((uint64_t *)(void *)t->depth, count, DEPTH_FAR);
    if (f->view.underlay != NULL) {
        const struct sheen_canvas canvas = {t->rect, t->pitch, t->pixels, t->depth};
        f->view.underlay(f->view.ctx, &canvas);
        return;
    }
    uint16_t background = sheen_colour_bytes(t->format, f->view.background);
    if (t->format->grey)
        memset(t->pixels, background, count);
    else
        fill(t->pixels, count, background);
}

/* ---- drawing ---- */

/* Prepare entry e, from the tile's rows on: its spans there; 0 where it has none. */
static int set_up(const struct sheen_frame *f, const struct worker *w, struct tile *t, const struct draw_record *d,
                  uint32_t e, struct setup *s)
{
    struct surface_corners c;
    struct gradients g;

    sheen_entry_corners(f, d, e, &c.at);
    c.facet = &t->facet;
    if (d->as.morph != NULL)
        d->as.morph->morpher->corners(&d->as, &c.at, w);
    s->entry = (uint16_t)e;
    s->draw = &d->as;
    t->rows = (uint16_t)sheen_triangle_begin(&f->screen, t->rect, w->spans, &c, &g, s);
    if (t->rows == 0)
        return 0;
    t->first_row = (int16_t)(s->row - (int32_t)t->rows);
    d->as.shader->setup(s, &c, c.flat ? NULL : &g);
    if (d->as.fog != NULL)
        d->as.fog->mixer->setup(s);
    SHEEN_TAP_SETUP(&c, &g);
    SHEEN_TAP(PARTIAL, s->row < s->end_row);
    return 1;
}

static void draw_rows(const struct sheen_frame *f, struct worker *w, struct tile *t, const struct draw *d,
                      const struct setup *s)
{
    w->stats.spans += t->rows;
    for (unsigned i = 0; SHEEN_STATS && i < t->rows; i++)
        if (w->spans[i].x1 > w->spans[i].x0)
            w->stats.covered += (uint32_t)(w->spans[i].x1 - w->spans[i].x0);
    if (!d->stippled) {
        SHEEN_TAP_ROWS(t, s);
        return;
    }
    while (f->stipple->hide(scratch_of(w), t, s))
        SHEEN_TAP_ROWS(t, s);
}

/*
 * Draw entry e's rows in the tile. *link is the carried list's place for e.
 * Returns the link for the next entry; clears *going_on when the triangle is done.
 */
static uint8_t *draw_entry(const struct sheen_frame *f, struct worker *w, struct tile *t, uint32_t e,
                           const struct draw_record *d, uint8_t *link, int *going_on)
{
    struct setup *s = slot_of(w, f->config.max_carried); /* the spare one, where no slot is free */
    uint8_t slot = *link;
    int carried = slot != NO_SLOT && slot_of(w, slot)->entry == e;

    SHEEN_TAP(CARRIED, carried);
    if (carried) {
        s = slot_of(w, slot);
        t->first_row = s->row;
        t->rows = (uint16_t)sheen_spans(s, t->rect, w->spans);
    } else {
        slot = w->first_free;
        uint8_t next_free = NO_SLOT;
        if (slot != NO_SLOT) {
            s = slot_of(w, slot);
            next_free = s->next;
        }
        *going_on = set_up(f, w, t, d, e, s);
        s->next = next_free; /* set-up leaves the slot where it was: free */
        if (!*going_on)
            return link;
        w->stats.setups++;
        w->by_way[s->way]++;
    }
    draw_rows(f, w, t, &d->as, s);
    *going_on = s->end_row > t->rect.y1 - (f->edges != NULL ? 2 * LINE_APRON : 0);
    if (*going_on && !carried && slot != NO_SLOT) { /* free list -> carried list */
        w->first_free = s->next;
        s->next = *link;
        *link = slot;
    } else if (!*going_on && carried) { /* carried list -> free list */
        *link = s->next;
        s->next = w->first_free;
        w->first_free = slot;
        return link;
    }
    return *going_on && slot != NO_SLOT ? &s->next : link;
}

static void draw_pending(const struct sheen_frame *f, struct worker *w, struct tile *t)
{
    const struct draw_record *d = f->draw;
    uint8_t *link = &w->first_carried;

    for (uint32_t word = 0; 32 * word < f->entries; word++) {
        uint32_t bits = w->pending[word], done = 0;
        while (bits != 0) {
            uint32_t lowest = bits & (0u - bits), e = 32 * word + 31 - clz32(lowest);
            int going_on = 1;
            bits ^= lowest;
            while (e >= d->end_entry)
                d++;
            link = draw_entry(f, w, t, e, d, link, &going_on);
            done |= going_on ? 0 : lowest;
        }
        w->pending[word] &= ~done;
    }
}

/* ---- a band ---- */

/* Draw into the worker's free buffer and send. */
static int draw_and_send(struct sheen_frame *f, unsigned worker, unsigned b, struct sheen_rect rect)
{
    struct worker *w = &f->worker[worker];
    int error = sheen_free_buffer(f, worker);

    if (error < 0)
        return error;
    struct tile t = {.rect = rect,
                     .pitch = (uint16_t)(rect.x1 - rect.x0),
                     .pixels = w->pixels[w->buffer],
                     .depth = w->depth,
                     .to_pixel = (char *)w->pixels[w->buffer] - (char *)w->depth,
                     .format = &f->format,
                     .dither = f->view.dither,
                     .thresholds = sheen_thresholds,
                     .dither_rows = w->dither_rows,
                     .centre_x = target_x(f, 0),
                     .centre_y = target_y(f, 0),
                     .spans = w->spans};
#if SHEEN_STATS
    t.shaded = &w->stats.shaded;
#endif
    if (f->edges != NULL)
        f->edges->begin(f, w, &t, b);
    sheen_dither_begin(&t, w->dither_rows);
    collect(f, w, b);
    clear_tile(f, &t);
    draw_pending(f, w, &t);
    if (f->edges != NULL)
        f->edges->draw(f, w, &t, rect);
    if (f->view.overlay != NULL) {
        const struct sheen_canvas canvas = {rect, t.pitch, t.pixels, t.depth};
        f->view.overlay(f->view.ctx, &canvas);
    }
    if (f->format.grey)
        sheen_pack_grey(&f->format, t.pixels, t.pitch, (unsigned)(rect.y1 - rect.y0));
    return sheen_send_tile(f, worker, &t);
}

int sheen_band(struct sheen_frame *f, unsigned worker, unsigned b)
{
    int error = sheen_claim_band(f, worker, b);

    if (error < 0)
        return error;
    struct sheen_rect rect = band_rect(f, b);
    /* where nothing crosses this band, nothing is pending below it either */
    return rect_empty(rect) ? SHEEN_OK : draw_and_send(f, worker, b, rect);
}
