/*
 * reflection.h - private: one light over a triangle whose corner normals nearly agree: L.N and 1 - R.V are quadratic
 * on the screen. Of Phong, and of slerp, which it does not differ from by what a level shows up to CLOSE_ARCS.
 */
#ifndef SHEEN_REFLECTION_H
#define SHEEN_REFLECTION_H

#include "quadric.h"

/* A light at the corners, as seen, and how far their normals are apart. */
struct facing {
    int32_t ln[3], nv[3]; /* L.N and N.V, Q0.15 */
    uint32_t h[3];        /* |Ni - Nj|^2 of edges 01, 02, 12, UQ2.30: 2 - 2 cos; less than 4.0 */
    uint32_t apart;       /* the largest of them, of a quad times QUAD_APART */
    const uint16_t *kept; /* a quad's corner 3: what it keeps; NULL: there is none */
};

#define QUAD_APART 5u /* of a quad, sheen_most_bend */

#define CLOSE_ARCS 105105331u /* of `apart`: 18 degrees */

/* |Ni - Nj|^2, UQ.9, up to which diffuse light is a quadric, by the levels that it spans. */
uint8_t sheen_widest_diffuse(const struct colour_terms *t);

/* sheen_loop_begin, and how far normals may be apart, by the levels that diffuse light spans. */
void sheen_reflection_begin(struct draw *d, const struct sheen_material *material, const struct pixel_format *format,
                            const struct sheen_object *object, const struct sheen_pose *view);

/* What a vertex keeps, struct sheen_shader's light: L.N of the first light and N.V, int16_t Q0.15. */
void sheen_keep_cosines(const struct draw *d, const int16_t normal[3], uint16_t kept[2]);

/* |Ni - Nj|^2 of edges 01, 02, 12, UQ2.30; returns the largest. */
uint32_t sheen_normals_apart(const int16_t *const n[3], uint32_t h[3]);

/*
 * Four times what an edge's middle lies above the mean of its ends, Q.16, of a cosine that has these there, Q0.15. h, a
 * quarter of |Ni - Nj|^2, and lean: Q0.18, both below 2^15.
 */
int32_t sheen_cosine_excess(int32_t first, int32_t second, int32_t h, int32_t lean);

/* Of vertices that keep cosines, so not of pieces: the first light; ln of another, which is at `to`. */
void sheen_face(struct facing *f, const struct surface_corners *c);
void sheen_face_light(struct facing *f, const int16_t *const normal[3], int back, const int32_t to[3]);

/*
 * The highest warp of quads that sheen_setup_reflection may take, by their normals: no farther apart than `most` and
 * highlights let. 0: none are, by other than one light, by a ramp or under a strong, sharp highlight.
 */
uint8_t sheen_most_bend(const struct draw *d, uint32_t most);

/* 1 where it takes such a quad, its quadrics those of corners 0 to 2: small, and weights near each other. */
int sheen_reflects_whole(const struct screen *screen, const struct quad *q);

/*
 * Sets way, fast and rows, and what follows *s: out of the light one colour, else quadrics. 0: normals or weights are
 * too far apart, or the triangle is a needle or too small; *s is as it was.
 */
int sheen_setup_reflection(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                           const struct facing *f);

#endif
