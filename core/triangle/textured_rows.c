/*
 * textured_rows.c - runs of texels, which take the place of a base colour.
 */
#include "fog.h"
#include "texels.h"
#include "textured.h"

/*
 * How coordinates are stepped. For small pictures that repeat they are packed: V above U in one word, both with
 * PACKED_BITS of fraction; a carry out of U adds only 2^-PACKED_BITS texel to V. Along RUN px, packed steps are off by
 * at most 2^-6 texel; after every RUN px that is mended. Otherwise U and V are stepped as they are.
 */
#define PACKED_BITS 10
#define RUN TEXEL_PART

/* U's step is brought into -width/2 .. width/2, because a step to the left must not carry into V. */
static uint32_t packed_step(uint32_t du, uint32_t dv, unsigned width)
{
    return (uint32_t)asr32((int32_t)((du + 32) << (16 - width)), 22 - width) +
           ((dv + 32) >> 6 << (PACKED_BITS + width));
}

/* What RUN packed steps lack: each one -32..31 / 2^16 texel. */
static uint32_t packed_rest(uint32_t d)
{
    return (uint32_t)asr32((int32_t)((d + 32) & 63u) - 31, 1);
}

SPECIALISED uint32_t packed_at(const struct texel_at *at, unsigned width)
{
    return (at->u >> 6 & ((1u << (PACKED_BITS + width)) - 1)) + (at->v >> 6 << (PACKED_BITS + width));
}

HOT void sheen_textured_step(struct texel_run *r, const struct texel_at *step)
{
    const unsigned width = r->d->texel.texture->width_log2;

    r->step = *step;
    if (r->d->texel.packed) {
        r->packed = packed_step(step->u, step->v, width);
        r->mend = packed_rest(step->u) + (packed_rest(step->v) << (PACKED_BITS + width));
    } else {
        r->packed = r->mend = 0;
    }
}

void sheen_textured_begin(struct texel_run *r, const struct tile *t, const struct setup *s)
{
    const struct sheen_texture *texture = s->draw->texel.texture;

    r->t = t;
    r->d = s->draw;
    r->pixels = s->fast;
    r->columns = ((1u << texture->width_log2) - 1);
    r->rows = ((1u << texture->height_log2) - 1) << texture->width_log2;
}

/* ---- any texture, light and target ---- */

/* The light on channel k, with `fraction` bits. */
SPECIALISED uint32_t channel_light(const struct texel_terms *terms, uint32_t light, int k, unsigned fraction)
{
    if (terms->alike)
        return light >> (LIGHT_BITS - fraction);
    return (terms->a[k] + terms->b[k] * (light >> (LIGHT_BITS - 15))) >> (terms->fraction - fraction);
}

SPECIALISED uint32_t channel_highlight(const struct texel_terms *terms, uint32_t specular, int k, unsigned fraction)
{
    if (terms->white)
        return (k == 1 ? 63 : 31) * (specular >> (LIGHT_BITS - fraction));
    return terms->c[k] * (specular >> (LIGHT_BITS - 15)) >> terms->c_shift;
}

/* The one rounding of channels in levels of 565; threshold in 1/128. */
SPECIALISED void put_texel(const struct texel_run *r, uint32_t at, const uint32_t channel[3], uint32_t threshold,
                           unsigned fraction)
{
    const struct pixel_format *format = r->t->format;
    const uint16_t *grey = r->d->texel.grey;
    const unsigned grey_fraction = 31u - format->level_bits;

    if (format->grey) {
        uint32_t level = 0;
        for (int k = 0; k < 3; k++)
            level += (channel[k] >> (fraction - GREY_BITS)) * grey[k];
        level = clamped(level, ((1u << format->level_bits) - 1) << grey_fraction) + (threshold << (grey_fraction - 7));
        ((uint8_t *)r->t->pixels)[at] = (uint8_t)(level >> grey_fraction);
        return;
    }
    threshold <<= fraction - 7;
    ((uint16_t *)r->t->pixels)[at] =
        pixel_order((channel[0] + threshold) >> fraction << 11 | (channel[1] + threshold) >> fraction << 5 |
                        (channel[2] + threshold) >> fraction,
                    format->swap);
}

