/*
 * shade_phong.c - linear interpolation of normals (lecture, "Phong Shading",
 * "Clever Implementation"): no vector is ever normalised.
 *
 * With N(x, y) linear on the screen (times 1/m: Blinn's way, the factor drops
 * out), L.N and V.N are linear and D = N.N is quadratic: adds only. One
 * r = 1/sqrt(D) a pixel gives both terms,
 *   diffuse  = (L.N) r,   R.V = 2 (L.N)(V.N) r^2 - L.V.
 * Over a triangle the result does not depend on its orientation.
 */
#include "newton.h"
#include "shade.h"

/* Steps of the normal below 2 a px in Q2.29, or the triangle is scaled down, at most so many bits. */
#define STEEPEST ((int64_t)1 << 30)
#define MAX_SCALE 6

/* Corner normals times weight, Q2.29; component i of corner k at [i][k]. Range: |normal| <= 2^15, weight <= 2^16. */
static void weighted_normals(const struct surface_corners *c, int32_t n[3][3])
{
    for (int k = 0; k < 3; k++) {
        int32_t weight = (int32_t)((c->weight[k] >> 16) + (c->weight[k] >> 15 & 1u));
        for (int i = 0; i < 3; i++) {
            int32_t component = c->back ? -c->at.normal[k][i] : c->at.normal[k][i];
            n[i][k] = asr32(component * weight, 2);
        }
    }
}

/* Normal at the origin pixel and its steps; 0 where they do not fit however scaled. */
static int normal_slopes(const struct gradients *g, int32_t n[3][3], struct slope slope[3])
{
    for (int scale = 0; scale <= MAX_SCALE; scale++) {
        int64_t steepest = 0;
        for (int i = 0; i < 3; i++) {
            sheen_slope(g, n[i], 0, &slope[i]);
            steepest |= (slope[i].dx < 0 ? -slope[i].dx : slope[i].dx) | (slope[i].dy < 0 ? -slope[i].dy : slope[i].dy);
        }
        if (steepest < STEEPEST)
            return 1;
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++)
                n[i][k] = asr32(n[i][k], 1);
    }
    return 0;
}

/* v . N as a plane, Q1.30: Q1.30 times Q2.29 is Q.59. Range: three terms below 2^60. */
static struct plane dot_plane(const struct gradients *g, const sheen_q30_t v[3], const struct slope n[3])
{
    struct slope s = {0, 0, 0};

    for (int i = 0; i < 3; i++) {
        s.value += v[i] * n[i].value;
        s.dx += v[i] * n[i].dx;
        s.dy += v[i] * n[i].dy;
    }
    s.value = round_shift64(s.value, 29);
    s.dx = round_shift64(s.dx, 29);
    s.dy = round_shift64(s.dy, 29);
    return sheen_slope_plane(g, &s);
}

/*
 * D = N.N by second differences, UQ1.31: Q2.29 squared is Q.58. With a px as the
 * step, N(x, y) = N + x Nx + y Ny gives D_xx = 2 Nx.Nx, D_xy = 2 Nx.Ny and the
 * first difference D(1, 0) - D(0, 0) = 2 N.Nx + Nx.Nx.
 * Range: |Nx|, |Ny| < 2^30, |N| <= 2^30: sums of three products below 2^62.
 */
static struct quadric square_quadric(const struct gradients *g, const struct slope n[3])
{
    int64_t nn = 0, nx = 0, ny = 0, xx = 0, xy = 0, yy = 0;

    for (int i = 0; i < 3; i++) {
        nn += n[i].value * n[i].value;
        nx += n[i].value * n[i].dx;
        ny += n[i].value * n[i].dy;
        xx += n[i].dx * n[i].dx;
        xy += n[i].dx * n[i].dy;
        yy += n[i].dy * n[i].dy;
    }
    uint32_t dxx = (uint32_t)round_shift64(xx, 26), dxy = (uint32_t)round_shift64(xy, 26);
    uint32_t dyy = (uint32_t)round_shift64(yy, 26);
    uint32_t dx = (uint32_t)round_shift64(nx, 26) + (uint32_t)round_shift64(xx, 27);
    uint32_t dy = (uint32_t)round_shift64(ny, 26) + (uint32_t)round_shift64(yy, 27);
    int32_t ox = -g->origin[0], oy = -g->origin[1];
    uint32_t x = (uint32_t)ox, y = (uint32_t)oy;

    /* The polynomial about pixel (0, 0) of the target, (ox, oy) from the origin pixel; exact modulo 2^32. */
    struct quadric q = {0, dx + x * dxx + y * dxy, dy + y * dyy + x * dxy, dxx, dxy, dyy};
    q.base = (uint32_t)round_shift64(nn, 27) + x * dx + y * dy + pairs(ox) * dxx + x * y * dxy + pairs(oy) * dyy;
    return q;
}

static void constant_normal(const struct sheen_frame *f, struct setup *s, int32_t n[3][3])
{
    sheen_q30_t sum[3], unit[3] = {0, 0, 0};
    int16_t normal[3];
    struct lit lit;

    for (int i = 0; i < 3; i++)
        sum[i] = n[i][0] / 4 + n[i][1] / 4 + n[i][2] / 4;
    (void)sheen_normalize(sum, unit); /* a zero sum stays zero: ambient only */
    for (int i = 0; i < 3; i++)
        normal[i] = (int16_t)min32(asr32(unit[i] + (1 << 14), 15), 32767);
    sheen_light_normal(&s->draw->light, s->draw->material, normal, &lit);
    sheen_setup_constant(f, s, &lit);
}

