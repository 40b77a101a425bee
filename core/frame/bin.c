/*
 * bin.c - which triangles begin in which band, and what each band may touch.
 *
 * A list holds the triangles that begin in its band; bands below find them
 * through their worker's pending bits, which run in submission order.
 */
#include "frame.h"

struct sheen_rect sheen_rect_union(struct sheen_rect a, struct sheen_rect b)
{
    if (rect_empty(a))
        return b;
    if (rect_empty(b))
        return a;
    struct sheen_rect r = {(int16_t)min32(a.x0, b.x0), (int16_t)min32(a.y0, b.y0), (int16_t)max32(a.x1, b.x1),
                           (int16_t)max32(a.y1, b.y1)};
    return r;
}

struct sheen_rect sheen_rect_intersection(struct sheen_rect a, struct sheen_rect b)
{
    struct sheen_rect r = {(int16_t)max32(a.x0, b.x0), (int16_t)max32(a.y0, b.y0), (int16_t)min32(a.x1, b.x1),
                           (int16_t)min32(a.y1, b.y1)};
    return r;
}

/* Pixels whose centres may lie inside: the box of the corners, within the viewport. */
static struct sheen_rect covered(const struct sheen_frame *f, const struct vertex *const v[3])
{
    int32_t left = min32(v[0]->x, min32(v[1]->x, v[2]->x)), right = max32(v[0]->x, max32(v[1]->x, v[2]->x));
    int32_t top = min32(v[0]->y, min32(v[1]->y, v[2]->y)), bottom = max32(v[0]->y, max32(v[1]->y, v[2]->y));
    struct sheen_rect r = {(int16_t)first_centre(target_x(f, left)), (int16_t)first_centre(target_y(f, top)),
                           (int16_t)first_centre(target_x(f, right)), (int16_t)first_centre(target_y(f, bottom))};

    return sheen_rect_intersection(r, f->viewport);
}

static unsigned band_of(const struct sheen_frame *f, int32_t row)
{
    return ((uint32_t)(row - f->viewport.y0) * f->band_scale) >> 20;
}

/* Link an entry into the band where its rectangle begins, and grow the bands it crosses. */
static void link_entry(struct sheen_frame *f, uint32_t entry, struct sheen_rect r)
{
    unsigned first = band_of(f, r.y0), last = band_of(f, r.y1 - 1);

    f->entry[entry].next = f->band[first].first;
    f->band[first].first = (uint16_t)entry;
    for (unsigned b = first; b <= last; b++) {
        struct band *band = &f->band[b];
        band->cover = sheen_rect_union(band->cover, r);
        if (band->back < b - first)
            band->back = (uint16_t)(b - first);
    }
}

/* 1 where a triangle covers the centre of some pixel's column and row. */
int sheen_bin_would_list(const struct sheen_frame *f, const struct vertex *const v[3])
{
    return !rect_empty(covered(f, v));
}

/* 1: listed; 0: covers no pixel centre, or no entry is left, and f->entries_short counts it. */
int sheen_bin_triangle(struct sheen_frame *f, const struct vertex *const v[3], uint32_t triangle, int is_piece)
{
    struct sheen_rect r = covered(f, v);

    if (rect_empty(r))
        return 0;
    if (f->entries == f->config.max_triangles) {
        f->entries_short++;
        return 0;
    }
    uint32_t e = f->entries++;
    f->entry[e].triangle = (uint16_t)triangle;
    if (f->cut != NULL) {
        uint32_t bit = 1u << (e & 31u);
        f->cut[e >> 5] = is_piece ? f->cut[e >> 5] | bit : f->cut[e >> 5] & ~bit;
    }
    link_entry(f, e, r);
    return 1;
}

/* No triangle yet; what the last frame touched is kept. */
void sheen_bin_clear(struct sheen_frame *f)
{
    const struct sheen_rect none = {0, 0, 0, 0};

    for (unsigned b = 0; b < f->bands; b++) {
        f->band[b].first = NONE;
        f->band[b].back = 0;
        f->band[b].cover = none;
    }
}

/* Forget the entries from `entries` on: lists and rectangles as they were. */
void sheen_bin_rollback(struct sheen_frame *f, uint32_t entries)
{
    struct corners c;
    unsigned d = 0;

    sheen_bin_clear(f);
    f->entries = entries;
    for (uint32_t e = 0; e < entries; e++) {
        while (e >= f->draw[d].end_entry)
            d++;
        sheen_entry_corners(f, &f->draw[d], e, &c);
        link_entry(f, e, covered(f, c.v));
    }
}

void sheen_entry_corners(const struct sheen_frame *f, const struct draw_record *d, uint32_t entry, struct corners *c)
{
    static const uint8_t order[3] = {0, 2, 1}; /* meshes are counterclockwise */
    uint32_t id = f->entry[entry].triangle;

    if (f->cut != NULL && (f->cut[entry >> 5] >> (entry & 31u) & 1u) != 0) {
        const struct piece *piece = &f->piece[id];
        c->triangle = piece->triangle;
        for (int k = 0; k < 3; k++) {
            c->v[k] = &piece->corner[order[k]];
            c->normal[k] = piece->normal[order[k]];
        }
        return;
    }
    c->triangle = (uint16_t)id;
    for (uint32_t k = 0; k < 3; k++) {
        uint32_t index = mesh_index(d->as.mesh, 3 * id + order[k]);
        c->v[k] = &f->vertex[d->first_vertex + index];
        c->normal[k] = d->as.mesh->normals != NULL ? d->as.mesh->normals + 3 * index : NULL;
    }
}
