/*
 * quadric.c - a quadratic function over a triangle from six nodes: the
 * corners and the middles of the edges, so that triangles that share an edge agree
 * along it.
 *
 * Excesses are small, so 15 bits of them and of the products do: 32-bit arithmetic
 * throughout, off by less than a hundredth of the excess.
 */
#include "triangle.h"

/* Steps of the barycentric coordinates keep 14 bits: value = raw / 2^scale. */
#define STEP_SHIFT 1
/* Steps up to 4 a px; smaller triangles take the exact way. */
#define LOWEST_SCALE 12
/* So do needles: a product of coordinates is off by about 2^-14 (extent * step)^2, extent * step < 2^(stretch + 1). */
#define QUADRIC_STRETCH 3

/* x * 2^shift, rounded where shift < 0; modulo 2^32 where bits leave at the top. */
static uint32_t shifted(int32_t x, int shift)
{
    return shift >= 0 ? (uint32_t)x << shift : (uint32_t)asr32(asr32(x, (unsigned)(-shift - 1)) + 1, 1);
}

/* The ends of edges 01, 02, 12. */
static const uint8_t first_end[3] = {0, 0, 1}, second_end[3] = {1, 2, 2};

int sheen_node_products(struct node_products *p, const struct gradients *g)
{
    int32_t bx[3], by[3], b[3]; /* of the three coordinates: steps, and values at the origin pixel, Q18.13 */

    p->scale = (int)g->exponent - STEP_SHIFT;
    if (p->scale < LOWEST_SCALE || g->stretch > QUADRIC_STRETCH)
        return 0;
    bx[1] = asr32(g->b1[0], STEP_SHIFT);
    by[1] = asr32(g->b1[1], STEP_SHIFT);
    bx[2] = asr32(g->b2[0], STEP_SHIFT);
    by[2] = asr32(g->b2[1], STEP_SHIFT);
    bx[0] = -bx[1] - bx[2];
    by[0] = -by[1] - by[2];
    for (int k = 1; k < 3; k++) /* |b| <= 4: below 2^15 */
        b[k] = (int32_t)shifted(bx[k] * g->centre[0] + by[k] * g->centre[1], 13 - SUBPIXEL_BITS - p->scale);
    b[0] = (1 << 13) - b[1] - b[2];

    for (int e = 0; e < 3; e++) { /* Range: |bx|, |by| <= 2^15 for coordinate 0, 2^14 for the others */
        int i = first_end[e], j = second_end[e];
        p->xx[e] = asr32(bx[i] * bx[j], 14);
        p->yy[e] = asr32(by[i] * by[j], 14);
        p->xy[e] = asr32(bx[i] * by[j], 14) + asr32(by[i] * bx[j], 14);
        p->x[e] = asr32(b[i] * bx[j], 15) + asr32(b[j] * bx[i], 15);
        p->y[e] = asr32(b[i] * by[j], 15) + asr32(b[j] * by[i], 15);
        p->constant[e] = asr32(b[i] * b[j], 13);
    }
    return 1;
}

/* Sum of excess (Q16.15, 13 bits) times product (16 bits): below 2^31. */
static int32_t weighted(const int32_t excess[3], const int32_t product[3])
{
    return excess[0] * product[0] + excess[1] * product[1] + excess[2] * product[2];
}

void sheen_node_quadric(const struct gradients *g, const struct node_products *p, const struct nodes *n,
                        struct quadric *q)
{
    struct slope plane;
    int32_t k[3];
    int second = 29 - 2 * p->scale, first = 17 - p->scale; /* to Q1.30 */

    sheen_slope(g, n->corner, 0, &plane);
    for (int e = 0; e < 3; e++)
        k[e] = asr32(n->excess[e] + (1 << 14), 15);
    int32_t xx = weighted(k, p->xx), xy = weighted(k, p->xy), yy = weighted(k, p->yy);
    uint32_t qxx = shifted(xx, second), qyy = shifted(yy, second);

    *q = sheen_quadric(g->origin, (uint32_t)plane.value + shifted(weighted(k, p->constant), 2),
                       (uint32_t)plane.dx + shifted(weighted(k, p->x), first) + qxx,
                       (uint32_t)plane.dy + shifted(weighted(k, p->y), first) + qyy, shifted(xx, second + 1),
                       shifted(xy, second), shifted(yy, second + 1));
}

/* At an edge's middle on the screen the first end counts w1 / (w1 + w2). */
void sheen_middles(const struct surface_corners *c, struct middles *m)
{
    for (int e = 0; e < 3; e++) {
        m->share[e] = 1 << 14;
        if (c->flat_weight)
            continue;
        uint32_t first = c->weight[first_end[e]] >> 1, sum = first + (c->weight[second_end[e]] >> 1);
        unsigned zeros = clz32(sum | 1u);
        m->share[e] = (int32_t)(((first << zeros) >> 16) * reciprocal_seed(sum << zeros) >> 16);
    }
}

uint32_t sheen_weight_spread(const struct surface_corners *c)
{
    uint32_t low = c->weight[0], high = low;

    if (c->flat_weight)
        return 0;
    for (int k = 1; k < 3; k++) {
        low = c->weight[k] < low ? c->weight[k] : low;
        high = c->weight[k] > high ? c->weight[k] : high;
    }
    uint32_t over = high - low, unit = low >> 16; /* low < 2^32 */
    return over >> 16 >= unit ? 65535 : over / (unit > 0 ? unit : 1);
}
