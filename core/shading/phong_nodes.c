/*
 * phong_nodes.c - Phong where normals nearly agree: diffuse part and R.V
 * exactly at six nodes, and between them linear or quadratic (quadric_rows.c).
 *
 * A node needs no root: |w1 N1 + w2 N2|^2 = (w1 + w2)^2 (1 - k) with
 * k = 2 p e, p = w1 w2 / (w1 + w2)^2, e = 1 - N1.N2, and
 * 1/sqrt(1 - k) = 1 + k/2 + 3 k^2/8 + ..., off by 1e-6 at 15 degrees, 1e-5 at 22.
 */
#include "phong.h"

SETUP_FITS(struct linear_setup);
SETUP_FITS(struct quadric_setup);

/* 1 - cos of the largest angle between corner normals, Q1.30: 22 degrees without a highlight, */
#define WIDEST_DIFFUSE 78186000
/* with one 15 degrees for n <= 32, else 10; 12 and 8 for one above 1/2, as what it is off by grows with both. */
static const int32_t widest_highlight[2][2] = {{36586000, 16310000}, {23463000, 10449000}};
#define WIDEST_SPREAD 8192 /* UQ0.16: the ratio of 1/m over the triangle at most 1 1/8 */

/* Largest of 1 - Ni.Nj, Q1.30; pieces' normals are not of unit length and count as far apart. */
static int32_t widest(const struct surface_corners *c, int32_t e[3])
{
    static const uint8_t first[3] = {0, 0, 1}, second[3] = {1, 2, 2};
    int32_t most = 0;

    for (int k = 0; k < 3; k++) {
        const int16_t *a = c->at.normal[first[k]], *b = c->at.normal[second[k]];
        int32_t dot = asr32(a[0] * b[0], 2) + asr32(a[1] * b[1], 2) + asr32(a[2] * b[2], 2); /* |parts| <= 2^28 */
        int32_t quarter = max32(0, 32767 * 32767 / 4 - dot);
        e[k] = quarter > INT32_MAX / 4 ? INT32_MAX : 4 * quarter;
        most = max32(most, e[k]);
    }
    return (c->at.v[0]->flags & LIT_AS_SEEN) != 0 ? INT32_MAX : most;
}

/* v.N at the corners, Q1.30, held at +-1.0. */
static void corner_dots(const struct surface_corners *c, const int32_t lacks[3], const sheen_q30_t v[3], int32_t dot[3])
{
    for (int k = 0; k < 3; k++) {
        int32_t d = unit_dot_q29(c->at.normal[k], lacks[k], v);
        d = min32(max32(d, -(1 << 29)), 1 << 29) * 2;
        dot[k] = c->back ? -d : d;
    }
}

/* a * b for |a| <= 1.0 (Q1.30, 16 bits of it are used) and b: Q1.30. */
static int32_t times(int32_t a, int32_t b)
{
    return 2 * mul_16_32(asr32(a, 15), b);
}

/* v.N at the edges' middles: the mean in the ratio of the weights, over the length. */
static void middle_dots(const struct middles *m, const int32_t e[3], const int32_t corner[3], int32_t middle[3])
{
    static const uint8_t first[3] = {0, 0, 1}, second[3] = {1, 2, 2};

    for (int k = 0; k < 3; k++) {
        int32_t share = m->share[k], p = asr32(share * (32768 - share), 15); /* Q0.15, <= 1/4 */
        int32_t length = 4 * mul_16_32(p, e[k]);                             /* k, Q1.30 */
        int32_t longer = length / 2 + 3 * (times(length, length) / 8);       /* 1/sqrt(1 - k) - 1 */
        int32_t mean = corner[second[k]] + 2 * mul_16_32(share, corner[first[k]] - corner[second[k]]);
        middle[k] = mean + times(mean, longer);
    }
}

static void excesses(struct nodes *n, const int32_t middle[3])
{
    n->excess[0] = 4 * (middle[0] - n->corner[0] / 2 - n->corner[1] / 2);
    n->excess[1] = 4 * (middle[1] - n->corner[0] / 2 - n->corner[2] / 2);
    n->excess[2] = 4 * (middle[2] - n->corner[1] / 2 - n->corner[2] / 2);
}

/* Bounds over the triangle: a product of two coordinates is at most 1/4. */
static int32_t lower_bound(const struct nodes *n)
{
    int32_t least = min32(n->corner[0], min32(n->corner[1], n->corner[2]));

    return least + min32(n->excess[0], 0) / 4 + min32(n->excess[1], 0) / 4 + min32(n->excess[2], 0) / 4;
}

static int32_t upper_bound(const struct nodes *n)
{
    int32_t most = max32(n->corner[0], max32(n->corner[1], n->corner[2]));

    return most + max32(n->excess[0], 0) / 4 + max32(n->excess[1], 0) / 4 + max32(n->excess[2], 0) / 4;
}

/* 1 where some pixel may come out above 1.0 in a channel; u: least 1 - R.V, Q2.29. */
static int exceeds(const struct draw *d, const struct nodes *diffuse, int32_t u)
{
    const struct colour_terms *terms = &d->colour;
    struct lit most = {(uint32_t)max32(0, min32(asr32(upper_bound(diffuse), 15) + 1, 32768)), power_at(d->power, u)};
    int over = 0;

    for (int k = 0; k < 3 && terms->clamp; k++)
        over |= colour_channel(terms, k, &most) > terms->top[k];
    return over;
}

