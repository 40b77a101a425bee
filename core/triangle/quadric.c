/*
 * quadric.c - a quadratic function over a triangle, made from its values at the corners and its excess at the middle of
 * each edge, so that triangles that share an edge agree along it.
 *
 * With barycentric coordinates b and f's excess k = 4 middle - 2 (end + end) on an edge,
 *   f = plane through the corners + k01 b0 b1 + k02 b0 b2 + k12 b1 b2.
 * Steps of b have 15 bits, their products 20, excesses 8, so 32-bit arithmetic suffices throughout.
 */
#include "quadric.h"

#define MOST_EXCESS 203 /* of k; 204 once rounded: ten products of that and a number up to 2^20 stay below 2^31 */
#define MOST_SLOPE 16383

HOT int sheen_quadric_steps(struct quadric_steps *p, const struct gradients *g)
{
    const int32_t px = g->b1[0], py = g->b1[1], qx = g->b2[0], qy = g->b2[1];

    if (!quadric_fits(g->exponent, g->stretch))
        return 0;
    p->g = g;
    p->b1b1[0] = asr32(px * px, 10);
    p->b1b1[1] = asr32(px * py, 9);
    p->b1b1[2] = asr32(py * py, 10);
    p->b1b2[0] = asr32(px * qx, 10);
    p->b1b2[1] = asr32(px * qy, 10) + asr32(py * qx, 10);
    p->b1b2[2] = asr32(py * qy, 10);
    p->b2b2[0] = asr32(qx * qx, 10);
    p->b2b2[1] = asr32(qx * qy, 9);
    p->b2b2[2] = asr32(qy * qy, 10);
    return 1;
}

/* x * 2^-shift, rounded; modulo 2^32 if bits leave at the top. */
static inline int32_t shifted(int32_t x, int shift)
{
    return shift > 0 ? asr32(asr32(x, (unsigned)min32(shift, 31) - 1) + 1, 1) : (int32_t)((uint32_t)x << -shift);
}

static inline uint32_t magnitudes(int32_t x, int32_t y, int32_t z)
{
    return magnitude32(x) | magnitude32(y) | magnitude32(z);
}

/* How many low bits to drop from `all` so that it is at most `most`. */
static inline unsigned surplus(uint32_t all, uint32_t most)
{
    unsigned drop = 0;

    while (all >> drop > most)
        drop++;
    return drop;
}

static inline int32_t rounded(int32_t x, unsigned drop)
{
    return drop > 0 ? asr32(asr32(x, drop - 1) + 1, 1) : x;
}

/* By how many bits numbers as large as `all`, shifted so, exceed 30 bits; on triangles of about a pixel they do. */
static int room_of(uint32_t all, int shift)
{
    return max32(0, 2 - (int)clz32(all) - shift);
}

HOT void sheen_corner_quadric(struct quadric *q, const struct quadric_steps *p, uint32_t f0, int32_t d1, int32_t d2,
                              const int32_t k[3])
{
    const struct gradients *g = p->g;
    unsigned drop = surplus(magnitudes(k[0], k[1], k[2]), MOST_EXCESS);
    unsigned cut = surplus(magnitudes(d1 + k[0], d2 + k[1], 0), MOST_SLOPE);
    int second = 2 * g->exponent - 24 - (int)drop, first = g->exponent - 14 - (int)cut, room = 0;
    const int32_t k01 = rounded(k[0], drop), k02 = rounded(k[1], drop), k12 = rounded(k[2], drop);
    const int32_t mixed = k12 - k01 - k02, a = rounded(d1 + k[0], cut), b = rounded(d2 + k[1], cut);
    /* half of the second differences; terms that cancel may exceed 31 bits on the way */
    int32_t xx = mixed * p->b1b2[0] - k01 * p->b1b1[0] - k02 * p->b2b2[0];
    int32_t xy = mixed * p->b1b2[1] - k01 * p->b1b1[1] - k02 * p->b2b2[1];
    int32_t yy = mixed * p->b1b2[2] - k01 * p->b1b1[2] - k02 * p->b2b2[2];
    int32_t x = a * g->b1[0] + b * g->b2[0], y = a * g->b1[1] + b * g->b2[1];

    if (first < 0 || second < 2)
        room = max32(room_of(magnitudes(xx, xy, yy), second), room_of(magnitudes(x, y, 0), first));
    xx = shifted(xx, second + room);
    xy = shifted(xy, second + room);
    yy = shifted(yy, second + room);
    x = shifted(x, first + room);
    y = shifted(y, first + room);

    /* from corner 0 to the origin pixel's centre. Range: |centre| <= 32, the other factors have 30 bits */
    const int32_t cx = g->centre[0], cy = g->centre[1];
    int32_t tx = asr32(xx, 6) * cx + asr32(xy, 7) * cy, ty = asr32(yy, 6) * cy + asr32(xy, 7) * cx;
    q->base = f0 + ((uint32_t)(asr32(x + tx, 6) * cx + asr32(y + ty, 6) * cy) << room);
    q->dx = ((uint32_t)x + 2u * (uint32_t)tx + (uint32_t)xx) << room;
    q->dy = ((uint32_t)y + 2u * (uint32_t)ty + (uint32_t)yy) << room;
    q->dxx = (uint32_t)xx << (room + 1);
    q->dxy = (uint32_t)xy << room;
    q->dyy = (uint32_t)yy << (room + 1);
}

