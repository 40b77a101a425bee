/*
 * constant.c - one colour per triangle: for flat shading and for triangles too flat for gradients.
 */
#include "triangle.h"

SETUP_FITS(struct constant_setup);

/* A dithered colour becomes planes without steps; otherwise the finished pixel is made here. */
HOT void sheen_setup_colour(struct setup *s, uint32_t channel[3])
{
    const struct draw *d = s->draw;
    const struct colour_terms *terms = &d->colour;
    struct linear_setup *linear = (struct linear_setup *)s;

    for (int k = 0; k < 3; k++)
        channel[k] = clamped(channel[k], terms->top[k]);
    s->way = SHEEN_WAY_FLAT;
    if (!d->dither) {
        s->rows = sheen_constant_rows;
        ((struct constant_setup *)s)->pixel = sheen_finished(terms, d->is_565, d->swap, channel);
        return;
    }
    s->special_loop = d->is_565;
    s->rows = sheen_dithered_constant_rows;
    for (int k = 0; k < 3; k++)
        linear->channel[k] = (struct plane){channel[k], 0, 0};
}

HOT void sheen_setup_constant(struct setup *s, const struct lit *lit)
{
    uint32_t channel[3];

    for (int k = 0; k < 3; k++)
        channel[k] = colour_channel(&s->draw->colour, k, lit);
    sheen_setup_colour(s, channel);
}

/* One colour from the mean of the corners' normals: for triangles too flat for gradients, or without a light. */
COLD void sheen_setup_mean_normal(struct setup *s, const struct surface_corners *c)
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
    light_normal(&s->draw->light, &s->draw->power, normal, &lit);
    sheen_setup_constant(s, &lit);
}
