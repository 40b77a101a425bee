/*
 * band.c - one band: clear, draw what is pending, send. (sending is send.c)
 *
 * A worker keeps a bit for each entry that has begun and is not done; scanned from the lowest bit, they give submission
 * order. Set-ups of triangles that go on in the next band wait in `carried`, a list in the same order; if it is full,
 * the triangle is set up again in the next band.
 */
#include <string.h>

#include "../pixel/thumb.h"
#include "frame.h"

/* ---- pending triangles ---- */

/* Make band b's own entries pending, as those left from above already are; after a jump, all that may reach b. */
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

/*
 * The part of band b that is cleared, drawn and sent; 0 if it is empty. Cover and stale are each empty or reach into
 * the band, so it suffices to cut the rectangle around both. That rectangle is grown outwards to multiples of the
 * alignment; the bands' edges are such multiples too, or the target's own edges.
 */
static int band_rect(const struct sheen_frame *f, unsigned b, struct sheen_rect *rect)
{
    const struct band *band = &f->band[b];
    struct sheen_rect r = band->cover;

    sheen_band_strip(f, b, rect);
    if (!f->send_all) {
        sheen_rect_unite(&r, &band->stale);
        sheen_rect_align(&r, f->target);
        sheen_rect_cut(rect, &r);
    }
    return !rect_empty(*rect);
}

/* Write count pixels of two bytes, and up to three more: stores are multiples of 8 B, so there is room for them. */
HOT static void fill(uint64_t *at, size_t count, uint16_t pixel)
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

/* Let the user draw 2D on the tile. */
static APART void paint(const struct sheen_frame *f, const struct tile *t,
                        void (*painter)(void *ctx, const struct sheen_canvas *canvas))
{
    const struct sheen_canvas canvas = {t->rect, t->pitch, t->pixels, t->depth, (enum sheen_pixel)f->target->pixel};

    painter(f->view.ctx, &canvas);
}

static void clear_tile(const struct sheen_frame *f, const struct tile *t)
{
    size_t count = (size_t)t->pitch * (size_t)(t->rect.y1 - t->rect.y0);

    fill((uint64_t *)(void *)t->depth, count, DEPTH_FAR);
    if (f->view.underlay != NULL) {
        paint(f, t, f->view.underlay);
        return;
    }
    uint16_t background = sheen_colour_pixel(t->format, f->view.background);
    if (t->format->grey)
        memset(t->pixels, background, count);
    else
        fill(t->pixels, count, background);
}

/* ---- drawing ---- */

/* Set up entry e from the tile's first row on; returns how many rows it has in the tile. */
HOT static APART unsigned set_up(const struct sheen_frame *f, const struct worker *w, struct tile *t,
                                 const struct draw_record *d, uint32_t e, struct setup *s)
{
    struct surface_corners c;
    struct gradients g;

    sheen_entry_corners(f, d, e, &c.at);
    c.facet = &t->facet;
    if (d->as.morph != NULL)
        d->as.morph->morpher->corners(&d->as, &c.at, w);
    s->entry = (uint16_t)e;
    s->draw = &d->as;
    const unsigned rows = sheen_triangle_begin(&f->screen, t->rect, w->spans, &c, &g, s);
    if (rows == 0)
        return 0;
    d->as.shader->setup(s, &c, c.flat ? NULL : &g);
    if (d->as.fog != NULL)
        d->as.fog->mixer->setup(s);
    SHEEN_TAP_SETUP(&c, &g);
    SHEEN_TAP(PARTIAL, s->row < s->end_row);
    SHEEN_TAP(QUAD, c.at.v[3] != NULL);
    return rows;
}

static void draw_rows(const struct sheen_frame *f, struct worker *w, struct tile *t, unsigned rows,
                      const struct setup *s)
{
    t->rows = (uint16_t)rows;
    t->first_row = (int16_t)(s->row - (int32_t)rows);
    w->count.spans += rows;
    for (unsigned i = 0; SHEEN_STATS && i < rows; i++)
        if (w->spans[i].x1 > w->spans[i].x0)
            w->count.covered += (uint32_t)(w->spans[i].x1 - w->spans[i].x0);
    if (!s->draw->stippled) {
        SHEEN_TAP_ROWS(t, s);
        return;
    }
    while (f->stipple->hide(scratch_of(w), t, s))
        SHEEN_TAP_ROWS(t, s);
}

/* Move the first slot of *from to the front of *to; either is the head of a list or a link in one. */
static void move_slot(struct worker *w, uint8_t *from, uint8_t *to)
{
    const uint8_t slot = *from;
    struct setup *s = slot_of(w, slot);

    *from = s->next;
    s->next = *to;
    *to = slot;
}