HOT void sheen_space_quadric(struct quadric *q, const struct quadric_steps *steps, const int32_t lean[3],
                             const int32_t f[3])
{
    const int32_t k[3] = {asr32((lean[0] >> 1) * (f[0] - f[1]), 16), asr32((lean[1] >> 1) * (f[0] - f[2]), 16),
                          asr32((lean[2] >> 1) * (f[1] - f[2]), 16)};

    sheen_corner_quadric(q, steps, ((uint32_t)f[0] << 15) + (1u << 14), 2 * (f[1] - f[0]), 2 * (f[2] - f[0]), k);
}

COLD void sheen_fine_quadric(struct quadric *q, const struct quadric_steps *p, uint32_t f0, int32_t d1, int32_t d2,
                             const int32_t k[3])
{
    unsigned drop = surplus(magnitudes(k[0], k[1], k[2]), MOST_EXCESS);
    int32_t high[3], low[3];
    struct quadric rest;

    for (int e = 0; e < 3; e++) { /* `high` is rounded towards 0, so that sheen_corner_quadric drops no bits of it */
        int32_t whole = (int32_t)(magnitude32(k[e]) >> drop << drop);
        high[e] = k[e] < 0 ? -whole : whole;
        low[e] = k[e] - high[e];
    }
    sheen_corner_quadric(q, p, f0, d1, d2, high);
    sheen_corner_quadric(&rest, p, 0, 0, 0, low);
    q->base += rest.base;
    q->dx += rest.dx;
    q->dy += rest.dy;
    q->dxx += rest.dxx;
    q->dxy += rest.dxy;
    q->dyy += rest.dyy;
}

/*
 * Differences of weights are those of z16 (vertex.h). The mean of all three weights is used in place of that of an
 * edge's two. Range: |z - z| < 2^16, `over` at most 2^15; as weights are at least 0, none is more than three times the
 * mean.
 */
HOT int sheen_leans(int32_t lean[3], const struct surface_corners *c, int32_t most)
{
    const struct screen *screen = c->screen;
    const int32_t z0 = c->at.v[0]->z, z1 = c->at.v[1]->z, z2 = c->at.v[2]->z;
    const uint32_t third = (uint32_t)(z0 + z1 + z2) * 21845u >> 16, width = 2 * (uint32_t)most;

    lean[0] = lean[1] = lean[2] = 0;
    if (screen->flat_weight)
        return 1;
    const int32_t mean = (int32_t)(third + z16_weight_offset(screen));
    if (mean < LEAST_MEAN)
        return 0;
    unsigned zeros = clz32((uint32_t)mean);
    int32_t over = (int32_t)(reciprocal_seed((uint32_t)mean << zeros) >> 1);
    lean[0] = asr32((z0 - z1) * over, 28 - zeros);
    lean[1] = asr32((z0 - z2) * over, 28 - zeros);
    lean[2] = lean[1] - lean[0];
    return (uint32_t)(lean[0] + most) <= width && (uint32_t)(lean[1] + most) <= width &&
           (uint32_t)(lean[2] + most) <= width;
}

HOT void sheen_quadric_from(struct quadric *to, const struct quadric *q, int32_t column, int32_t row)
{
    const uint32_t x = (uint32_t)column, y = (uint32_t)row;
    const uint32_t dx = q->dx + y * q->dxy;

    to->base = q->base + y * q->dy + pairs(row) * q->dyy + x * dx + pairs(column) * q->dxx;
    to->dx = dx + x * q->dxx;
    to->dy = q->dy + y * q->dyy + x * q->dxy;
    to->dxx = q->dxx;
    to->dxy = q->dxy;
    to->dyy = q->dyy;
}

COLD void sheen_quadric_rows(const struct tile *t, const struct setup *s)
{
    const struct quadric_setup *q = (const struct quadric_setup *)s;
    const enum second second = (enum second)s->detail;
    struct quadric f, u;

    sheen_quadric_from(&f, &q->diffuse, -q->x, t->first_row - q->y);
    sheen_quadric_from(&u, second != SECOND_NONE ? &q->second : &q->diffuse, -q->x, t->first_row - q->y);
    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x < x1) {
            struct shaded_run run;
            run.z = plane_at(&s->depth, x, y);
            run.dz = s->depth.dx;
            quadric_run(&f, x, &run.f, &run.df, &run.ddf);
            quadric_run(&u, x, &run.u, &run.du, &run.ddu);
            sheen_shaded_run(t, s->draw, x, x1, y, &run, second);
        }
        quadric_down(&f);
        quadric_down(&u);
    }
}
