/*
 * slerp_row.h - private to the room of slerp: how rows are cut into parts, by any way.
 */
#ifndef SHEEN_SLERP_ROW_H
#define SHEEN_SLERP_ROW_H

#include "slerp.h"

/* A row on its way from crossing to crossing. */
struct arc_row {
    const struct setup *s;
    const struct slerp_corners *at;
    int32_t y, from, width; /* from: the left crossing, px on the target, Q15.16; width > 0 */
    uint32_t inverse;       /* 1 / width = inverse 2^(up - 31), 1/px; 16 bits */
    unsigned up;
    uint32_t weight[2];   /* at the crossings, UQ0.16 */
    int16_t cosine[2][2]; /* there, L.N and N.V, Q0.15, where the way needs them */
    struct arc arc;       /* of normals; else its series alone */
};

/* What lies somewhere on a row: L.N, Q0.15, and the power table's argument / 2^15; or the normal, Q1.30, and 1/m. */
struct place {
    int32_t part[3];
    uint32_t weight; /* UQ0.16 */
};

/* Columns x to before x1 of a part: how much of the row lies before it and how much it is, UQ0.15. */
struct part {
    int32_t at, length;   /* length 0: one pixel */
    int32_t x, x1, first; /* first: the first column after its left end */
    int32_t t;            /* that column's centre in it, UQ0.15 */
    unsigned up;          /* a pixel is the row's inverse 2^(up - 31) of it; at most 15 */
};

/* How a row is drawn: the logarithm of the number of its parts, what lies at their ends, and what between. */
struct arc_way {
    unsigned (*parts)(const struct arc_row *r);
    void (*place)(const struct arc_row *r, int32_t t, struct place *p);
    void (*draw)(const struct tile *t, struct arc_row *r, const struct part *p, const struct place *a,
                 const struct place *b);
};

#define MOST_PARTS 4       /* the logarithm of their number, before perspective adds up to 2 */
#define LEAST_PART 3       /* px: of less, each pixel for itself */
#define WIDEST_NORMALS 159 /* sin^2(p/2), UQ0.15, of the widest parts by normals: 8 degrees */

/* slerp_parts.c: the row at centre, 1/64 px from the viewport's, between edge 02 and `other`; their arcs are `arc`. */
void sheen_slerp_begin_row(const struct tile *t, struct arc_row *r, const struct arc arc[2], unsigned other,
                           int32_t centre);

/* v t / 2^15, |v| < 2^22, t < 2^17 */
static inline int32_t times15(int32_t v, int32_t t)
{
    return asr32(asr32(v, 8) * t, 7) + asr32((v & 255) * t, 15);
}

/* v r / 2^8, |v| < 2^22, r at most 2^16 */
static inline int32_t times8(int32_t v, int32_t r)
{
    return asr32(v, 8) * r + asr32((v & 255) * r, 8);
}

/* d, Q15.16 px, of the row's width: UQ0.15, 0..1.0 */
static int32_t share_of_row(const struct arc_row *r, int32_t d)
{
    if (d <= 0 || d >= r->width)
        return d <= 0 ? 0 : 32768;
    return min32((int32_t)((((uint32_t)d << r->up) >> 16) * r->inverse >> 16), 32768);
}

/* ---- by normals ---- */

static APART void normal_place(const struct arc_row *r, int32_t t, struct place *p)
{
    p->weight = r->weight[0];
    if (!r->at->even)
        t = in_space(t, r->weight[0], r->weight[1], &p->weight);
    sheen_arc_at(&r->arc, t, p->part);
}