SPECIALISED void put_fogged_texel(const struct texel_run *r, uint32_t at, uint32_t z, const uint32_t channel[3],
                                  uint32_t threshold, unsigned fraction)
{
    const struct pixel_format *format = r->t->format;
    const uint16_t *grey = r->d->texel.grey;

    if (format->grey) {
        uint32_t level = 0, most = ((1u << format->level_bits) - 1) << (31u - format->level_bits);
        for (int k = 0; k < 3; k++)
            level += (channel[k] >> (fraction - GREY_BITS)) * grey[k];
        put_fogged(r->t, r->d->fog, at, z, clamped(level, most) >> 15, 0, 0, threshold, 1);
        return;
    }
    put_fogged(r->t, r->d->fog, at, z, channel[0] >> (fraction - 10), channel[1] >> (fraction - 10),
               channel[2] >> (fraction - 10), threshold, 0);
}

/* A channel, in 1/32 level, times light. If light may exceed 1.0, 4 of its bits are cut so that the product fits. */
SPECIALISED uint32_t under_light(const struct texel_run *r, uint32_t channel, uint32_t light)
{
    if (r->pixels == TEXTURED_ANY)
        return channel * ((light + 8) >> 4) >> 1;
    return r->d->texel.texture->bilinear ? channel * (light >> 5) : (channel >> 5) * light;
}

/* Draws a pixel: its texel is `nearest`, or bilinear a mix of the four around (u, v). */
SPLIT void any_colour(const struct texel_run *r, uint32_t offset, uint32_t threshold, const struct texel_at *at,
                      uint32_t nearest, int is_fogged)
{
    const struct texel_terms *terms = &r->d->texel;
    const unsigned fraction = r->pixels == TEXTURED_ANY ? BRIGHT_BITS : LIGHT_BITS;
    const uint32_t sum =
        terms->texture->bilinear ? any_mixed(terms->texture, at->u, at->v, nearest) : spread(nearest) << 5;
    const uint32_t light = not_negative(at->light), specular = not_negative(at->specular);
    uint32_t channel[3] = {sum >> 11 & 1023u, sum >> 21, sum & 1023u};

    for (int k = 0; k < 3; k++)
        channel[k] = clamped(under_light(r, channel[k], channel_light(terms, light, k, fraction)) +
                                 channel_highlight(terms, specular, k, fraction),
                             (k == 1 ? 63u : 31u) << fraction);
    if (is_fogged)
        put_fogged_texel(r, offset, at->z, channel, threshold, fraction);
    else
        put_texel(r, offset, channel, threshold, fraction);
}

SPLIT void any_loop(const struct texel_run *r, const struct texel_at *from, int is_fogged)
{
    const struct texel_terms *terms = &r->d->texel;
    const struct sheen_texture *t = terms->texture;
    const unsigned width = t->width_log2;
    const uint8_t *threshold = threshold_row(r->t, r->t->dither, r->y);
    const uint32_t middle = t->bilinear ? TO_MIDDLE : 0;
    struct texel_at at = {from->z, from->u + middle, from->v + middle, from->light, from->specular};
    uint32_t offset = (uint32_t)(r->depth - r->t->depth), x = (uint32_t)r->x, packed = packed_at(&at, width);

    for (int32_t i = 1; i <= r->count; i++, x++, offset++) {
        if (terms->packed) {
            at.u = packed << (16 - PACKED_BITS);
            at.v = packed >> (PACKED_BITS + width) << (16 - PACKED_BITS);
        }
        uint32_t nearest = texel_value(t, asr32((int32_t)(at.u - middle), 16), asr32((int32_t)(at.v - middle), 16));
        if (at.z >> 16 > r->t->depth[offset] && !(t->keyed && nearest == t->key)) {
            (void)nearer(r->t, r->t->depth + offset, at.z);
            any_colour(r, offset, threshold[x & 7u], &at, nearest, is_fogged);
        }
        at.z += r->step.z;
        at.u += r->step.u;
        at.v += r->step.v;
        at.light += r->step.light;
        at.specular += r->step.specular;
        packed += r->packed + (i % RUN == 0 ? r->mend : 0);
    }
}

static APART void any_run(const struct texel_run *r, const struct texel_at *from)
{
    any_loop(r, from, 0);
}

/* ---- specialised loops: on 565, no coordinate to clamp, light and highlight at most 1.0 and without a hue ---- */