/*
 * Draw entry e's rows in the tile; returns 0 when the entry is done. *link: where e stands in the carried list, or
 * would stand; it becomes the next entry's place.
 */
static int draw_entry(const struct sheen_frame *f, struct worker *w, struct tile *t, uint32_t e,
                      const struct draw_record *d, uint8_t **link)
{
    uint8_t *place = *link;
    struct setup *s = slot_of(w, *place);
    const int carried = s->entry == e;
    unsigned rows;

    SHEEN_TAP(CARRIED, carried);
    if (carried) {
        rows = sheen_spans(s, t->rect, w->spans);
    } else {
        s = slot_of(w, w->first_free);
        rows = set_up(f, w, t, d, e, s);
        if (rows == 0)
            return 0;
        w->by_way[s->way]++;
    }
    draw_rows(f, w, t, rows, s);
    if (s->end_row <= t->rect.y1 - f->screen.shared_rows) {
        if (carried)
            move_slot(w, place, &w->first_free);
        return 0;
    }
    if (!carried) {
        if (w->first_free > w->most_carried)
            w->most_carried = w->first_free;
        if (w->first_free == f->config.max_carried)
            return 1;
        move_slot(w, &w->first_free, place);
    }
    *link = &s->next;
    return 1;
}

/* The number, 0..31, of the one set bit; on ARMv6-M, where clz32 is a call, by a de Bruijn sequence of 32 bits. */
static inline uint32_t bit_number(uint32_t bit)
{
#if FAST_LOOPS && defined(__ARM_ARCH_6M__)
    static const uint8_t number[32] = {0,  1,  28, 2,  29, 14, 24, 3, 30, 22, 20, 15, 25, 17, 4,  8,
                                       31, 27, 13, 23, 21, 19, 16, 7, 26, 12, 18, 6,  11, 5,  10, 9};
    return number[bit * 0x077cb531u >> 27];
#else
    return 31 - clz32(bit);
#endif
}

static void draw_pending(const struct sheen_frame *f, struct worker *w, struct tile *t)
{
    const struct draw_record *d = f->draw;
    uint8_t *link = &w->first_carried;

    slot_of(w, f->config.max_carried)->entry = NONE; /* the spare slot matches no entry */
    for (uint32_t first = 0; first < f->entries; first += 32) {
        uint32_t bits = w->pending[first / 32], left = bits;
        for (; bits != 0; bits &= bits - 1) {
            const uint32_t lowest = bits & (0u - bits), e = first + bit_number(lowest);
            while (e >= d->end_entry)
                d++;
            if (!draw_entry(f, w, t, e, d, &link))
                left ^= lowest;
        }
        w->pending[first / 32] = left;
    }
}

/* ---- a band ---- */

static void tile_begin(const struct sheen_frame *f, struct worker *w, struct tile *t)
{
    t->pitch = (uint16_t)(t->rect.x1 - t->rect.x0);
    t->dither = f->view.dither;
    t->pixels = w->pixels[w->buffer];
    t->depth = w->depth;
    t->to_pixel = (char *)t->pixels - (char *)t->depth;
    t->format = &f->format;
    t->thresholds = sheen_thresholds;
    t->centre_x = f->screen.centre_x;
    t->centre_y = f->screen.centre_y;
    t->spans = w->spans;
    t->facet.draw = NULL;
#if SHEEN_STATS
    t->shaded = &w->count.shaded;
#endif
}

HOT int sheen_band(struct sheen_frame *f, unsigned worker, unsigned b)
{
    struct tile t;
    int error = sheen_claim_band(f, worker, b);

    /* no entry crosses an empty band, so none is pending below it either */
    if (error < 0 || !band_rect(f, b, &t.rect))
        return error;
    if ((error = sheen_free_buffer(f, worker)) < 0)
        return error;
    struct worker *w = &f->worker[worker];
    const struct sheen_rect rect = t.rect;
    tile_begin(f, w, &t);
    if (f->edges != NULL)
        f->edges->begin(f, w, &t, b);
#if FAST_LOOPS
    t.dither_rows = w->dither_rows;
    sheen_dither_begin(&t, w->dither_rows);
#endif
    collect(f, w, b);
    clear_tile(f, &t);
    draw_pending(f, w, &t);
    if (f->edges != NULL)
        f->edges->draw(f, w, &t, rect);
    if (f->view.overlay != NULL)
        paint(f, &t, f->view.overlay);
    if (f->format.grey)
        sheen_pack_grey(&f->format, t.pixels, t.pitch, (unsigned)(t.rect.y1 - t.rect.y0));
    return sheen_send_tile(f, worker, &t);
}