/* Times weights the normals are linear on the screen, as they are in space without. */
SPLIT void normals_between(const struct arc_row *r, const struct part *p, const struct place *a, const struct place *b,
                           uint32_t n[3], uint32_t dn[3])
{
    const unsigned up = clz32(a->weight | b->weight) - 16;
    const int32_t w0 = (int32_t)(a->weight << up >> 1), w1 = (int32_t)(b->weight << up >> 1), x = p->x - p->first;

    SHEEN_TAP(NORMAL_PART, 1);
    SHEEN_TAP(SKEWED_PART, !r->at->even);
    for (int i = 0; i < 3; i++) {
        const int32_t from = round15(a->part[i]) * w0, more = asr32(round15(b->part[i]) * w1 - from, 8);
        dn[i] = p->length == 0 ? 0 : (uint32_t)asr32(times8(more, (int32_t)r->inverse), 15 - p->up);
        n[i] = (uint32_t)from + (uint32_t)times15(more, p->t) * 256u + (uint32_t)x * dn[i];
    }
}

SPLIT unsigned normal_parts(const struct arc_row *r)
{
    unsigned parts = r->arc.parts == 2;

    if (r->arc.parts == 0)
        return 15;
    while (parts < MOST_PARTS + 2 && r->arc.h > WIDEST_NORMALS << 2 * (parts - (r->arc.parts - 1u)))
        parts++;
    return parts;
}

/* ---- rows ---- */

/* Parts that would have less than LEAST_PART px: each pixel for itself. */
SPLIT void arc_row(const struct tile *t, struct arc_row *r, const struct span *span, const struct arc_way way)
{
    const unsigned parts = way.parts(r);
    const int32_t width = asr32(r->width, parts), pixels = width < LEAST_PART << 16;
    int32_t begin = r->from;
    struct part p;
    struct place place[2];

    p.at = 0;
    p.length = pixels ? 0 : 1 << (15 - parts);
    p.x = span->x0;
    p.up = pixels ? 0 : r->up + parts;
    p.t = 0;
    while (!pixels && p.at + p.length < 32768 && begin + width <= p.x * 65536 + 32768) {
        p.at += p.length;
        begin += width;
    }
    if (!pixels)
        way.place(r, p.at, &place[0]);
    for (; p.x < span->x1; p.at += p.length, begin += width) {
        if (pixels) {
            p.first = p.x;
            p.x1 = p.x + 1;
            way.place(r, share_of_row(r, p.x * 65536 + 32768 - r->from), &place[0]);
            place[1] = place[0];
        } else {
            const int last = p.at + p.length >= 32768;
            p.x1 = last ? span->x1 : min32(span->x1, asr32(begin + width + 32767, 16));
            p.first = asr32(begin + 32767, 16);
            p.t = (int32_t)((((uint32_t)(p.first * 65536 + 32768 - begin) << p.up) >> 16) * r->inverse >> 16);
            way.place(r, p.at + p.length, &place[1]);
        }
        if (p.x < p.x1) {
            way.draw(t, r, &p, &place[0], &place[1]);
            p.x = p.x1;
        }
        place[0] = place[1];
    }
}

static inline void begin_edge(struct arc *arc, const struct slerp_corners *at, unsigned edge)
{
    sheen_arc_begin(arc, at->normal[sheen_slerp_end[edge][0]], at->normal[sheen_slerp_end[edge][1]]);
}

/* draw: a row. */
SPLIT void arc_rows(const struct tile *t, struct arc_row *r,
                    void (*draw)(const struct tile *t, struct arc_row *r, const struct span *span))
{
    const struct slerp_corners *at = r->at;
    unsigned edge = 0; /* that arc[1] is of */
    struct arc arc[2];

    begin_edge(&arc[0], at, 0);
    for (unsigned i = 0; i < t->rows; i++) {
        r->y = t->first_row + (int32_t)i;
        const int32_t centre = r->y * SUBPIXEL_ONE + SUBPIXEL_HALF - t->centre_y;
        const unsigned other = centre < at->y[1] ? 1 : 2;
        if (t->spans[i].x0 >= t->spans[i].x1)
            continue;
        if (edge != other)
            begin_edge(&arc[1], at, other);
        edge = other;
        sheen_slerp_begin_row(t, r, arc, other, centre);
        draw(t, r, t->spans + i);
    }
}

#endif
