/*
 * fogged_blocks.c - runs of texels under fog, in parts along which light and fog are nearly linear.
 *
 * A pixel is (texel * light + highlight) * (1 - share) + fog * share; what is stepped is light * (1 - share),
 * highlight * (1 - share) and share.
 */
#include "fog.h"
#include "textured.h"

/* 2^16 / n */
static const uint16_t one_of[TEXEL_PART] = {0,    0,    32768, 21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554,
                                            5958, 5461, 5041,  4681,  4369,  4096,  3855,  3641, 3449, 3277, 3121,
                                            2979, 2849, 2731,  2621,  2521,  2427,  2341,  2260, 2185, 2114};

/* (to - from) / count, count 1..TEXEL_PART - 1. Range: from and to are shares of 1.0, with LIGHT_BITS. */
static uint32_t part_of_share(uint32_t from, uint32_t to, uint32_t count)
{
    const int32_t difference = (int32_t)(to - from);

    return (uint32_t)(count == 1 ? difference : mul_16_32(one_of[count], difference));
}

/* At a pixel: the fog's share, and what the fog leaves of light and highlight; all with LIGHT_BITS. */
struct fog_shares {
    uint32_t fogged, left, gloss;
};

/* What a fog of this share, UQ1.14, leaves of light. Range: UQ1.15 times UQ1.14. */
static uint32_t left_of(uint32_t light, uint32_t share)
{
    return (not_negative(light) >> (LIGHT_BITS - 15)) * ((1u << 14) - share) >> (29 - LIGHT_BITS);
}

SPECIALISED struct fog_shares fog_shares_at(const struct fog_terms *fog, uint32_t z, uint32_t light, uint32_t specular)
{
    const uint32_t share = (uint32_t)fog_share(fog, z);
    struct fog_shares at = {share << (LIGHT_BITS - 14), left_of(light, share),
                            specular == 0 ? 0 : left_of(specular, share)};

    return at;
}

/*
 * 1 if linear interpolation between two pixels is off by more than 1/8 level: the product of light and fog bends if
 * both change, and fog may begin or end in between. change: the light's plus the highlight's.
 */
static int is_bent(uint32_t fogged, uint32_t fogged_end, uint32_t change)
{
    const uint32_t all = 1u << LIGHT_BITS;

    return (fogged == 0) != (fogged_end == 0) || (fogged == all) != (fogged_end == all) ||
           (change >> 12) * (magnitude32((int32_t)(fogged_end - fogged)) >> 12) > 1u << 17;
}

/* The part being drawn: light and highlight, and in `at` what the fog leaves of them. */
struct fogged_part {
    struct texel_part part;
    struct texel_at at, step;
    uint32_t light, specular;
};

/* 1 if light and highlight have to be clamped before the fog is applied. */
SPECIALISED int is_bright(uint32_t light, uint32_t specular)
{
    return specular != 0 && not_negative(light) + not_negative(specular) > 1u << LIGHT_BITS;
}

/* Finds the length of a part, at most `left` px, and its steps. Returns 1 if light has to be clamped in it. */
static int fogged_steps(const struct texel_run *r, int32_t left, struct fogged_part *p)
{
    const struct fog_terms *fog = r->d->fog;
    const struct fog_shares first = fog_shares_at(fog, p->at.z, p->light, p->specular);
    uint32_t light = 0, specular = 0; /* their change over the part */
    int32_t count = min32(left, TEXEL_PART);

    p->at.light = first.left;
    p->at.specular = first.gloss;
    p->part.fog = first.fogged;
    p->step.light = p->step.specular = p->part.fog_step = 0;
    for (; count > 1; count /= 2) {
        const uint32_t n = (uint32_t)count - 1;
        SHEEN_TAP(FOGGED_TRY, 1);
        light = n * r->step.light;
        specular = n * r->step.specular;
        const struct fog_shares last =
            fog_shares_at(fog, p->at.z + n * r->step.z, p->light + light, p->specular + specular);
        if (is_bent(first.fogged, last.fogged, magnitude32((int32_t)light) + magnitude32((int32_t)specular)))
            continue;
        p->step.light = part_of_share(first.left, last.left, n);
        p->part.fog_step = part_of_share(first.fogged, last.fogged, n);
        if ((first.gloss | last.gloss) != 0)
            p->step.specular = part_of_share(first.gloss, last.gloss, n);
        break;
    }
    p->part.count = count;
    return is_bright(p->light, p->specular) || (count > 1 && is_bright(p->light + light, p->specular + specular));
}

