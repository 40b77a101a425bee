/*
 * bin.c - which triangles begin in which band, and what each band may touch.
 *
 * A band's list holds the triangles that begin in it; the bands below find these triangles through their worker's
 * pending bits, which run in submission order.
 */
#include "frame.h"

void sheen_rect_unite(struct sheen_rect *r, const struct sheen_rect *with)
{
    r->x0 = (int16_t)min32(r->x0, with->x0);
    r->y0 = (int16_t)min32(r->y0, with->y0);
    r->x1 = (int16_t)max32(r->x1, with->x1);
    r->y1 = (int16_t)max32(r->y1, with->y1);
}

void sheen_rect_cut(struct sheen_rect *r, const struct sheen_rect *by)
{
    r->x0 = (int16_t)max32(r->x0, by->x0);
    r->y0 = (int16_t)max32(r->y0, by->y0);
    r->x1 = (int16_t)min32(r->x1, by->x1);
    r->y1 = (int16_t)min32(r->y1, by->y1);
}

void sheen_rect_align(struct sheen_rect *r, const struct sheen_target *target)
{
    const int x = (int)or_default(target->align_x, 1), y = (int)or_default(target->align_y, 1);

    r->x0 = (int16_t)(r->x0 & -x);
    r->y0 = (int16_t)(r->y0 & -y);
    r->x1 = (int16_t)((r->x1 + x - 1) & -x);
    r->y1 = (int16_t)((r->y1 + y - 1) & -y);
}

void sheen_band_strip(const struct sheen_frame *f, unsigned b, struct sheen_rect *strip)
{
    const int32_t rows = f->config.band_rows;

    *strip = f->viewport;
    strip->y0 = (int16_t)(strip->y0 + (int32_t)b * rows);
    strip->y1 = (int16_t)min32(strip->y0 + rows, strip->y1);
}

/* Columns and rows, [x0, x1) by [y0, y1). */
struct box {
    int32_t x0, y0, x1, y1;
};

/* The pixels whose centres may lie inside: the bounding box of the corners, cut to the viewport. */
static inline struct box covered(const struct sheen_frame *f, const struct vertex *const v[4], unsigned flags)
{
    const int32_t across = f->screen.centre_x + SUBPIXEL_HALF - 1, down = f->screen.centre_y + SUBPIXEL_HALF - 1;
    struct box b = {min32(v[0]->x, min32(v[1]->x, v[2]->x)), min32(v[0]->y, min32(v[1]->y, v[2]->y)),
                    max32(v[0]->x, max32(v[1]->x, v[2]->x)), max32(v[0]->y, max32(v[1]->y, v[2]->y))};

    if (v[3] != NULL)
        b = (struct box){min32(b.x0, v[3]->x), min32(b.y0, v[3]->y), max32(b.x1, v[3]->x), max32(b.y1, v[3]->y)};
    b.x0 = asr32(b.x0 + across, SUBPIXEL_BITS);
    b.y0 = asr32(b.y0 + down, SUBPIXEL_BITS);
    b.x1 = asr32(b.x1 + across, SUBPIXEL_BITS);
    b.y1 = asr32(b.y1 + down, SUBPIXEL_BITS);
    if ((flags & OFF_VIEW) != 0) {
        b.x0 = max32(b.x0, f->viewport.x0);
        b.y0 = max32(b.y0, f->viewport.y0);
        b.x1 = min32(b.x1, f->viewport.x1);
        b.y1 = min32(b.y1, f->viewport.y1);
    }
    return b;
}

static inline int box_empty(struct box b)
{
    return b.x0 >= b.x1 || b.y0 >= b.y1;
}

static unsigned band_of(const struct sheen_frame *f, int32_t row)
{
    return ((uint32_t)(row - f->viewport.y0) * f->band_scale) >> 20;
}

static inline void cover(struct sheen_rect *r, struct box b)
{
    if (b.x0 < r->x0)
        r->x0 = (int16_t)b.x0;
    if (b.y0 < r->y0)
        r->y0 = (int16_t)b.y0;
    if (b.x1 > r->x1)
        r->x1 = (int16_t)b.x1;
    if (b.y1 > r->y1)
        r->y1 = (int16_t)b.y1;
}

