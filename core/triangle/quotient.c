/*
 * quotient.c - set-up of channels that are linear in space.
 */
#include "quotient.h"

SETUP_FITS(struct quotient_setup);

void sheen_setup_quotient(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                          uint32_t channel[3][3])
{
    struct quotient_setup *q = (struct quotient_setup *)s;
    int32_t value[3]; /* < 2^31 */

    s->way = SHEEN_WAY_GOURAUD_QUOTIENT;
    s->rows = sheen_quotient_rows;
    s->special_loop = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            value[k] = (int32_t)mul_high(channel[i][k], c->weight[k]);
        q->channel[i] = sheen_gradient_plane(g, value, 0);
    }
    for (int k = 0; k < 3; k++)
        value[k] = (int32_t)(c->weight[k] >> 1);
    q->weight = sheen_gradient_plane(g, value, 1);
}
