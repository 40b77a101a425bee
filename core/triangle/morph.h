/*
 * morph.h - private: a mesh between two frames of it.
 */
#ifndef SHEEN_MORPH_H
#define SHEEN_MORPH_H

#include "triangle.h"

struct worker;

/* What a struct sheen_morph points to, so that it is linked where there is one. Vectors are of the draw's mesh. */
struct sheen_morpher {
    int (*fits)(const struct sheen_object *object); /* 0: the other frame is none of its mesh, or the weight wrong */
    void (*position)(const struct draw *d, const int16_t *first, int16_t out[3]);
    void (*normal)(const struct draw *d, const int16_t *first, int16_t out[3]);
    void (*facet)(const struct draw *d, uint32_t triangle, int16_t normal[3]); /* normal: the first frame's */
    /* Normals of an entry's corners, where its set-up reads them; they stand until it is made. */
    void (*corners)(const struct draw *d, struct corners *c, const struct worker *w);
    /* Points and normals of a triangle that is cut; these are in `store`. */
    void (*cut)(const struct draw *d, const struct clip_job *job, uint32_t triangle, const int16_t *normal[3],
                int16_t store[3][3]);
};

static inline const int16_t *position_of(const struct draw *d, const int16_t *first, int16_t store[3])
{
    if (d->morph == NULL)
        return first;
    d->morph->morpher->position(d, first, store);
    return store;
}

static inline const int16_t *normal_of(const struct draw *d, const int16_t *first, int16_t store[3])
{
    if (d->morph == NULL)
        return first;
    d->morph->morpher->normal(d, first, store);
    return store;
}

/* lit.c: unit normal of the polygon that a triangle of `mesh` is of, in a frame of it; zero where it has no area. */
void sheen_frame_normal(const struct sheen_mesh *mesh, const struct sheen_mesh *frame, uint32_t triangle,
                        int16_t normal[3]);

#endif