/* 1 if the processor shifts and saturates in one instruction. */
#ifdef __ARM_FEATURE_SAT
#define SATURATES 1
#else
#define SATURATES 0
#endif

/*
 * The fog's levels: 2^16 blue + red, and green; the *_mist are the same with 11 fraction bits and, unless dithered, the
 * half of the one rounding.
 */
struct faded_fog {
    uint32_t blue_red, green, blue_red_mist, green_mist;
};

/* How a run is drawn. In specialised loops the fields before `fog` are compile-time constants. */
struct way {
    unsigned packed, lit, glossy, dither, swap;
    uint8_t other;                 /* the texture has a palette or a transparent colour */
    uint8_t fogged;                /* light and highlight are what the fog leaves of them */
    uint8_t faded;                 /* unlit: what the fog leaves is stepped in place of its share */
    uint32_t fog[3];               /* the fog's levels */
    intptr_t to_pixel;             /* bytes from a pixel's depth to its colour */
    const threshold_t *thresholds; /* of the row, if it is dithered */
    uint32_t half;                 /* the half of the one rounding, with LIGHT_BITS */
    uint32_t spread;               /* SPREAD */
    const struct sheen_texture *texture;
    struct faded_fog mist; /* if faded */
};

SPECIALISED struct way way_of(unsigned packed, unsigned lit, unsigned glossy, unsigned dither, unsigned swap)
{
    struct way way = {.packed = packed, .lit = lit, .glossy = glossy, .dither = dither, .swap = swap};

    return way;
}

SPECIALISED void way_begin(struct way *way, const struct texel_run *r)
{
    way->texture = r->d->texel.texture;
    way->half = 1u << (LIGHT_BITS - 1);
    way->spread = SPREAD;
    OPAQUE(way->half); /* else the compiler makes these constants at every pixel */
    OPAQUE(way->spread);
    way->to_pixel = r->t->to_pixel;
    way->thresholds = DITHER_ROW(r->t, r->depth - r->x, r->y);
}

SPECIALISED uint32_t threshold_at(const uint16_t *depth, const struct way *way)
{
    return way->dither ? threshold_pair(way->thresholds, depth) << (LIGHT_BITS - 11) : way->half;
}

/* 565 from channels with LIGHT_BITS and their threshold added; glossy: they may exceed the highest level. */
SPECIALISED uint32_t rounded_texel(uint32_t r, uint32_t g, uint32_t b, unsigned glossy)
{
    if (glossy && SATURATES) {
        r = (uint32_t)max32(0, min32(asr32((int32_t)r, LIGHT_BITS), 31));
        g = (uint32_t)max32(0, min32(asr32((int32_t)g, LIGHT_BITS), 63));
        b = (uint32_t)max32(0, min32(asr32((int32_t)b, LIGHT_BITS), 31));
        return (r << 6 | g) << 5 | b;
    }
    r >>= LIGHT_BITS;
    g >>= LIGHT_BITS;
    b >>= LIGHT_BITS;
    if (glossy && (r | g >> 1 | b) > 31) {
        r = r < 31 ? r : 31;
        g = g < 63 ? g : 63;
        b = b < 31 ? b : 31;
    }
    return (r << 6 | g) << 5 | b;
}

/* What is stepped along a run. u: U, or U and V packed; v: V, for nearest texels times the width. */
struct stepped {
    uint32_t z, light, specular, fog, u, v;
};

/* What is added to channels: a threshold, and if there are any, a white highlight and the fog's share. */
struct added {
    uint32_t red, green, blue;
};

SPECIALISED struct added added_at(const struct stepped *at, uint32_t threshold, const struct way *way)
{
    struct added a = {threshold, threshold, threshold};

    if (way->glossy) {
        uint32_t specular = not_negative(at->specular);
        a.red += 31 * specular;
        a.green += 63 * specular;
        a.blue += 31 * specular;
    }
    if (way->fogged) {
        a.red += way->fog[0] * at->fog;
        a.green += way->fog[1] * at->fog;
        a.blue += way->fog[2] * at->fog;
    }
    return a;
}

SPECIALISED uint32_t lit_texel(uint32_t texel, uint32_t light, struct added more, unsigned glossy)
{
    return rounded_texel((texel >> 11) * light + more.red, (texel >> 5 & 63u) * light + more.green,
                         (texel & 31u) * light + more.blue, glossy);
}

