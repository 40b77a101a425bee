/*
 * tinted_light.c - light at a normal from lights that have colours or stand somewhere.
 */
#include "../math/newton.h"
#include "../math/vector.h"
#include "vertex.h"

/* A light where it falls: L, 1 + L.V (Q2.29), and what is left of it, UQ0.32. */
struct beam {
    const sheen_q30_t *to;
    int32_t lv1;
    uint32_t left;
    sheen_q30_t own[3];
};

/* Of light i, a point, at `at`, Q11.20. Range: differences of parts are 2^31 at most, so the squares' sum < 2^64. */
static APART void beam_of_point(const struct lighting *l, unsigned i, const int32_t at[3], const int16_t normal[3],
                                struct beam *beam)
{
    const uint64_t whole = (uint64_t)l->lv1[i] * (uint64_t)l->lv1[i];
    int64_t v[3];
    uint64_t square = 0;
    int32_t lv = 0;

    for (int k = 0; k < 3; k++) {
        v[k] = (int64_t)l->to[i][k] - at[k];
        square += (uint64_t)(v[k] * v[k]);
    }
    beam->left = 0;
    if (square >= whole)
        return;
    if (sheen_normalize_wide(v, beam->own) < 0)
        for (int k = 0; k < 3; k++)
            beam->own[k] = normal[k] * 32768;
    for (int k = 0; k < 3; k++)
        lv += sheen_mul_round(beam->own[k], l->view[k], 31);
    const unsigned zeros = clz64(whole);
    const uint32_t lost = sheen_ratio((uint32_t)((square << zeros) >> 32), (uint32_t)((whole << zeros) >> 32));
    beam->to = beam->own;
    beam->lv1 = (1 << 29) + lv;
    beam->left = mul_high(~lost, ~lost);
}

/* Each light's share of the sum, 2^30 = 1.0, by channel. */
static APART void add_tinted(uint32_t sum[3], uint32_t amount, uint32_t left, const uint8_t color[3])
{
    if (left != UINT32_MAX)
        amount = mul_high(amount, left);
    for (int k = 0; k < 3; k++)
        sum[k] += by_colour(amount, color[k]);
}

static uint32_t to_q15(uint32_t sum)
{
    return clamped((sum + (1u << 14)) >> 15, 32768);
}

void sheen_light_tinted(const struct lighting *l, const struct power *power, const struct tint_terms *tint,
                        const int32_t at[3], const int16_t normal[3], struct tinted *out)
{
    const int32_t lacks = lacking(normal), nv = sheen_unit_cosine(normal, lacks, l->view);

    SHEEN_TAP(TINTED, 1);
    SHEEN_TAP(TINTED_LIGHT, l->count);
    *out = (struct tinted){{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}; /* at first UQ2.30: weights sum to 1.0 */
    for (unsigned i = 0; i < l->count && (normal[0] | normal[1] | normal[2]) != 0; i++) {
        const uint8_t *color = tint->color[i];
        struct beam beam;
        beam.to = l->to[i];
        beam.lv1 = l->lv1[i];
        beam.left = UINT32_MAX;
        if ((tint->points >> i & 1u) != 0)
            beam_of_point(l, i, at, normal, &beam);
        if (beam.left == 0)
            continue;
        const int32_t ln = sheen_unit_cosine(normal, lacks, beam.to), rounded = asr32(ln + (1 << 14), 15);
        const uint32_t response = l->ramp != NULL ? response_at(l->ramp, rounded) : (uint32_t)max32(rounded, 0);
        add_tinted(out->low, (uint32_t)l->diffuse_weight[i] << 15, beam.left, color);
        add_tinted(out->diffuse, l->diffuse_weight[i] * response, beam.left, color);
        if (ln <= 0)
            continue;
        const int32_t u = (int32_t)((uint32_t)beam.lv1 - (uint32_t)mul_round(ln, nv, 30));
        add_tinted(out->specular, l->specular_weight[i] * highlight_at(*power, u, (uint32_t)rounded), beam.left, color);
    }
    for (int k = 0; k < 3; k++) {
        out->low[k] = to_q15(out->low[k]);
        out->diffuse[k] = to_q15(out->diffuse[k]);
        out->specular[k] = to_q15(out->specular[k]);
    }
}
