/*
 * shares.h - private: the shares that the corners of a mesh's triangle have in a pixel (barycentric coordinates, linear
 * in space). A set-up keeps these and not the corners' normals and colours, for which it may have no room: rows fetch
 * those from the mesh, once per band.
 */
#ifndef SHEEN_SHARES_H
#define SHEEN_SHARES_H

#include "triangle.h"

/* Planes of weight and of the shares of corners 1 and 2 times weight, UQ2.30; corner 0 has the rest. */
struct shares {
    struct plane weight, part[2];
};

/*
 * Which triangle of the mesh the shares refer to. For a piece it is what sheen_carry_shares gave at each of its
 * corners: the shares of the mesh's corners 1 and 2, 1.0 as 32767, which are linear in between, and the triangle. These
 * stay valid until the frame ends.
 */
union shared_triangle {
    uintptr_t own;             /* the triangle in the mesh */
    const int16_t (*piece)[3]; /* if detail has SHARES_PIECE */
};

struct shares_setup {
    struct setup s; /* detail: SHARES_BACK, SHARES_PIECE */
    union shared_triangle of;
    struct shares shares;
};

#define SHARES_BACK 1u
#define SHARES_PIECE 2u

static inline uint32_t shared_triangle_of(const struct setup *s, union shared_triangle of)
{
    return (s->detail & SHARES_PIECE) != 0 ? (uint16_t)of.piece[0][2] : (uint32_t)of.own;
}

/* A struct sheen_shader's `carry`. With such a shader a corner's `normal` is read for pieces only. */
void sheen_carry_shares(const struct draw *d, uint16_t triangle, int back, int16_t out[3][3]);

/* Fills in of, shares and s.detail, and weighs the corners. g NULL: the same shares everywhere, the corners' mean. */
void sheen_setup_shares(struct shares_setup *s, struct surface_corners *c, const struct gradients *g);

/*
 * By corner and part, for sheen_shared. Normals: the mesh's, morphed, for the side that is seen, Q0.15; those of pieces
 * are interpolated linearly, so they are not unit vectors. Colours: UQ0.15, 1.0 as 32767; white if the mesh has none.
 */
void sheen_shared_normals(const struct setup *s, union shared_triangle of, int16_t normal[3][3]);
void sheen_shared_colors(const struct setup *s, union shared_triangle of, int16_t color[3][3]);

/* All three shares times weight, Q2.30, at a pixel of the triangle. */
static inline void shares_at(const struct shares *p, int32_t x, int32_t y, int32_t share[3])
{
    share[1] = (int32_t)plane_at(&p->part[0], x, y);
    share[2] = (int32_t)plane_at(&p->part[1], x, y);
    share[0] = (int32_t)((plane_at(&p->weight, x, y) - (uint32_t)share[1]) - (uint32_t)share[2]);
}

/* The shares' steps per pixel of a row: right within the triangle, because shares are 0 to 1.0 at both pixels. */
static inline void shares_step(const struct shares *p, int32_t step[3])
{
    step[1] = (int32_t)p->part[0].dx;
    step[2] = (int32_t)p->part[1].dx;
    step[0] = (int32_t)((p->weight.dx - (uint32_t)step[1]) - (uint32_t)step[2]);
}

/* Corners' numbers weighted by shares: numbers / 2^15 times weight, Q1.30; from shares' steps, its step per pixel. */
static inline void sheen_shared(const int32_t share[3], int16_t number[3][3], uint32_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = 2u * ((uint32_t)mul_16_32(number[0][i], share[0]) + (uint32_t)mul_16_32(number[1][i], share[1]) +
                       (uint32_t)mul_16_32(number[2][i], share[2]));
}

#endif
