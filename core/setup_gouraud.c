/*
 * setup_gouraud.c - intensities at the corners to planes of the three channels,
 * and the choice between linear on the screen and Blinn's quotient.
 */
#include "stages.h"

/* Intensities at a corner: lit when the mesh was drawn, or now for back faces. */
static void corner_lit(const struct setup *s, const struct surface_corners *c, int k, struct lit *lit)
{
    const struct vertex *v = c->at.v[k];

    if (!c->back || (v->flags & LIT_AS_SEEN) != 0) {
        lit->diffuse = v->diffuse;
        lit->specular = v->specular;
        return;
    }
    const int16_t *n = c->at.normal[k];
    const int16_t negated[3] = {(int16_t)-max32(n[0], -32767), (int16_t)-max32(n[1], -32767),
                                (int16_t)-max32(n[2], -32767)};
    sheen_light_normal(&s->draw->light, s->draw->material, negated, lit);
}

/*
 * Largest error of linear interpolation on the screen in place of in space:
 * dI (sqrt q - 1) / (sqrt q + 1) <= dI (q - 1) / 4, q the ratio of the weights.
 * 1 where it stays under 1/32 level: channels have `fraction` bits a level.
 */
static int nearly_linear(const struct surface_corners *c, int32_t channel[3][3], unsigned fraction)
{
    uint32_t low = c->weight[0], high = low;
    int32_t difference = 0;

    if (c->flat_weight)
        return 1;
    for (int k = 1; k < 3; k++) {
        low = c->weight[k] < low ? c->weight[k] : low;
        high = c->weight[k] > high ? c->weight[k] : high;
    }
    for (int k = 0; k < 3; k++) {
        int32_t least = min32(channel[k][0], min32(channel[k][1], channel[k][2]));
        int32_t most = max32(channel[k][0], max32(channel[k][1], channel[k][2]));
        difference = max32(difference, most - least);
    }
    /* difference / 2^fraction * (high - low) / low / 4 <= 1/32; the product is below 2^63 */
    return (uint64_t)(uint32_t)difference * (high - low) <= (uint64_t)low << (fraction - 3);
}

void sheen_setup_gouraud(const struct sheen_frame *f, struct setup *s, const struct surface_corners *c,
                         const struct gradients *g)
{
    const struct colour_terms *terms = &s->draw->colour;
    int32_t channel[3][3]; /* by channel and corner, < 2^31 */
    struct lit lit[3];

    for (int k = 0; k < 3; k++)
        corner_lit(s, c, k, &lit[k]);
    if (g == NULL) {
        struct lit mean = {(lit[0].diffuse + lit[1].diffuse + lit[2].diffuse) / 3,
                           (lit[0].specular + lit[1].specular + lit[2].specular) / 3};
        sheen_setup_constant(f, s, &mean);
        return;
    }
    uint8_t clamp = 0;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            channel[i][k] = (int32_t)colour_channel(terms, i, &lit[k]);
            clamp |= terms->clamp && (uint32_t)channel[i][k] > terms->top[i];
        }
    s->way = nearly_linear(c, channel, terms->fraction) ? SHEEN_WAY_GOURAUD_LINEAR : SHEEN_WAY_GOURAUD_QUOTIENT;
    s->fast = sheen_rounds_early(f) && !clamp && s->way == SHEEN_WAY_GOURAUD_LINEAR;
    if (s->way == SHEEN_WAY_GOURAUD_QUOTIENT) {
        const int32_t half_weight[3] = {(int32_t)(c->weight[0] >> 1), (int32_t)(c->weight[1] >> 1),
                                        (int32_t)(c->weight[2] >> 1)};
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++)
                channel[i][k] = (int32_t)mul_high((uint32_t)channel[i][k], c->weight[k]);
        s->shade.gouraud.weight = sheen_gradient_plane(g, half_weight, 1);
    }
    for (int i = 0; i < 3; i++) {
        s->shade.gouraud.channel[i] = sheen_gradient_plane(g, channel[i], 0);
        if (s->fast) /* + 1/2 once for all pixels */
            s->shade.gouraud.channel[i].base += 1u << (terms->fraction - 1);
    }
}