/*
 * Link a triangle or quad into the list of the band where its box begins, and add the box to the `cover` of all bands
 * that it crosses. If no entry is left, f->entries_short counts it. v[3]: a quad's fourth corner, else NULL; a quad's
 * `triangle` includes QUAD. flags: those of all corners, joined by or, and LIT_AS_SEEN for a piece only. Returns 0 if
 * the box holds no pixel's centre.
 */
int sheen_bin_triangle(struct sheen_frame *f, const struct vertex *const v[4], uint32_t triangle, unsigned flags)
{
    struct box b = covered(f, v, flags);
    uint32_t e = f->entries;

    if (box_empty(b))
        return 0;
    if (e == f->config.max_triangles) {
        f->entries_short++;
        return 1;
    }
    f->entries = e + 1;
    if (f->cut != NULL) {
        uint32_t bit = 1u << (e & 31u);
        f->cut[e >> 5] = (flags & LIT_AS_SEEN) != 0 ? f->cut[e >> 5] | bit : f->cut[e >> 5] & ~bit;
    }
    unsigned first = band_of(f, b.y0), more = band_of(f, b.y1 - 1) - first;
    struct band *band = &f->band[first];
    f->entry[e].triangle = (uint16_t)triangle;
    f->entry[e].next = band->first;
    band->first = (uint16_t)e;
    for (unsigned back = 0; back <= more; back++, band++) {
        cover(&band->cover, b);
        if (band->back < back)
            band->back = (uint16_t)back;
    }
    return 1;
}

void sheen_bin_cover(struct sheen_frame *f, struct sheen_rect rect)
{
    const struct box b = {rect.x0, rect.y0, rect.x1, rect.y1};

    for (unsigned i = band_of(f, b.y0), last = band_of(f, b.y1 - 1); i <= last; i++)
        cover(&f->band[i].cover, b);
}

/* Empty the bands' lists and covers; what is stale is kept. */
void sheen_bin_clear(struct sheen_frame *f)
{
    for (unsigned b = 0; b < f->bands; b++) {
        f->band[b].first = NONE;
        f->band[b].back = 0;
        f->band[b].cover = NO_RECT;
    }
}

/* Forget the entries from `entries` on: list those before again under their numbers, and restore the bands' covers. */
COLD void sheen_bin_rollback(struct sheen_frame *f, uint32_t entries)
{
    struct corners c;
    unsigned d = 0;

    sheen_bin_clear(f);
    f->entries = 0;
    for (uint32_t e = 0; e < entries; e++) {
        while (e >= f->draw[d].end_entry)
            d++;
        sheen_entry_corners(f, &f->draw[d], e, &c);
        (void)sheen_bin_triangle(f, c.v, f->entry[e].triangle, OFF_VIEW | c.v[0]->flags);
    }
    if (f->edges != NULL)
        f->edges->cover(f, 0);
}

HOT void sheen_entry_corners(const struct sheen_frame *f, const struct draw_record *d, uint32_t entry,
                             struct corners *c)
{
    const uint32_t id = f->entry[entry].triangle;

    if (is_cut(f, entry)) {
        f->config.clipper->corners(&f->piece[id], c);
        return;
    }
    if (is_quad(d, id)) {
        f->config.quads->corners(f, d, id & (QUAD - 1), c);
        return;
    }
    const struct sheen_mesh *mesh = d->as.mesh;
    const int16_t *own = corner_parts(mesh, d->as.shader);
    const uint32_t parts = d->as.shader->needs_uvs ? 2 : 3;
    c->triangle = (uint16_t)id;
    c->v[3] = NULL;
    UNROLLED
    for (uint32_t k = 0; k < 3; k++) {
        uint32_t index = mesh_index(mesh, 3 * id + clockwise_corner(k));
        c->v[k] = used_vertex(f, d, index);
        c->normal[k] = own + parts * index;
    }
}
