/*
 * texel_loops.h - private: loops over runs of nearest and of bilinear texels, to be specialised by a way.
 */
#ifndef SHEEN_TEXEL_LOOPS_H
#define SHEEN_TEXEL_LOOPS_H

#include "texel_way.h"

/* The end of the next part of a run, within which nothing is mended. */
SPECIALISED const uint16_t *part_end(const uint16_t *depth, const uint16_t *last, const struct texel_way *way)
{
    return (way->uv_packed || way->dither) && last - depth > TEXEL_PART ? depth + TEXEL_PART : last;
}

/* ---- nearest texels ---- */

SPECIALISED uint32_t lit_texel(uint32_t texel, uint32_t light, struct added more, unsigned glossy)
{
    return rounded_texel((texel >> 11) * light + more.red, (texel >> 5 & 63u) * light + more.green,
                         (texel & 31u) * light + more.blue, glossy);
}

SPECIALISED void put_nearest(uint16_t *depth, const struct stepped *at, uint32_t texel, const struct texel_way *way)
{
    if (way->faded) {
        *pixel_at(depth, way->to_pixel) =
            pixel_order(faded_texel(depth, texel, at->fog >> (LIGHT_BITS - 11), way), way->swap);
        return;
    }
    if (way->lit)
        texel = lit_texel(texel, at->light, added_at(at, threshold_at(depth, way), way), way->glossy);
    *pixel_at(depth, way->to_pixel) = pixel_order(texel, way->swap);
}

SPECIALISED void nearest_loop(const struct texel_run *r, const struct texel_part *part, struct texel_way *way)
{
    const struct texel_at *from = part->from, *by = part->step;
    const unsigned width = r->d->texel.texture->width_log2, down = way->other ? 0 : 1;
    const uint8_t *texels = r->d->texel.texture->texels;
    const uint32_t columns = r->columns << down, rows = r->rows << down, mend = way->uv_packed ? r->mend : 0;
    const struct stepped step = {
        by->z, by->light, by->specular, part->fog_step, way->uv_packed ? r->packed_step : by->u, by->v << width};
    struct stepped at = {
        from->z,         from->light, from->specular, part->fog, way->uv_packed ? packed_at(from, width) : from->u,
        from->v << width};
    uint16_t *depth = part->depth;
    const uint16_t *last = depth + part->count;

    way_begin(way, r);
    for (;;) {
        const uint16_t *end = part_end(depth, last, way);
        do {
            const uint32_t row = way->uv_packed ? at.u >> (2 * PACKED_BITS - down) : at.v >> (16 - down);
            const uint32_t n = (at.u >> ((way->uv_packed ? PACKED_BITS : 16) - down) & columns) | (row & rows);
            if (!way->other ? nearer(r->t, depth, at.z)
                            : !is_key(texel_at(texels, n, way), way) && nearer(r->t, depth, at.z))
                put_nearest(depth, &at, texel_at(texels, n, way), way);
            step_on(&at, &step, way);
        } while (++depth != end);
        if (end == last)
            return;
        at.u += mend;
    }
}

SPECIALISED void nearest_part(const struct texel_run *r, struct texel_part part, struct texel_way way)
{
    nearest_loop(r, &part, &way);
}

/* ---- bilinear ---- */

/* Rounds channels in 1/32 level, each in its place in the word. */
SPECIALISED uint32_t unlit_mixed(uint32_t sum, const struct texel_way *way, uint32_t threshold)
{
    sum = (sum + (way->dither ? (threshold >> (LIGHT_BITS - 5)) * 0x00200801u : 0x02008010u)) >> 5 & way->spread;
    return sum >> 16 | sum; /* bits are left above the 565 value */
}

SPECIALISED uint32_t lit_mixed(uint32_t sum, uint32_t light, struct added more, unsigned glossy)
{
    light >>= 5;
    return rounded_texel((sum >> 11 & 1023u) * light + more.red, (sum >> 21) * light + more.green,
                         (sum & 1023u) * light + more.blue, glossy);
}

/* How the four texels of a pixel are addressed; in the units of texel_at. */
struct bilinear_at {
    const uint8_t *texels;
    uint32_t columns, rows;
    uint32_t below; /* to the next row */
    unsigned width;
};

/*
 * Four neighbouring texels, spread, as terms of a mix; pixels of a row that lie between the same four share them. With
 * shares a and b in 1/32 the mix is first + a * right + b * below + ab / 32 * both, modulo 2^32; first is 32 times the
 * upper left texel. u, v: the coordinates for which the texels were read, less half a texel.
 */
