/*
 * constant.c - one colour a triangle: what flat shading and degenerate triangles use.
 */
#include "triangle.h"

SETUP_FITS(struct constant_setup);

void sheen_setup_constant(struct setup *s, const struct lit *lit)
{
    struct constant_setup *constant = (struct constant_setup *)s;
    const struct colour_terms *terms = &s->draw->colour;
    const uint32_t half = 1u << (terms->fraction - 1);
    uint32_t level[3];

    for (int k = 0; k < 3; k++) {
        uint32_t channel = colour_channel(terms, k, lit);
        constant->channel[k] = channel < terms->top[k] ? channel : terms->top[k];
        level[k] = (constant->channel[k] + half) >> terms->fraction;
    }
    s->way = SHEEN_WAY_FLAT;
    s->fast = s->draw->early != 0;
    s->rows = sheen_constant_rows;
    constant->value = (uint16_t)(level[0] << 11 | level[1] << 5 | level[2]);
}

/* One colour from the mean of the corners' normals: triangles too flat for gradients, or without a light. */
void sheen_setup_mean_normal(struct setup *s, const struct surface_corners *c)
{
    sheen_q30_t sum[3], unit[3] = {0, 0, 0};
    int16_t normal[3];
    struct lit lit;

    for (int i = 0; i < 3; i++) {
        sum[i] = c->at.normal[0][i] + c->at.normal[1][i] + c->at.normal[2][i];
        sum[i] = c->back ? -sum[i] : sum[i];
    }
    (void)sheen_normalize(sum, unit); /* a zero sum stays zero: ambient only */
    for (int i = 0; i < 3; i++)
        normal[i] = (int16_t)min32(asr32(unit[i] + (1 << 14), 15), 32767);
    sheen_light_normal(&s->draw->light, s->draw->power, normal, &lit);
    sheen_setup_constant(s, &lit);
}