/* A part whose light has to be clamped: drawn by the general loop. before: pixels of the run before the part. */
static APART void bright_part(const struct texel_run *r, struct fogged_part *p, int32_t before)
{
    struct texel_run run = *r;

    run.depth = p->part.depth;
    run.count = p->part.count;
    run.x += before;
    p->at.light = p->light;
    p->at.specular = p->specular;
    sheen_fogged_any_texels(&run, &p->at);
}

HOT static APART void fogged_run(const struct texel_run *r, const struct texel_at *from)
{
    struct fogged_part p = {{r->depth, 0, &p.at, &p.step, 0, 0}, *from, r->step, from->light, from->specular};

    for (int32_t left = r->count; left > 0; left -= p.part.count) {
        SHEEN_TAP(FOGGED_PART, 1);
        if (fogged_steps(r, left, &p))
            bright_part(r, &p, r->count - left);
        else
            sheen_fogged_part(r, &p.part);
        const uint32_t n = (uint32_t)p.part.count;
        p.part.depth += n;
        p.at.z += n * r->step.z;
        p.at.u += n * r->step.u;
        p.at.v += n * r->step.v;
        p.light += n * r->step.light;
        p.specular += n * r->step.specular;
    }
}

/* ---- unlit ---- */

#define ALL_FOG (1 << 14)

/* Makes a part along which the fog's share is linear; returns its pixels, at most `left`. */
static int32_t faded_steps(const struct texel_run *r, int32_t left, struct texel_part *p)
{
    const struct fog_terms *fog = r->d->fog;
    const int32_t first = fog_share(fog, p->from->z);
    int32_t count = min32(left, TEXEL_PART);

    p->fog = (uint32_t)(ALL_FOG - first) * (1u << (LIGHT_BITS - 14)) + (1u << (LIGHT_BITS - 12));
    p->fog_step = 0;
    for (; count > 1; count /= 2) {
        const uint32_t n = (uint32_t)count - 1;
        const int32_t last = fog_share(fog, p->from->z + n * r->step.z);
        SHEEN_TAP(FOGGED_TRY, 1);
        if (last == first)
            break;
        if (first == 0 || last == 0 || first == ALL_FOG || last == ALL_FOG)
            continue; /* fog begins or ends in between */
        p->fog_step = (uint32_t)asr32((first - last) * (int32_t)(n == 1 ? 1u << 16 : one_of[n]), 30 - LIGHT_BITS);
        break;
    }
    return count;
}

HOT static APART void faded_run(const struct texel_run *r, const struct texel_at *from)
{
    struct texel_at at;
    struct texel_part p = {r->depth, 0, from, &r->step, 0, 0};

    for (int32_t left = r->count;;) {
        SHEEN_TAP(FOGGED_PART, 1);
        p.count = faded_steps(r, left, &p);
        sheen_faded_part(r, &p);
        left -= p.count;
        if (left <= 0)
            return;
        const uint32_t n = (uint32_t)p.count;
        at = (struct texel_at){p.from->z + n * r->step.z, p.from->u + n * r->step.u, p.from->v + n * r->step.v, 0, 0};
        p.from = &at;
        p.depth += n;
    }
}

void sheen_fogged_texel_run(const struct texel_run *r, const struct texel_at *from)
{
    if (r->special_loop == TEXTURED_FOGGED && r->d->texel.unlit && !r->d->texel.texture->bilinear)
        faded_run(r, from);
    else if (r->special_loop == TEXTURED_FOGGED)
        fogged_run(r, from);
    else
        sheen_fogged_any_texels(r, from);
}