/* Reads a texel; n is its number if `other`, else its offset in bytes. */
SPECIALISED uint32_t texel_at(const uint8_t *texels, uint32_t n, const struct way *way)
{
    return way->other ? texel_number(way->texture, n) : *(const uint16_t *)(const void *)(texels + n);
}

SPECIALISED int is_key(uint32_t texel, const struct way *way)
{
    return way->other && way->texture->keyed && texel == way->texture->key;
}

SPECIALISED void step_on(struct stepped *at, const struct stepped *step, const struct way *way)
{
    at->z += step->z;
    at->u += step->u;
    OPAQUE(at->z); /* else gcc multiplies to get the values at the run's end */
    OPAQUE(at->u);
    if (!way->packed) {
        at->v += step->v;
        OPAQUE(at->v);
    }
    if (way->lit) {
        at->light += step->light;
        OPAQUE(at->light);
    }
    if (way->glossy) {
        at->specular += step->specular;
        OPAQUE(at->specular);
    }
    if (way->fogged) {
        at->fog += step->fog;
        OPAQUE(at->fog);
    }
}

/* The end of the next part of a run, within which nothing is mended. */
SPECIALISED const uint16_t *part_end(const uint16_t *depth, const uint16_t *last, const struct way *way)
{
    return (way->packed || way->dither) && last - depth > RUN ? depth + RUN : last;
}

/* 2^16 blue + red. */
SPECIALISED uint32_t blue_red_of(uint32_t texel)
{
    uint32_t blue = texel << 27;

    OPAQUE(blue);
    return (blue >> 11) + (texel >> 11);
}

/* By shifts on an M0+, where a mask would need a register. */
SPECIALISED uint32_t green_of(uint32_t texel)
{
    uint32_t green = texel << 21;

#if defined(__ARM_ARCH_6M__)
    OPAQUE(green);
#endif
    return green >> 26;
}

/* 565 from channels with 11 fraction bits; bits above the low 16 are left for the caller to cut off. */
SPECIALISED uint32_t packed_levels(uint32_t blue_red, uint32_t green)
{
#if defined(__ARM_ARCH_6M__)
    return (blue_red >> 11 << 6 | green >> 11) << 5 | blue_red >> 27;
#else
    return (blue_red & 0xf800u) | green >> 11 << 5 | blue_red >> 27;
#endif
}

/*
 * fog + (texel - fog) * left, in two products; no channel exceeds the larger of the fog's and the texel's. left:
 * UQ1.11, at most 1.0.
 */
SPECIALISED uint32_t faded_texel(const uint16_t *depth, uint32_t texel, uint32_t left, const struct way *way)
{
    uint32_t blue_red = (blue_red_of(texel) - way->mist.blue_red) * left + way->mist.blue_red_mist;
    OPAQUE_BOTH(blue_red, texel); /* one after the other: registers are few */
    uint32_t green = (green_of(texel) - way->mist.green) * left + way->mist.green_mist;

    if (way->dither) {
        const uint32_t pair = threshold_pair(way->thresholds, depth);
        blue_red += pair;
        green += pair & 0xffffu;
    }
    return packed_levels(blue_red, green);
}

SPECIALISED void put_nearest(uint16_t *depth, const struct stepped *at, uint32_t texel, const struct way *way)
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

SPECIALISED struct texel_part whole_run(const struct texel_run *r, const struct texel_at *from)
{
    struct texel_part whole = {r->depth, r->count, from, &r->step, 0, 0};

    return whole;
}

