/*
 * gouraud.c - intensities at the corners to planes or quadrics, and the choice
 * among linear on the screen, quadratic, and Blinn's quotient.
 */
#include "gouraud.h"

SETUP_FITS(struct linear_setup);
SETUP_FITS(struct quadric_setup);
SETUP_FITS(struct quotient_setup);

/* Intensities at a corner: lit when the mesh was drawn, or now for back faces. */
static void corner_lit(const struct setup *s, const struct surface_corners *c, int k, struct lit *lit)
{
    const struct vertex *v = c->at.v[k];

    if (!c->back || (v->flags & LIT_AS_SEEN) != 0) {
        lit->diffuse = v->kept[0];
        lit->specular = v->kept[1];
        return;
    }
    const int16_t *n = c->at.normal[k];
    const int16_t negated[3] = {(int16_t)-max32(n[0], -32767), (int16_t)-max32(n[1], -32767),
                                (int16_t)-max32(n[2], -32767)};
    sheen_light_normal(&s->draw->light, s->draw->power, negated, lit);
}

/* Of the corners' channels: the largest difference, in 1/16 level, 0xffff at the most; and whether one exceeds 1.0. */
struct survey {
    uint32_t difference;
    int over;
};

static struct survey survey_of(const struct colour_terms *terms, const struct lit lit[3])
{
    struct survey survey = {0, 0};

    for (int i = 0; i < 3; i++) {
        uint32_t least = UINT32_MAX, most = 0;
        for (int k = 0; k < 3; k++) {
            uint32_t channel = colour_channel(terms, i, &lit[k]);
            least = channel < least ? channel : least;
            most = channel > most ? channel : most;
        }
        uint32_t difference = ((most - least) >> (terms->fraction - 4)) + 1;
        survey.difference = difference > survey.difference ? difference : survey.difference;
        survey.over |= terms->clamp && most > terms->top[i];
    }
    survey.difference = survey.difference > 0xffff ? 0xffff : survey.difference;
    return survey;
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

    if (c->flat_weight || (difference * spread >> 17 == 0 && way_wanted(s->draw, SHEEN_WAY_GOURAUD_LINEAR)))
        return SHEEN_WAY_GOURAUD_LINEAR;
    if (spread < 16384 && difference * (spread * spread >> 16) >> 20 == 0 &&
        way_wanted(s->draw, SHEEN_WAY_GOURAUD_QUADRATIC))
        return SHEEN_WAY_GOURAUD_QUADRATIC;
    return SHEEN_WAY_GOURAUD_QUOTIENT;
}

/* Linear channels; fast: + 1/2 once for all pixels. */
static void linear(struct setup *s, const struct gradients *g, const struct lit lit[3])
{
    struct linear_setup *l = (struct linear_setup *)s;
    const struct colour_terms *terms = &s->draw->colour;

    s->rows = sheen_linear_rows;
    for (int i = 0; i < 3; i++) {
        int32_t value[3]; /* < 2^31 */
        for (int k = 0; k < 3; k++)
            value[k] = (int32_t)colour_channel(terms, i, &lit[k]);
        l->channel[i] = sheen_gradient_plane(g, value, 0);
        l->channel[i].base += s->fast ? 1u << (terms->fraction - 1) : 0;
    }
}

/* Channels and 1 times weight. */
static APART void quotient_planes(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                                  const struct lit lit[3])
{
    struct quotient_setup *q = (struct quotient_setup *)s;
    int32_t value[3]; /* < 2^31 */

    s->way = SHEEN_WAY_GOURAUD_QUOTIENT;
    s->rows = sheen_quotient_rows;
    s->fast = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            value[k] = (int32_t)mul_high(colour_channel(&s->draw->colour, i, &lit[k]), c->weight[k]);
        q->channel[i] = sheen_gradient_plane(g, value, 0);
    }
    for (int k = 0; k < 3; k++)
        value[k] = (int32_t)(c->weight[k] >> 1);
    q->weight = sheen_gradient_plane(g, value, 1);
}

/* An intensity's quadric, Q1.30, rounding added: an edge's excess is (4 share - 2) (first - second). */
static void intensity_quadric(const struct gradients *g, const struct node_products *p, const struct middles *m,
                              struct nodes *n, struct quadric *q)
{
    n->excess[0] = 8 * mul_16_32(m->share[0] - 16384, n->corner[0] - n->corner[1]);
    n->excess[1] = 8 * mul_16_32(m->share[1] - 16384, n->corner[0] - n->corner[2]);
    n->excess[2] = 8 * mul_16_32(m->share[2] - 16384, n->corner[1] - n->corner[2]);
    sheen_node_quadric(g, p, n, q);
    q->base += 1u << 14;
}

/* Returns 0 where the triangle is too small for node products. */
static APART int quadratic(struct setup *s, const struct surface_corners *c, const struct gradients *g,
                           const struct lit lit[3])
{
    struct quadric_setup *q = (struct quadric_setup *)s;
    int highlight = (lit[0].specular | lit[1].specular | lit[2].specular) != 0;
    struct node_products products;
    struct middles middles;
    struct nodes n;

    if (!sheen_node_products(&products, g))
        return 0;
    sheen_middles(c, &middles);
    for (int k = 0; k < 3; k++)
        n.corner[k] = (int32_t)(lit[k].diffuse << 15);
    intensity_quadric(g, &products, &middles, &n, &q->diffuse);
    s->rows = highlight ? sheen_quadric_rows_specular : sheen_quadric_rows_diffuse;
    for (int k = 0; k < 3; k++)
        n.corner[k] = (int32_t)(lit[k].specular << 15);
    if (highlight)
        intensity_quadric(g, &products, &middles, &n, &q->second);
    return 1;
}

static void gouraud_setup(struct setup *s, const struct surface_corners *c, const struct gradients *g)
{
    struct lit lit[3];

    for (int k = 0; k < 3; k++)
        corner_lit(s, c, k, &lit[k]);
    if (g == NULL) {
        struct lit mean = {(lit[0].diffuse + lit[1].diffuse + lit[2].diffuse) / 3,
                           (lit[0].specular + lit[1].specular + lit[2].specular) / 3};
        sheen_setup_constant(s, &mean);
        return;
    }
    struct survey survey = survey_of(&s->draw->colour, lit);
    s->way = (uint8_t)way_of(s, c, survey.difference);
    s->fast = s->draw->early && !survey.over;
    if (s->way == SHEEN_WAY_GOURAUD_LINEAR)
        linear(s, g, lit);
    else if (s->way == SHEEN_WAY_GOURAUD_QUOTIENT || !quadratic(s, c, g, lit))
        quotient_planes(s, c, g, lit);
}

/* A vertex keeps its intensities. */
static void gouraud_light(const struct draw *d, const int16_t normal[3], uint16_t kept[2])
{
    struct lit lit;

    sheen_light_normal(&d->light, d->power, normal, &lit);
    kept[0] = (uint16_t)lit.diffuse;
    kept[1] = (uint16_t)lit.specular;
}

const struct sheen_shader sheen_gouraud = {.light = gouraud_light, .setup = gouraud_setup, .needs_normals = 1};
