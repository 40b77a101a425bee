/*
 * slerp.h - private to the room of slerp: its set-up, and how rows are cut into parts, by any way.
 */
#ifndef SHEEN_SLERP_H
#define SHEEN_SLERP_H

#include "../math/arc.h"
#include "../triangle/reflection.h"
#include "shading.h"

struct slerp_corner {
    int16_t x, y; /* as in struct vertex */
    union {
        int16_t normal[3]; /* as seen, 1.0 = 32767 */
        int16_t lit[2];    /* by one light: L.N and N.V, Q0.15 */
    };
    uint16_t weight; /* UQ0.16, proportional to 1/m, not 0 */
};

/* Corners from the top down; edges 02, 01 and 12 of them. */
struct slerp_corners {
    struct slerp_corner corner[3];
    uint32_t inverse[3]; /* 1 / an edge's height, UQ.31, 1/64 px; 0: no row crosses it */
    uint16_t h[3];       /* by one light, of edges: sin^2(p/2), UQ0.15, at most RIGHT_ANGLE */
    uint8_t even;        /* no perspective: all weights are equal */
    uint8_t long_right;  /* edge 02 bounds the right */
};

struct slerp_setup {
    struct setup s;
    struct slerp_corners at;
};

static inline const struct slerp_corner *upper_end(const struct slerp_corners *at, unsigned edge)
{
    return &at->corner[edge >> 1];
}

static inline const struct slerp_corner *lower_end(const struct slerp_corners *at, unsigned edge)
{
    return &at->corner[2 - (edge & 1u)];
}

/* Of a weighed corner; the least is what rounding leaves a normal of where another corner has all of it. */
static inline uint16_t slerp_weight(const struct surface_corners *c, unsigned k)
{
    return (uint16_t)(c->flat_weight ? 0xffff : max32((int32_t)(c->weight[k] >> 16), 32));
}

/* f: of one light; else NULL, and normals are what is kept. */
void sheen_slerp_corners(struct slerp_corners *s, const struct surface_corners *c, const struct facing *f);

/* ---- rows: slerp_parts.c ---- */

/* A normal somewhere on a row, Q0.15, and 1/m, UQ0.16. */
struct place {
    int32_t part[3];
    uint32_t weight;
};

/* Columns x to before x1 of a part: how much of the row lies before it and how much it is, UQ0.15. */
struct part {
    int32_t at, length; /* length 0: one pixel */
    int32_t x, x1, n;   /* n: from the first column after the part's left end to x; -1 where a span begins before it */
    int32_t t;          /* that column's centre in it, UQ0.15 */
    unsigned up;        /* a pixel is the row's inverse 2^(up - 31) of it; at most 15 */
    int fresh;          /* the part before it was not drawn */
};

/*
 * A row on its way from crossing to crossing. parts, draw: the logarithm of the number of its parts, up to 15, and how
 * one is drawn.
 */
struct arc_row {
    const struct setup *s;
    const struct slerp_corners *at;
    unsigned (*parts)(const struct arc_row *r);
    void (*draw)(const struct tile *t, struct arc_row *r, const struct part *p);
    int32_t y, from, width; /* from: the left crossing, px on the target, Q15.16; width > 0 */
    uint32_t inverse;       /* 1 / width = inverse 2^(up - 31), 1/px; 16 bits */
    unsigned up;
    uint32_t weight[2]; /* at the crossings, UQ0.16 */
    union {
        struct {
            struct arc arc;    /* of normals */
            struct place left; /* where the part before ended */
        };
        struct {                      /* by one light: */
            struct arc_series series; /* of the arc of normals; */
            int32_t h;                /* as in struct slerp_corners; */
            int32_t end[2][2];        /* at the crossings: L.N and N.V, Q0.15; */
            int32_t lit[3][2];        /* where a part begins, its middle and end: L.N, Q0.15; argument / 2^15 */
        };
    };
};

/* With s, at, parts and draw. */
void sheen_slerp_draw(const struct tile *t, struct arc_row *r);

/* By normals: `parts`, and as struct normal_run has them at a part's first pixel. */
unsigned sheen_slerp_normal_parts(const struct arc_row *r);
void sheen_slerp_normals(struct arc_row *r, const struct part *p, uint32_t n[3], uint32_t dn[3]);

void sheen_slerp_rows(const struct tile *t, const struct setup *s);

#endif