struct texel_cell {
    uint32_t u, v, first, right, below, both;
};

SPECIALISED int in_texel_cell(const struct texel_cell *c, const struct stepped *at, const struct bilinear_at *b,
                              const struct texel_way *way)
{
    if (way->uv_packed) /* all bits but the fractions */
        return ((c->u ^ at->u) & ~(((1u << PACKED_BITS) - 1) * ((1u << (PACKED_BITS + b->width)) + 1))) == 0;
    return ((c->u ^ at->u) | (c->v ^ at->v)) >> 16 == 0;
}

SPECIALISED uint32_t spread_at(const struct bilinear_at *b, uint32_t n, const struct texel_way *way)
{
    uint32_t texel = texel_at(b->texels, n, way);

    return (texel | texel << 16) & way->spread;
}

SPECIALISED void texel_cell_at(struct texel_cell *c, const struct stepped *at, const struct bilinear_at *b,
                               const struct texel_way *way)
{
    const unsigned down = way->other ? 0 : 1;
    const uint32_t left = at->u >> ((way->uv_packed ? PACKED_BITS : 16) - down) & b->columns;
    const uint32_t top =
        (way->uv_packed ? at->u >> (2 * PACKED_BITS - down) : at->v >> (16 - down - b->width)) & b->rows;
    const uint32_t right = (left + (1u << down)) & b->columns, below = (top + b->below) & b->rows;
    const uint32_t first = spread_at(b, top + left, way), second = spread_at(b, top + right, way);

    SHEEN_TAP(TEXEL_CELL, 1);
    c->u = at->u;
    c->v = at->v;
    c->first = first << 5;
    c->right = second - first;
    c->below = spread_at(b, below + left, way) - first;
    c->both = spread_at(b, below + right, way) - second - c->below;
}

SPECIALISED uint32_t cell_mixed(const struct texel_cell *c, const struct stepped *at, const struct bilinear_at *b,
                                const struct texel_way *way)
{
    const uint32_t x = (way->uv_packed ? at->u >> (PACKED_BITS - 5) : at->u >> 11) & 31u;
    const uint32_t y = (way->uv_packed ? at->u >> (2 * PACKED_BITS - 5 + b->width) : at->v >> 11) & 31u;

    return c->first + x * c->right + y * c->below + ((x * y + 16) >> 5) * c->both;
}

SPECIALISED void put_mixed(uint16_t *depth, const struct stepped *at, uint32_t sum, const struct texel_way *way)
{
    const uint32_t threshold = threshold_at(depth, way);
    const uint32_t value = way->lit ? lit_mixed(sum, at->light, added_at(at, threshold, way), way->glossy)
                                    : unlit_mixed(sum, way, threshold);

    *pixel_at(depth, way->to_pixel) = pixel_order(value, way->swap);
}

SPECIALISED void bilinear_loop(const struct texel_run *r, const struct texel_part *part, struct texel_way *way)
{
    const struct texel_at *from = part->from, *by = part->step;
    const unsigned width = r->d->texel.texture->width_log2, down = way->other ? 0 : 1;
    const struct bilinear_at b = {r->d->texel.texture->texels, r->columns << down, r->rows << down,
                                  1u << (width + down), width};
    const struct texel_at middle = {from->z, from->u + TO_MIDDLE, from->v + TO_MIDDLE, from->light, from->specular};
    const struct stepped step = {
        by->z, by->light, by->specular, part->fog_step, way->uv_packed ? r->packed_step : by->u, by->v};
    struct stepped at = {
        from->z, from->light, from->specular, part->fog, way->uv_packed ? packed_at(&middle, width) : middle.u,
        middle.v};
    uint16_t *depth = part->depth;
    const uint16_t *last = depth + part->count;
    struct texel_cell cell = {~at.u, ~at.v, 0, 0, 0, 0}; /* none yet */

    way_begin(way, r);
    for (;;) {
        const uint16_t *end = part_end(depth, last, way);
        do {
            if (nearer(r->t, depth, at.z)) {
                if (!in_texel_cell(&cell, &at, &b, way))
                    texel_cell_at(&cell, &at, &b, way);
                put_mixed(depth, &at, cell_mixed(&cell, &at, &b, way), way);
            }
            step_on(&at, &step, way);
        } while (++depth != end);
        if (end == last)
            return;
        at.u += way->uv_packed ? r->mend : 0;
    }
}

SPECIALISED void bilinear_part(const struct texel_run *r, struct texel_part part, struct texel_way way)
{
    bilinear_loop(r, &part, &way);
}

#endif
