/*
 * fogged_blocks.c - runs of texels under fog, in parts along which light and fog may be linear.
 *
 * texel * light * (1 - share) + fog * share: a pixel takes a lit texel's product with the light that is left, and the
 * fog's share in the place of a highlight.
 */
#include "fog.h"
#include "textured.h"

/* 2^16 / n */
static const uint16_t one_of[TEXEL_PART] = {0,    0,    32768, 21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554,
                                            5958, 5461, 5041,  4681,  4369,  4096,  3855,  3641, 3449, 3277, 3121,
                                            2979, 2849, 2731,  2621,  2521,  2427,  2341,  2260, 2185, 2114};

/* (to - from) / count, 1..TEXEL_PART - 1. Range: shares of 1.0 with LIGHT_BITS. */
static uint32_t part_of_share(uint32_t from, uint32_t to, uint32_t count)
{
    const int32_t difference = (int32_t)(to - from);

    return (uint32_t)(count == 1 ? difference : mul_16_32(one_of[count], difference));
}

/* At a pixel: the fog's share, and what that leaves of the light; with LIGHT_BITS. */
struct fog_shares {
    uint32_t fogged, left;
};

/* Range: UQ1.15 times UQ1.14. */
SPECIALISED struct fog_shares fog_shares_at(const struct fog_terms *fog, uint32_t z, uint32_t light)
{
    const uint32_t share = (uint32_t)fog_share(fog, z), bright = not_negative(light) >> (LIGHT_BITS - 15);
    struct fog_shares at = {share << (LIGHT_BITS - 14), bright * ((1u << 14) - share) >> (29 - LIGHT_BITS)};

    return at;
}

/*
 * 1 where linear between two pixels is off by more than 1/8 level: their product bends where fog and light change, and
 * fog may begin or end there. change: the light's.
 */
static int is_bent(uint32_t fogged, uint32_t fogged_end, uint32_t change)
{
    const uint32_t all = 1u << LIGHT_BITS;

    return (fogged == 0) != (fogged_end == 0) || (fogged == all) != (fogged_end == all) ||
           (magnitude32((int32_t)change) >> 12) * (magnitude32((int32_t)(fogged_end - fogged)) >> 12) > 1u << 17;
}

/* Where a part of `left` px at the most ends, from `at` on, whose light is `light`; its steps but for the fog's. */
static int32_t fogged_steps(const struct texel_run *r, uint32_t light, int32_t left, struct texel_at *at,
                            struct texel_at *step)
{
    const struct fog_terms *fog = r->d->fog;
    const struct fog_shares first = fog_shares_at(fog, at->z, light);
    int32_t count = min32(left, TEXEL_PART);

    at->light = first.left;
    at->specular = first.fogged;
    step->light = step->specular = 0;
    for (; count > 1; count /= 2) {
        const uint32_t n = (uint32_t)count - 1, change = n * r->step.light;
        SHEEN_TAP(FOGGED_TRY, 1);
        const struct fog_shares last = fog_shares_at(fog, at->z + n * r->step.z, light + change);
        if (is_bent(first.fogged, last.fogged, change))
            continue;
        step->light = part_of_share(first.left, last.left, n);
        step->specular = part_of_share(first.fogged, last.fogged, n);
        break;
    }
    return count;
}

static void fogged_run(const struct texel_run *r, const struct texel_at *from)
{
    struct texel_at at = *from, step = r->step;
    struct texel_part part = {r->depth, 0, &at, &step};
    uint32_t light = from->light;

    for (int32_t left = r->count; left > 0; left -= part.count) {
        part.count = fogged_steps(r, light, left, &at, &step);
        SHEEN_TAP(FOGGED_PART, 1);
        sheen_fogged_part(r, &part);
        part.depth += part.count;
        at.z += (uint32_t)part.count * step.z;
        at.u += (uint32_t)part.count * step.u;
        at.v += (uint32_t)part.count * step.v;
        light += (uint32_t)part.count * r->step.light;
    }
}

void sheen_fogged_texel_run(const struct texel_run *r, const struct texel_at *from)
{
    if (r->pixels == TEXTURED_FOGGED)
        fogged_run(r, from);
    else
        sheen_fogged_any_texels(r, from);
}
