/*
 * texel_way.h - private: how specialised loops draw a run of texels: on 565, with no coordinate to clamp, light and
 * highlight at most 1.0 and without a hue.
 */
#ifndef SHEEN_TEXEL_WAY_H
#define SHEEN_TEXEL_WAY_H

#include "fog.h"
#include "texel_steps.h"

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
struct texel_way {
    unsigned uv_packed, lit, glossy, dither, swap;
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

SPECIALISED struct texel_way way_of(unsigned uv_packed, unsigned lit, unsigned glossy, unsigned dither, unsigned swap)
{
    struct texel_way way = {.uv_packed = uv_packed, .lit = lit, .glossy = glossy, .dither = dither, .swap = swap};

    return way;
}

SPECIALISED void way_begin(struct texel_way *way, const struct texel_run *r)
{
    way->texture = r->d->texel.texture;
    way->half = 1u << (LIGHT_BITS - 1);
    way->spread = SPREAD;
    OPAQUE(way->half); /* else the compiler makes these constants at every pixel */
    OPAQUE(way->spread);
    way->to_pixel = r->t->to_pixel;
    way->thresholds = DITHER_ROW(r->t, r->depth - r->x, r->y);
}

SPECIALISED uint32_t threshold_at(const uint16_t *depth, const struct texel_way *way)
{
    return way->dither ? threshold_pair(way->thresholds, depth) << (LIGHT_BITS - 11) : way->half;
}

/* ---- fog, and what is known when a program runs ---- */

/* The fog that a run is seen through. */
SPECIALISED void way_through(struct texel_way *way, const struct fog_terms *fog)
{
    way->fogged = 1;
    for (int k = 0; k < 3; k++)
        way->fog[k] = fog->level[k] >> 10;
}

/* For unlit texels: a part's fog is then what the fog leaves of them, plus half a step of UQ1.11 for its rounding. */
SPECIALISED void fade(struct texel_way *way)
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
SPLIT void any_way(struct texel_way *way, const struct texel_run *r, const struct texel_part *part,
                   enum fogging fogging)
{
    const struct sheen_texture *texture = r->d->texel.texture;

    way->uv_packed = r->d->texel.uv_packed;
    way->lit = fogging == FOG_DIMS || !r->d->texel.unlit;
    way->glossy = fogging != FOG_FADES && is_glossy(part);
    way->dither = r->t->dither;
    way->swap = r->t->format->swap;
    way->other = (texture->bits & 15) != 0 || texture->keyed;
    way->fogged = way->faded = 0;
    way->fog[0] = way->fog[1] = way->fog[2] = 0;
    if (fogging != NOT_FOGGED)
        way_through(way, r->d->fog);
    if (fogging == FOG_FADES)
        fade(way);
}

/*
 * Draw a part of any texels, nearest or bilinear, with light and fog linear along it; slower than a specialised loop.
 * Two functions, so that only the stack of one is used.
 */
void sheen_any_nearest(const struct texel_run *r, const struct texel_part *part, enum fogging fogging);
void sheen_any_bilinear(const struct texel_run *r, const struct texel_part *part, enum fogging fogging);

SPLIT void any_part(const struct texel_run *r, const struct texel_part *part, enum fogging fogging)
{
    if (r->d->texel.texture->bilinear)
        sheen_any_bilinear(r, part, fogging);
    else
        sheen_any_nearest(r, part, fogging);
}

/* ---- what is stepped, and added to a pixel ---- */

/* What is stepped along a run. u: U, or U and V packed; v: V, for nearest texels times the width. */
struct stepped {
    uint32_t z, light, specular, fog, u, v;
};

SPECIALISED void step_on(struct stepped *at, const struct stepped *step, const struct texel_way *way)
{
    at->z += step->z;
    at->u += step->u;
    OPAQUE(at->z); /* else gcc multiplies to get the values at the run's end */
    OPAQUE(at->u);
    if (!way->uv_packed) {
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

/* What is added to channels: a threshold, and if there are any, a white highlight and the fog's share. */
struct added {
    uint32_t red, green, blue;
};

SPECIALISED struct added added_at(const struct stepped *at, uint32_t threshold, const struct texel_way *way)
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

/* ---- pixels ---- */

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

/* Reads a texel; n is its number if `other`, else its offset in bytes. */
SPLIT uint32_t texel_at(const uint8_t *texels, uint32_t n, const struct texel_way *way)
{
    return way->other ? texel_number(way->texture, n) : *(const uint16_t *)(const void *)(texels + n);
}

SPECIALISED int is_key(uint32_t texel, const struct texel_way *way)
{
    return way->other && way->texture->keyed && texel == way->texture->key;
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
SPECIALISED uint32_t faded_texel(const uint16_t *depth, uint32_t texel, uint32_t left, const struct texel_way *way)
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

#endif
