/*
 * reflection.h - private: one light over a triangle whose corner normals nearly agree: L.N and 1 - R.V are quadratic on
 * the screen. This is for Phong, and for slerp with normals up to CLOSE_ARCS apart, where the two differ by less than
 * shows in a level.
 */
#ifndef SHEEN_REFLECTION_H
#define SHEEN_REFLECTION_H

#include "quadric.h"

/* A light at the corners, for the side that is seen, and how far apart their normals are. */
struct facing {
    int32_t ln[3], nv[3]; /* L.N and N.V, Q0.15 */
    uint32_t h[3];        /* |Ni - Nj|^2 of edges 01, 02, 12, which is 2 - 2 cos, UQ2.30; less than 4.0 */
    uint32_t apart;       /* the largest h, for a quad times QUAD_APART */
    const uint16_t *kept; /* what corner 3 of a quad keeps; NULL: there is none */
};

#define QUAD_APART 5u /* see sheen_most_bend */

#define CLOSE_ARCS 105105331u /* an `apart`: 18 degrees */

/* The largest |Ni - Nj|^2, UQ.9, for which diffuse light is taken as a quadric, by how many levels it spans. */
uint8_t sheen_widest_diffuse(const struct colour_terms *t);

/* sheen_loop_begin, and fills in d->most_apart by sheen_widest_diffuse. */
void sheen_reflection_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                            const struct sheen_object *object, const struct sheen_pose *view);

/* A struct sheen_shader's `light`: a vertex keeps L.N of the first light and N.V, int16_t Q0.15. */
void sheen_keep_cosines(const struct draw *d, const int16_t normal[3], uint16_t kept[2]);

/* |Ni - Nj|^2 of edges 01, 02, 12, UQ2.30; returns the largest. */
uint32_t sheen_normals_apart(const int16_t *const n[3], uint32_t h[3]);

/*
 * A cosine's excess on an edge, 4 (middle - mean of the ends), Q.16. first, second: the cosine at the ends, Q0.15. h (a
 * quarter of |Ni - Nj|^2) and lean: Q0.18, h at most 22,400 (34 degrees) and |lean| at most 2^15.
 */
int32_t sheen_cosine_excess(int32_t first, int32_t second, int32_t h, int32_t lean);

/*
 * For vertices that keep cosines, so not for pieces: fills in *f for the first light; f->ln for another one, at `to`.
 */
void sheen_face(struct facing *f, const struct surface_corners *c);
void sheen_face_light(struct facing *f, const int16_t *const normal[3], int back, const int32_t to[3]);

/*
 * The highest warp of quads that sheen_setup_reflection may take: so high that normals are no farther apart than `most`
 * and highlights allow. 0: no quads, because there is not exactly one light, or a ramp, or a strong and sharp
 * highlight.
 */
uint8_t sheen_most_bend(const struct draw *d, uint32_t most);

/* 1 if it may take such a quad, with quadrics made from corners 0 to 2: small, and weights near each other. */
int sheen_reflects_whole(const struct screen *screen, const struct quad *q);

/*
 * Sets way and rows, and fills in what follows *s: one colour if the light does not reach the triangle, else quadrics.
 * Returns 0 and leaves *s as it was if normals or weights are too far apart, or the triangle is a needle or too small.
 */
int sheen_setup_reflection(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                           const struct facing *f);

#endif