SPECIALISED void nearest_loop(const struct texel_run *r, const struct texel_part *part, struct way *way)
{
    const struct texel_at *from = part->from, *by = part->step;
    const unsigned width = r->d->texel.texture->width_log2, down = way->other ? 0 : 1;
    const uint8_t *texels = r->d->texel.texture->texels;
    const uint32_t columns = r->columns << down, rows = r->rows << down, mend = way->packed ? r->mend : 0;
    const struct stepped step = {
        by->z, by->light, by->specular, part->fog_step, way->packed ? r->packed : by->u, by->v << width};
    struct stepped at = {
        from->z,         from->light, from->specular, part->fog, way->packed ? packed_at(from, width) : from->u,
        from->v << width};
    uint16_t *depth = part->depth;
    const uint16_t *last = depth + part->count;

    way_begin(way, r);
    for (;;) {
        const uint16_t *end = part_end(depth, last, way);
        do {
            const uint32_t row = way->packed ? at.u >> (2 * PACKED_BITS - down) : at.v >> (16 - down);
            const uint32_t n = (at.u >> ((way->packed ? PACKED_BITS : 16) - down) & columns) | (row & rows);
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

SPECIALISED void nearest_part(const struct texel_run *r, struct texel_part part, struct way way)
{
    nearest_loop(r, &part, &way);
}

/* Rounds channels in 1/32 level, each in its place in the word. */
SPECIALISED uint32_t unlit_mixed(uint32_t sum, const struct way *way, uint32_t threshold)
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
                              const struct way *way)
{
    if (way->packed) /* all bits but the fractions */
        return ((c->u ^ at->u) & ~(((1u << PACKED_BITS) - 1) * ((1u << (PACKED_BITS + b->width)) + 1))) == 0;
    return ((c->u ^ at->u) | (c->v ^ at->v)) >> 16 == 0;
}

SPECIALISED uint32_t spread_at(const struct bilinear_at *b, uint32_t n, const struct way *way)
{
    uint32_t texel = texel_at(b->texels, n, way);

    return (texel | texel << 16) & way->spread;
}

SPECIALISED void texel_cell_at(struct texel_cell *c, const struct stepped *at, const struct bilinear_at *b,
                               const struct way *way)
{
    const unsigned down = way->other ? 0 : 1;
    const uint32_t left = at->u >> ((way->packed ? PACKED_BITS : 16) - down) & b->columns;
    const uint32_t top = (way->packed ? at->u >> (2 * PACKED_BITS - down) : at->v >> (16 - down - b->width)) & b->rows;
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
                                const struct way *way)
{
    const uint32_t x = (way->packed ? at->u >> (PACKED_BITS - 5) : at->u >> 11) & 31u;
    const uint32_t y = (way->packed ? at->u >> (2 * PACKED_BITS - 5 + b->width) : at->v >> 11) & 31u;

    return c->first + x * c->right + y * c->below + ((x * y + 16) >> 5) * c->both;
}

SPECIALISED void put_mixed(uint16_t *depth, const struct stepped *at, uint32_t sum, const struct way *way)
{
    const uint32_t threshold = threshold_at(depth, way);
    const uint32_t value = way->lit ? lit_mixed(sum, at->light, added_at(at, threshold, way), way->glossy)
                                    : unlit_mixed(sum, way, threshold);

    *pixel_at(depth, way->to_pixel) = pixel_order(value, way->swap);
}

SPECIALISED void bilinear_loop(const struct texel_run *r, const struct texel_part *part, struct way *way)
{
    const struct texel_at *from = part->from, *by = part->step;
    const unsigned width = r->d->texel.texture->width_log2, down = way->other ? 0 : 1;
    const struct bilinear_at b = {r->d->texel.texture->texels, r->columns << down, r->rows << down,
                                  1u << (width + down), width};
    const struct texel_at middle = {from->z, from->u + TO_MIDDLE, from->v + TO_MIDDLE, from->light, from->specular};
    const struct stepped step = {by->z, by->light, by->specular, part->fog_step, way->packed ? r->packed : by->u,
                                 by->v};
    struct stepped at = {
        from->z, from->light, from->specular, part->fog, way->packed ? packed_at(&middle, width) : middle.u, middle.v};
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
        at.u += way->packed ? r->mend : 0;
    }
}

SPECIALISED void bilinear_part(const struct texel_run *r, struct texel_part part, struct way way)
{
    bilinear_loop(r, &part, &way);
}

/* ---- fog ---- */

/* The fog that a run is seen through. */
SPECIALISED void way_through(struct way *way, const struct fog_terms *fog)
{
    way->fogged = 1;
    for (int k = 0; k < 3; k++)
        way->fog[k] = fog->level[k] >> 10;
}

SPLIT struct way fogged_way(const struct texel_run *r, unsigned packed, unsigned glossy, unsigned dither, unsigned swap)
{
    struct way way = way_of(packed, 1, glossy, dither, swap);

    way_through(&way, r->d->fog);
    return way;
}

/* For unlit texels: a part's fog is then what the fog leaves of them, plus half a step of UQ1.11 for its rounding. */
SPECIALISED void fade(struct way *way)
{
    const uint32_t half = way->dither ? 0 : 1u << 10; /* of the one rounding */
    const uint32_t blue_red = (way->fog[2] << 16) + way->fog[0], green = way->fog[1];

    way->lit = 0;
    way->faded = 1;
    way->mist = (struct faded_fog){blue_red, green, (blue_red << 11) + half * 0x10001u, (green << 11) + half};
}

static int is_glossy(const struct texel_part *part)
{
    return (part->from->specular | part->step->specular) != 0;
}

/* What fog does to a run: nothing, dims its light and highlight, or fades unlit texels (see fade). */
enum fogging {
    NOT_FOGGED,
    FOG_DIMS,
    FOG_FADES
};

/* For any texels, with light and fog linear along the part. */
SPLIT void any_way(struct way *way, const struct texel_run *r, const struct texel_part *part, enum fogging fogging)
{
    const struct sheen_texture *texture = r->d->texel.texture;

    way->packed = r->d->texel.packed;
    way->lit = fogging == FOG_DIMS || !r->d->texel.unlit;
    way->glossy = fogging != FOG_FADES && is_glossy(part);
    way->dither = r->t->dither;
    way->swap = r->t->format->swap;
    way->other = (texture->bits & 15) != 0 || texture->keyed;
    way->fogged = way->faded = 0;
    if (fogging != NOT_FOGGED)
        way_through(way, r->d->fog);
    if (fogging == FOG_FADES)
        fade(way);
}

static APART void any_bilinear(const struct texel_run *r, const struct texel_part *part, enum fogging fogging)
{
    struct way way;

    any_way(&way, r, part, fogging);
    bilinear_loop(r, part, &way);
}

static APART void any_nearest(const struct texel_run *r, const struct texel_part *part, enum fogging fogging)
{
    struct way way;

    any_way(&way, r, part, fogging);
    nearest_loop(r, part, &way);
}

/* Two functions, so that only the stack of one is used. */
SPLIT void any_part(const struct texel_run *r, const struct texel_part *part, enum fogging fogging)
{
    if (r->d->texel.texture->bilinear)
        any_bilinear(r, part, fogging);
    else
        any_nearest(r, part, fogging);
}

#if FAST_LOOPS
SPECIALISED void faded_part(const struct texel_run *r, const struct texel_part *part, unsigned packed, unsigned dither)
{
    struct way way = fogged_way(r, packed, 0, dither, 1);

    fade(&way);
    nearest_part(r, *part, way);
}

static APART void glossy_fogged_part(const struct texel_run *r, const struct texel_part *part)
{
    if (!r->d->texel.packed)
        nearest_part(r, *part, fogged_way(r, 0, 1, r->t->dither, 1));
    else
        r->t->dither ? nearest_part(r, *part, fogged_way(r, 1, 1, 1, 1))
                     : nearest_part(r, *part, fogged_way(r, 1, 1, 0, 1));
}

void sheen_fogged_part(const struct texel_run *r, const struct texel_part *part)
{
    const struct sheen_texture *texture = r->d->texel.texture;

    if (!r->t->format->swap || (texture->bits & 15) != 0 || texture->keyed || texture->bilinear)
        any_part(r, part, FOG_DIMS);
    else if (is_glossy(part))
        glossy_fogged_part(r, part);
    else if (r->t->dither)
        r->d->texel.packed ? nearest_part(r, *part, fogged_way(r, 1, 0, 1, 1))
                           : nearest_part(r, *part, fogged_way(r, 0, 0, 1, 1));
    else
        r->d->texel.packed ? nearest_part(r, *part, fogged_way(r, 1, 0, 0, 1))
                           : nearest_part(r, *part, fogged_way(r, 0, 0, 0, 1));
}
#else
void sheen_fogged_part(const struct texel_run *r, const struct texel_part *part)
{
    any_part(r, part, FOG_DIMS);
}
#endif

void sheen_faded_part(const struct texel_run *r, const struct texel_part *part)
{
#if FAST_LOOPS
    const struct sheen_texture *texture = r->d->texel.texture;

    if (r->t->format->swap && (texture->bits & 15) == 0 && !texture->keyed) {
        if (!r->d->texel.packed)
            r->t->dither ? faded_part(r, part, 0, 1) : faded_part(r, part, 0, 0);
        else
            r->t->dither ? faded_part(r, part, 1, 1) : faded_part(r, part, 1, 0);
        return;
    }
#endif
    any_part(r, part, FOG_FADES);
}

void sheen_fogged_any_texels(const struct texel_run *r, const struct texel_at *from)
{
    any_loop(r, from, 1);
}

/* ---- which loop ---- */

#if FAST_LOOPS

SPECIALISED void nearest_as(const struct texel_run *r, const struct texel_at *at, unsigned lit, unsigned glossy,
                            unsigned dither)
{
    const unsigned swap = r->t->format->swap;

    if (r->d->texel.packed)
        swap ? nearest_part(r, whole_run(r, at), way_of(1, lit, glossy, dither, 1))
             : nearest_part(r, whole_run(r, at), way_of(1, lit, glossy, dither, 0));
    else
        swap ? nearest_part(r, whole_run(r, at), way_of(0, lit, glossy, dither, 1))
             : nearest_part(r, whole_run(r, at), way_of(0, lit, glossy, dither, 0));
}

HOT static APART void unlit_run(const struct texel_run *r, const struct texel_at *at)
{
    nearest_as(r, at, 0, 0, 0);
}

HOT static APART void lit_run(const struct texel_run *r, const struct texel_at *at)
{
    nearest_as(r, at, 1, 0, 0);
}

static APART void dithered_run(const struct texel_run *r, const struct texel_at *at)
{
    nearest_as(r, at, 1, 0, 1);
}

HOT static APART void glossy_run(const struct texel_run *r, const struct texel_at *at)
{
    r->t->dither ? nearest_as(r, at, 1, 1, 1) : nearest_as(r, at, 1, 1, 0);
}

static APART void other_run(const struct texel_run *r, const struct texel_at *at)
{
    const struct texel_part whole = whole_run(r, at);
    struct way way;

    any_way(&way, r, &whole, NOT_FOGGED);
    nearest_loop(r, &whole, &way);
}

HOT static APART void mixed_run(const struct texel_run *r, const struct texel_at *at)
{
    const unsigned swap = r->t->format->swap;

    if (r->d->texel.packed)
        swap ? bilinear_part(r, whole_run(r, at), way_of(1, 0, 0, 0, 1))
             : bilinear_part(r, whole_run(r, at), way_of(1, 0, 0, 0, 0));
    else
        swap ? bilinear_part(r, whole_run(r, at), way_of(0, 0, 0, 0, 1))
             : bilinear_part(r, whole_run(r, at), way_of(0, 0, 0, 0, 0));
}

static APART void other_mixed_run(const struct texel_run *r, const struct texel_at *at)
{
    const struct texel_part whole = whole_run(r, at);
    struct way way;

    any_way(&way, r, &whole, NOT_FOGGED);
    bilinear_loop(r, &whole, &way);
}

void sheen_textured_run(const struct texel_run *r, const struct texel_at *at)
{
    switch (r->pixels) {
    case TEXTURED_UNLIT:
        unlit_run(r, at);
        return;
    case TEXTURED_LIT:
        r->t->dither ? dithered_run(r, at) : lit_run(r, at);
        return;
    case TEXTURED_GLOSSY:
        glossy_run(r, at);
        return;
    case TEXTURED_OTHER:
        other_run(r, at);
        return;
    case TEXTURED_BILINEAR:
        r->t->dither ? other_mixed_run(r, at) : mixed_run(r, at);
        return;
    case TEXTURED_BILINEAR_OTHER:
        other_mixed_run(r, at);
        return;
    default:
        (r->d->fog ? r->d->fog->mixer->texel_run : any_run)(r, at);
    }
}

#else

void sheen_textured_run(const struct texel_run *r, const struct texel_at *at)
{
    const struct texel_part whole = whole_run(r, at);

    if (r->pixels == TEXTURED_ANY || r->pixels == TEXTURED_FOGGED)
        (r->d->fog ? r->d->fog->mixer->texel_run : any_run)(r, at);
    else
        any_part(r, &whole, NOT_FOGGED);
}

#endif
