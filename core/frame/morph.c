/*
 * morph.c - a mesh between two frames of it, computed for each vertex when it is needed; nothing is stored.
 */
#include "../math/vector.h"
#include "frame.h"

#define WHOLE 32768 /* weight of the second frame alone */

/* (1 - k) first + k second, Q.15. Range: |.| <= 2^30. */
static int32_t morphed(uint32_t weight, int32_t first, int32_t second)
{
    return (int32_t)(WHOLE - weight) * first + (int32_t)weight * second;
}

static void morph_position(const struct draw *d, const int16_t *first, int16_t out[3])
{
    const int16_t *second = d->morph->mesh->positions + (first - d->mesh->positions);

    SHEEN_TAP(MORPHED, 1);
    for (int k = 0; k < 3; k++)
        out[k] = (int16_t)asr32(morphed(d->morph->weight, first[k], second[k]) + WHOLE / 2, 15);
}

/*
 * Normals between two, of unit length, 1.0 = 32767 as in a mesh: if it were 32768, opposite normals would lie 2.0
 * apart, and the square of that would wrap. The result is `first` if the two cancel or the weight is 0.
 */
static void mix_normals(uint32_t weight, const int16_t first[3], const int16_t second[3], int16_t out[3])
{
    int64_t sum[3];
    sheen_q30_t n[3];

    SHEEN_TAP(MORPHED_NORMAL, 1);
    for (int k = 0; k < 3; k++)
        sum[k] = morphed(weight, first[k], second[k]);
    const int known = weight != 0 && sheen_normalize_wide(sum, n) == SHEEN_OK;
    for (int k = 0; k < 3; k++)
        out[k] = known ? (int16_t)asr32(n[k] - asr32(n[k], 15) + (1 << 14), 15) : first[k];
}

static void morph_normal(const struct draw *d, const int16_t *first, int16_t out[3])
{
    mix_normals(d->morph->weight, first, d->morph->mesh->normals + (first - d->mesh->normals), out);
}

static void morph_facet(const struct draw *d, uint32_t triangle, int16_t normal[3])
{
    int16_t second[3];

    sheen_frame_normal(d->mesh, d->morph->mesh, triangle, second);
    mix_normals(d->morph->weight, normal, second, normal);
}

/* Pieces store normals that are morphed already. */
static void morph_corners(const struct draw *d, struct corners *c, const struct worker *w)
{
    int16_t(*store)[3] = scratch_of(w);

    if (!d->shader->reads_normals || (c->v[0]->flags & LIT_AS_SEEN) != 0)
        return;
    for (int k = 0; k < 3; k++)
        c->normal[k] = normal_of(d, c->normal[k], store[k]);
}

static void morph_cut(const struct draw *d, const struct clip_job *job, uint32_t triangle, const int16_t *normal[3],
                      int16_t store[3][3])
{
    struct clip_corner *corner = job->polygon;

    for (uint32_t k = 0; k < 3; k++) {
        const int16_t *first = d->mesh->positions + 3 * mesh_index(d->mesh, 3 * triangle + k);
        corner[k].point = sheen_transform_point(job->transform, position_of(d, first, store[k]));
        if (normal[k] != NULL)
            normal[k] = normal_of(d, normal[k], store[k]);
    }
}

/* 1 if b's vertices can replace a's. */
static int same_shape(const struct sheen_mesh *a, const struct sheen_mesh *b)
{
    return b->positions != NULL && a->vertices == b->vertices && a->triangles == b->triangles && a->scale == b->scale &&
           a->offset[0] == b->offset[0] && a->offset[1] == b->offset[1] && a->offset[2] == b->offset[2];
}

static COLD int morph_fits(const struct sheen_object *o)
{
    const struct sheen_morph *m = o->morph;

    return m->mesh != NULL && m->weight <= WHOLE && same_shape(o->mesh, m->mesh) &&
           (o->mesh->normals == NULL || m->mesh->normals != NULL) &&
           (o->mesh->polygon_normals == NULL || m->mesh->polygon_normals != NULL);
}

const struct sheen_morpher sheen_morpher = {morph_fits,  morph_position, morph_normal,
                                            morph_facet, morph_corners,  morph_cut};
