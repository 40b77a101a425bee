/*
 * morph.h - private: a mesh between two frames of it.
 */
#ifndef SHEEN_MORPH_H
#define SHEEN_MORPH_H

#include "triangle.h"

struct worker;

/* Functions that a struct sheen_morph points to, so that only programs with morphs link them. */
struct sheen_morpher {
    /* 0: the other mesh is no frame of the object's mesh, or the weight is out of range. */
    int (*fits)(const struct sheen_object *object);
    /* first: the vector in the draw's mesh, which is the first frame. */
    void (*position)(const struct draw *d, const int16_t *first, int16_t out[3]);
    void (*normal)(const struct draw *d, const int16_t *first, int16_t out[3]);
    void (*facet)(const struct draw *d, uint32_t triangle, int16_t normal[3]); /* normal: at first the first frame's */
    /* Morphs the normals of an entry's corners, if its set-up reads them; they stay valid until that is made. */
    void (*corners)(const struct draw *d, struct corners *c, const struct worker *w);
    /* Makes the morphed points and normals of a triangle that is cut; the normals are kept in `store`. */
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

/* lit.c: the unit normal, in one frame of `mesh`, of the polygon of a triangle; zero if it has no area. */
void sheen_frame_normal(const struct sheen_mesh *mesh, const struct sheen_mesh *frame, uint32_t triangle,
                        int16_t normal[3]);

#endif