void sheen_setup_phong(const struct sheen_frame *f, struct setup *s, const struct surface_corners *c,
                       const struct gradients *g)
{
    const struct lighting *l = &s->draw->light;
    int32_t n[3][3];
    struct slope slope[3];

    weighted_normals(c, n);
    if (g == NULL || l->count == 0 || !normal_slopes(g, n, slope)) {
        constant_normal(f, s, n);
        return;
    }
    s->way = SHEEN_WAY_PHONG_ROOT;
    s->clamp = s->draw->colour.clamp;
    s->shade.phong.light = dot_plane(g, l->to[0], slope);
    s->shade.phong.view = dot_plane(g, l->view, slope);
    s->shade.phong.square = square_quadric(g, slope);
}

/*
 * D outside the root table's [1/4, 1 + 1/512): normals far apart, or a triangle
 * scaled down. D is brought back by a power of four and L.N, V.N by its root.
 * Returns 0 where there is no direction left.
 */
static int rescale(uint32_t *d, int32_t *ln, int32_t *nv)
{
    if (*d < 1u << 8)
        return 0;
    while (*d < 1u << 29) {
        *d <<= 2;
        *ln = (int32_t)((uint32_t)*ln << 1);
        *nv = (int32_t)((uint32_t)*nv << 1);
    }
    while (*d >= (1u << 31) + (1u << 22)) {
        *d >>= 2;
        *ln = asr32(*ln, 1);
        *nv = asr32(*nv, 1);
    }
    return 1;
}

/* Intensities at a pixel from L.N, V.N (Q1.30) and D = N.N (UQ1.31). */
SPECIALISED void light_pixel(const struct sheen_material *m, int32_t lv1, int32_t ln, int32_t nv, uint32_t d,
                             struct lit *lit)
{
    lit->diffuse = 0;
    lit->specular = 0;
    if (ln <= 0)
        return;
    if (d - (1u << 29) >= (3u << 29) + (1u << 22) && !rescale(&d, &ln, &nv))
        return;
    /*
     * Range: L.N <= sqrt(D), so the first product is below 2^31 and its quotient at most 1.0 but for rounding;
     * unsigned, so that nothing overflows where a sliver's rounding has parted the two.
     */
    uint32_t root = root_seed(d);                                     /* UQ1.15 */
    uint32_t diffuse = (((uint32_t)ln + (1u << 14)) >> 15) * root >> 15; /* Q0.15 */
    int32_t facing = asr32((int32_t)((uint32_t)asr32(nv, 15) * root), 15); /* Q0.15 */
    if (diffuse > 32768)
        diffuse = 32768;
    lit->diffuse = diffuse;
    /* u = 1 - R.V = (1 + L.V) - 2 (L.N)(V.N), Q2.29: a product of two Q0.15 is half of itself there */
    lit->specular = (power_at(m, (int32_t)((uint32_t)lv1 - diffuse * (uint32_t)facing)) + 1) >> 1;
}

SPECIALISED void root_rows(const struct tile *t, const struct setup *s, int clamp, unsigned swap)
{
    const struct colour_terms *terms = &s->draw->colour;
    const struct sheen_material *material = s->draw->material;
    const struct quadric *q = &s->shade.phong.square;
    const uint32_t dln = s->shade.phong.light.dx, dnv = s->shade.phong.view.dx, dz = s->depth.dx;
    const int32_t lv1 = s->draw->light.lv1[0];
    const uint32_t half = 1u << (terms->fraction - 1);

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x0 = t->spans[row].x0, y = t->first_row + (int32_t)row, count = t->spans[row].x1 - x0;
        if (count <= 0)
            continue;
        uint32_t at = tile_offset(t, x0, y), z = plane_at(&s->depth, x0, y);
        uint32_t ln = plane_at(&s->shade.phong.light, x0, y), nv = plane_at(&s->shade.phong.view, x0, y);
        uint32_t d = quadric_at(q, x0, y), dd = q->dx + (uint32_t)x0 * q->dxx + (uint32_t)y * q->dxy;
        uint16_t *pixels = t->pixels + at, *depth = t->depth + at;
        do {
            if (depth_test(depth, z)) {
                struct lit lit;
                light_pixel(material, lv1, (int32_t)ln, (int32_t)nv, d, &lit);
                *pixels = pixel_of(colour_channel(terms, 0, &lit) + half, colour_channel(terms, 1, &lit) + half,
                                   colour_channel(terms, 2, &lit) + half, terms->fraction, clamp, swap);
                COUNT_SHADED(t);
            }
            pixels++;
            depth++;
            z += dz;
            ln += dln;
            nv += dnv;
            d += dd;
            dd += q->dxx;
        } while (--count > 0);
    }
}

void sheen_shade_phong_root(const struct tile *t, const struct setup *s)
{
    if (s->clamp)
        root_rows(t, s, 1, t->swap);
    else if (t->swap)
        root_rows(t, s, 0, 1);
    else
        root_rows(t, s, 0, 0);
}
