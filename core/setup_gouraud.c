/*
 * setup_gouraud.c - intensities at the corners to planes or quadrics, and the choice
 * among linear on the screen, quadratic, and Blinn's quotient.
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

/* Largest difference of a channel between corners, in 1/16 level, 0xffff at the most. */
static uint32_t difference_of(int32_t channel[3][3], unsigned fraction)
{
    int32_t difference = 0;

    for (int k = 0; k < 3; k++) {
        int32_t least = min32(channel[k][0], min32(channel[k][1], channel[k][2]));
        int32_t most = max32(channel[k][0], max32(channel[k][1], channel[k][2]));
        difference = max32(difference, most - least);
    }
    return (uint32_t)min32((difference >> (fraction - 4)) + 1, 0xffff);
}

/*
 * Linear on the screen in place of in space is off by at most
 * dI (sqrt q - 1) / (sqrt q + 1) <= dI (q - 1) / 4, q the ratio of the weights;
 * through the edges' middles by about dI (q - 1)^2 / 32. Both stay under 1/32 level.
 * Range: difference < 2^16 in 1/16 level, spread <= 2^16 in 1/65536.
 */
static enum sheen_way way_of(const struct setup *s, const struct surface_corners *c, uint32_t difference)
{
    uint32_t spread = sheen_weight_spread(c);

    if (c->flat_weight || (difference * spread >> 17 == 0 && sheen_way_wanted(s->draw, SHEEN_WAY_GOURAUD_LINEAR)))
        return SHEEN_WAY_GOURAUD_LINEAR;
    if (spread < 16384 && difference * (spread * spread >> 16) >> 20 == 0 &&
        sheen_way_wanted(s->draw, SHEEN_WAY_GOURAUD_QUADRATIC))
        return SHEEN_WAY_GOURAUD_QUADRATIC;
    return SHEEN_WAY_GOURAUD_QUOTIENT;
}

/* Linear channels, or under quotient channels and 1 times weight. */
static void channel_planes(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                           int32_t channel[3][3])
{
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
            s->shade.gouraud.channel[i].base += 1u << (s->draw->colour.fraction - 1);
    }
}

/* An intensity's quadric, Q1.30, rounding added: an edge's excess is (4 share - 2) (first - second). */
static struct quadric intensity_quadric(const struct gradients *g, const struct node_products *p,
                                        const struct middles *m, const uint32_t intensity[3])
{
    struct nodes n;
    struct quadric q;

    for (int k = 0; k < 3; k++)
        n.corner[k] = (int32_t)(intensity[k] << 15);
    n.excess[0] = 8 * mul_16_32(m->share[0] - 16384, n.corner[0] - n.corner[1]);
    n.excess[1] = 8 * mul_16_32(m->share[1] - 16384, n.corner[0] - n.corner[2]);
    n.excess[2] = 8 * mul_16_32(m->share[2] - 16384, n.corner[1] - n.corner[2]);
    q = sheen_node_quadric(g, p, &n);
    q.base += 1u << 14;
    return q;
}

/* Returns 0 where the triangle is too small for node products. */
static int quadratic(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                     const struct lit lit[3])
{
    const uint32_t diffuse[3] = {lit[0].diffuse, lit[1].diffuse, lit[2].diffuse};
    const uint32_t specular[3] = {lit[0].specular, lit[1].specular, lit[2].specular};
    struct node_products products;
    struct middles middles;

    if (!sheen_node_products(&products, g))
        return 0;
    sheen_middles(c, &middles);
    s->highlight = (specular[0] | specular[1] | specular[2]) != 0;
    s->shade.quadratic.diffuse = intensity_quadric(g, &products, &middles, diffuse);
    if (s->highlight)
        s->shade.quadratic.second = intensity_quadric(g, &products, &middles, specular);
    return 1;
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
    s->way = (uint8_t)way_of(s, c, difference_of(channel, terms->fraction));
    s->fast = sheen_rounds_early(f) && !clamp && s->way != SHEEN_WAY_GOURAUD_QUOTIENT;
    if (s->way == SHEEN_WAY_GOURAUD_QUADRATIC) {
        if (quadratic(s, c, g, lit))
            return;
        s->way = SHEEN_WAY_GOURAUD_QUOTIENT;
        s->fast = 0;
    }
    channel_planes(s, c, g, channel);
}
