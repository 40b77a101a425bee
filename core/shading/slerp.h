/*
 * slerp.h - private to the room of slerp: its set-up, and its rows, which every way cuts into parts.
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
        int16_t lit[2];    /* with one light: L.N and N.V, Q0.15 */
    };
    uint16_t weight; /* UQ0.16, proportional to 1/m, not 0 */
};

/* Corners from the top down; edges 0, 1, 2 join corners 02, 01 and 12. */
struct slerp_corners {
    struct slerp_corner corner[3];
    uint32_t inverse[3]; /* by edge: 1 / its height in 1/64 px, UQ.31; 0: no row crosses it */
    uint16_t h[3];       /* with one light, by edge: sin^2(p/2), UQ0.15, at most RIGHT_ANGLE; p: the normals' angle */
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

/* The weight of a weighed corner, at least 32: beside a full weight it leaves a normal 16 steps, as in weighted.c. */
static inline uint16_t slerp_weight(const struct surface_corners *c, unsigned k)
{
    return (uint16_t)(c->flat_weight ? 0xffff : max32((int32_t)(c->weight[k] >> 16), 32));
}

/* f: of the one light, whose cosines are kept; NULL: normals are kept. */
void sheen_slerp_corners(struct slerp_corners *s, const struct surface_corners *c, const struct facing *f);

/* ---- rows: slerp_parts.c ---- */

/* A normal at some place on a row, Q0.15, and 1/m there, UQ0.16. */
struct place {
    int32_t part[3];
    uint32_t weight;
};

/* A part of a row, of which columns x to before x1 are drawn. */
struct part {
    int32_t at, length; /* shares of the row before the part and in it, UQ0.15; length 0: one pixel */
    int32_t x, x1, n;   /* n: columns from the part's first one to x; -1 if the span begins one before that */
    int32_t t;          /* where in the part its first column's centre lies, UQ0.15 */
    unsigned up;        /* a pixel is the row's inverse * 2^(up - 31) of the part; at most 15 */
    int fresh;          /* 1: the part before this one was not drawn */
};

/*
 * A row between its crossings with two edges. parts: returns the logarithm of the number of its parts, up to 15; draw:
 * draws one part.
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
            struct place left; /* the end of the part before */
        };
        struct {                      /* with one light: */
            struct arc_series series; /* of the arc of normals */
            int32_t h;                /* of that arc, as in struct slerp_corners */
            int32_t end[2][2];        /* L.N and N.V at the crossings, Q0.15 */
            int32_t lit[3][2];        /* at a part's start, middle and end: L.N, Q0.15; power table's argument / 2^15 */
        };
    };
};

/* Draws the rows of a tile. In *r s, at, parts and draw are set. */
void sheen_slerp_draw(const struct tile *t, struct arc_row *r);

/* For arcs of normals: `parts`; and the normal at a part's first pixel and its step, as in struct normal_run. */
unsigned sheen_slerp_normal_parts(const struct arc_row *r);
void sheen_slerp_normals(struct arc_row *r, const struct part *p, uint32_t n[3], uint32_t dn[3]);

void sheen_slerp_rows(const struct tile *t, const struct setup *s);

#endif
