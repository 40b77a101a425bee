/*
 * tinted_light.c - light at a normal from coloured lights and point lights.
 */
#include "vertex.h"

/* Adds a light's amount, of which `left` is left, to the sums by channel, 2^30 = 1.0. */
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
        if ((tint->point_mask >> i & 1u) != 0)
            tint->points->beam(l, i, at, normal, &beam);
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
