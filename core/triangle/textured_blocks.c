/*
 * textured_blocks.c - rows of textured triangles; in perspective, blocks of 8 px or less are exact at their ends and
 * linear in between.
 */
#include "../math/inverse.h"
#include "textured.h"

/* An attribute at (x, y), divided by the weight there. up: as in struct textured_setup; 0 for light and specular. */
static inline uint32_t quotient_of(struct inverse i, const struct plane *p, int32_t x, int32_t y, unsigned up)
{
    int32_t half = over(i, (int32_t)(plane_at(p, x, y) << i.up));

    return up > 0 ? (uint32_t)asr32(half, up - 1) : (uint32_t)half * 2;
}

/* Exact values at pixel (x, y); *weight: what they were divided by. */
HOT static APART struct inverse quotients_at(const struct textured_setup *s, int32_t x, int32_t y, struct texel_at *at,
                                             uint32_t *weight)
{
    *weight = plane_at(&s->weight, x, y) | 1u;
    struct inverse i = inverse_of(*weight);
    const unsigned up = s->s.detail;

    SHEEN_TAP(SKEWED_END, 1);
    SHEEN_TAP(SKEWED_LIGHT_END, !s->s.draw->texel.unlit);
    at->u = quotient_of(i, &s->u, x, y, up);
    at->v = quotient_of(i, &s->v, x, y, up);
    at->light = s->light.base;
    at->specular = 0;
    if (!s->s.draw->texel.unlit) {
        at->light = quotient_of(i, &s->light, x, y, 0);
        at->specular = quotient_of(i, &s->specular, x, y, 0);
    }
    return i;
}

#define BLOCK 8 /* px */

static uint32_t change_of(uint32_t from, uint32_t to, unsigned shift)
{
    return magnitude32((int32_t)(to - from)) >> shift;
}

/*
 * How far linear interpolation between two ends is off: the largest change of a value times the relative change of 1/m,
 * over 4; returned in 2^-21 texel / 4. Light of 1.0 counts as 256 texels, so that 1/32 texel is 1/8192.
 */
static uint32_t off_by(const struct texel_at *from, const struct texel_at *to, uint32_t weight, uint32_t next_weight,
                       struct inverse i, struct inverse next)
{
    uint32_t most = change_of(from->u, to->u, 10), v = change_of(from->v, to->v, 10);
    uint32_t light = change_of(from->light, to->light, LIGHT_BITS - 14);
    uint32_t specular = change_of(from->specular, to->specular, LIGHT_BITS - 14);
    uint32_t less = weight < next_weight ? weight : next_weight, change = (weight ^ next_weight ^ less) - less;
    struct inverse more = weight < next_weight ? i : next;

    most = v > most ? v : most;
    most = light > most ? light : most;
    most = specular > most ? specular : most;
    most = most < 65535 ? most : 65535;
    if (change >= less)
        return most << 15;
    return most * (((change << more.up) >> 16) * more.seed >> 16);
}

/* The block being drawn. */
struct block {
    struct texel_at at, step, end; /* end: exact values where the next block begins */
    struct inverse inverse;        /* of weight, at the same pixel */
    uint32_t weight;
};

/* (to - from) / count, count 1..8. */
static uint32_t share_of(uint32_t from, uint32_t to, uint32_t count)
{
    static const uint16_t part[BLOCK + 1] = {0, 0, 32768, 21845, 16384, 13107, 10923, 9362, 8192}; /* 2^16 / count */
    const int32_t difference = (int32_t)(to - from);

    return (uint32_t)(count == 1 ? difference : mul_16_32(part[count], difference));
}

static void block_steps(struct block *b, uint32_t count)
{
    b->step.u = share_of(b->at.u, b->end.u, count);
    b->step.v = share_of(b->at.v, b->end.v, count);
    b->step.light = share_of(b->at.light, b->end.light, count);
    b->step.specular = share_of(b->at.specular, b->end.specular, count);
}

#define OFF_LIMIT (1u << 18) /* 1/32 texel, see off_by */

/*
 * Makes the block that begins at pixel (x, y), whose exact values are in b->end; returns its pixels, at most `left`.
 * The row's last block ends at the row's last pixel, because beyond the triangle weights may be invalid.
 */
HOT static int32_t next_block(const struct textured_setup *s, struct block *b, int32_t x, int32_t y, int32_t left)
{
    int32_t count = min32(left, BLOCK), to = min32(left - 1, BLOCK);
    struct inverse i = b->inverse;
    uint32_t weight = b->weight;

    SHEEN_TAP(SKEWED_BLOCK, 1);
    b->at = b->end;
    b->at.z = plane_at(&s->s.depth, x, y);
    if (to == 0)
        return count;
    b->inverse = quotients_at(s, x + to, y, &b->end, &b->weight);
    uint32_t off = off_by(&b->at, &b->end, weight, b->weight, i, b->inverse);
    if (off > OFF_LIMIT && to > 1) {
        for (; off > OFF_LIMIT && to > 1; off >>= 2)
            to /= 2;
        count = to;
        b->inverse = quotients_at(s, x + to, y, &b->end, &b->weight);
    }
    block_steps(b, (uint32_t)to);
    return count;
}

static void block_runs(const struct textured_setup *s, struct texel_run *r)
{
    int32_t left = r->count;
    struct block b;

    b.inverse = quotients_at(s, r->x, r->y, &b.end, &b.weight);
    b.step = (struct texel_at){s->s.depth.dx, 0, 0, 0, 0};
    do {
        r->count = next_block(s, &b, r->x, r->y, left);
        sheen_textured_step(r, &b.step);
        sheen_textured_run(r, &b.at);
        left -= r->count;
        r->x += r->count;
        r->depth += r->count;
    } while (left > 0);
}

static void linear_run(const struct textured_setup *s, const struct texel_run *r)
{
    struct texel_at at = {plane_at(&s->s.depth, r->x, r->y), plane_at(&s->u, r->x, r->y), plane_at(&s->v, r->x, r->y),
                          s->light.base, 0};

    if (!r->d->texel.unlit) {
        at.light = plane_at(&s->light, r->x, r->y);
        at.specular = plane_at(&s->specular, r->x, r->y);
    }
    sheen_textured_run(r, &at);
}

HOT void sheen_textured_blocks(const struct tile *t, const struct setup *s)
{
    const struct textured_setup *textured = (const struct textured_setup *)s;
    const struct texel_at step = {s->depth.dx, textured->u.dx, textured->v.dx, textured->light.dx,
                                  textured->specular.dx};
    struct texel_run r;

    sheen_textured_begin(&r, t, s);
    if (s->way == SHEEN_WAY_TEXTURED_LINEAR)
        sheen_textured_step(&r, &step);
    for (unsigned row = 0; row < t->rows; row++) {
        r.x = t->spans[row].x0;
        r.y = t->first_row + (int32_t)row;
        r.count = t->spans[row].x1 - r.x;
        if (r.count <= 0)
            continue;
        r.depth = t->depth + tile_offset(t, r.x, r.y);
        if (s->way == SHEEN_WAY_TEXTURED_LINEAR)
            linear_run(textured, &r);
        else
            block_runs(textured, &r);
    }
}