/* 1 where leaving the excess out stays under 1/32 level, and no pixel lies beyond the light's edge. */
static int nearly_linear(const struct setup *s, const struct nodes *diffuse)
{
    const struct colour_terms *terms = &s->draw->colour;
    uint32_t off =
        (magnitude32(diffuse->excess[0]) + magnitude32(diffuse->excess[1]) + magnitude32(diffuse->excess[2])) >>
        17; /* UQ1.15 of a quarter */
    uint32_t most = terms->b[0] > terms->b[1] ? terms->b[0] : terms->b[1];

    return diffuse->corner[0] >= 0 && diffuse->corner[1] >= 0 && diffuse->corner[2] >= 0 &&
           off * most <= 1u << (terms->fraction - 5);
}

/* Channels at the corners, interpolated like Gouraud's. */
static APART void linear_channels(struct setup *s, const struct gradients *g, const struct nodes *diffuse)
{
    uint32_t channel[3][3];

    s->way = SHEEN_WAY_PHONG_LINEAR;
    for (int k = 0; k < 3; k++) {
        const struct lit lit = {(uint32_t)((diffuse->corner[k] + (1 << 14)) >> 15), 0};
        for (int i = 0; i < 3; i++)
            channel[i][k] = colour_channel(&s->draw->colour, i, &lit);
    }
    sheen_setup_linear(s, g, channel);
}

/* 1 - R.V at six nodes, Q2.29: lv1 - (L.N)(V.N). */
static void reflection(const struct lighting *l, const int32_t diffuse[6], const int32_t view[6], struct nodes *n)
{
    int32_t middle[3];

    for (int k = 0; k < 3; k++) {
        n->corner[k] = l->lv1[0] - mul_round(diffuse[k], view[k], 30);
        middle[k] = l->lv1[0] - mul_round(diffuse[3 + k], view[3 + k], 30);
    }
    excesses(n, middle);
}

/* The six nodes of both functions; returns the widest angle between normals as 1 - cos, Q1.30. */
static APART int32_t nodes_of(const struct setup *s, const struct surface_corners *c, struct nodes *diffuse,
                              struct nodes *reflected)
{
    const struct lighting *l = &s->draw->light;
    int32_t e[3], lacks[3], light[6], view[6];
    struct middles middles;

    int32_t apart = widest(c, e);
    if (apart > WIDEST_DIFFUSE || sheen_weight_spread(c) > WIDEST_SPREAD)
        return INT32_MAX;
    sheen_middles(c, &middles);
    for (int k = 0; k < 3; k++)
        lacks[k] = lacking(c->at.normal[k]);
    corner_dots(c, lacks, l->to[0], light);
    middle_dots(&middles, e, light, light + 3);
    for (int k = 0; k < 3; k++)
        diffuse->corner[k] = light[k];
    excesses(diffuse, light + 3);
    corner_dots(c, lacks, l->view, view);
    middle_dots(&middles, e, view, view + 3);
    reflection(l, light, view, reflected);
    return apart;
}

/* Returns 0 where the triangle is too small for node products. */
static APART int quadrics(struct setup *s, const struct gradients *g, const struct nodes *diffuse,
                          const struct nodes *reflected, int highlight)
{
    struct quadric_setup *q = (struct quadric_setup *)s;
    struct node_products products;

    if (!sheen_node_products(&products, g))
        return 0;
    s->way = SHEEN_WAY_PHONG_QUADRATIC;
    s->rows = highlight ? sheen_quadric_rows_power : sheen_quadric_rows_diffuse;
    sheen_node_quadric(g, &products, diffuse, &q->diffuse);
    q->diffuse.base += 1u << 14; /* rounding to UQ1.15, once for all pixels */
    if (highlight)
        sheen_node_quadric(g, &products, reflected, &q->second);
    return 1;
}

int sheen_phong_nodes(struct setup *s, const struct surface_corners *c, const struct gradients *g)
{
    const struct power *power = &s->draw->power;
    struct nodes diffuse, reflected;

    int32_t apart = nodes_of(s, c, &diffuse, &reflected);
    if (apart == INT32_MAX)
        return 0;
    int32_t least = lower_bound(&reflected);
    int highlight = upper_bound(&diffuse) > 0 && least < 1 << (power->shift + 8);
    if (highlight && apart > widest_highlight[s->draw->strong][power->shininess > 32])
        return 0;
    int faded = highlight && lower_bound(&diffuse) < FADED << 15;
    s->fast = s->draw->early && !faded && !exceeds(s->draw, &diffuse, highlight ? least : INT32_MAX);
    if (!highlight && way_wanted(s->draw, SHEEN_WAY_PHONG_LINEAR) && nearly_linear(s, &diffuse)) {
        linear_channels(s, g, &diffuse);
        return 1;
    }
    s->detail = (uint8_t)faded;
    return way_wanted(s->draw, SHEEN_WAY_PHONG_QUADRATIC) && quadrics(s, g, &diffuse, &reflected, highlight);
}
