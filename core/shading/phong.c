/*
 * phong.c - normals at the corners to L.N, V.N and N.N over the triangle
 * (lecture, "Clever Implementation"; the change in D as mended: its second
 * difference is constant).
 */
#include "phong.h"

SETUP_FITS(struct phong_setup);
SETUP_FITS(struct phong_lights_setup);

/* Steps of the normal below 2 a px in Q2.29, or the triangle is scaled down, at most so many bits. */
#define STEEPEST ((int64_t)1 << 30)
#define MAX_SCALE 6

/* Corner normals times weight, Q2.29; component i of corner k at [i][k]. Range: |normal| < 2^15, weight <= 2^16. */
static void weighted_normals(const struct surface_corners *c, int32_t n[3][3])
{
    for (int k = 0; k < 3; k++) {
        int32_t weight = (int32_t)((c->weight[k] >> 16) + (c->weight[k] >> 15 & 1u));
        for (int i = 0; i < 3; i++) {
            int32_t component = max32(c->at.normal[k][i], -32767);
            n[i][k] = asr32((c->back ? -component : component) * weight, 2);
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

/* A component of N as a plane, Q1.30. */
static struct plane normal_plane(const struct gradients *g, const struct slope *n)
{
    const struct slope s = {n->value * 2, n->dx * 2, n->dy * 2};

    return sheen_slope_plane(g, &s);
}

/* x / 2^shift, rounded; modulo 2^32, so x may have wrapped. */
static uint32_t low_word(uint64_t x, unsigned shift)
{
    return (uint32_t)((x + ((uint64_t)1 << (shift - 1))) >> shift);
}

/*
 * D = N.N by second differences, UQ1.31: Q2.29 squared is Q.58. With a px as the
 * step, N(x, y) = N + x Nx + y Ny gives D_xx = 2 Nx.Nx, D_xy = 2 Nx.Ny and the
 * first difference D(1, 0) - D(0, 0) = 2 N.Nx + Nx.Nx.
 * A second difference is off by up to 2^-32, which counts x^2 / 2 times: so D is
 * exact at `middle` and not at a corner, which may lie 1,000 px off the picture.
 * N may be of any size there: only 59 bits of the sums are used, modulo 2^64.
 */
static struct quadric square_quadric(const struct gradients *g, const struct slope n[3], const int32_t middle[2])
{
    const int64_t right = middle[0] - g->origin[0], down = middle[1] - g->origin[1];
    uint64_t nn = 0, nx = 0, ny = 0, xx = 0, xy = 0, yy = 0;

    for (int i = 0; i < 3; i++) {
        uint64_t x = (uint64_t)n[i].dx, y = (uint64_t)n[i].dy;
        uint64_t here = (uint64_t)(n[i].value + right * n[i].dx + down * n[i].dy);
        nn += here * here;
        nx += here * x;
        ny += here * y;
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    return sheen_quadric(middle, low_word(nn, 27), low_word(nx, 26) + low_word(xx, 27),
                         low_word(ny, 26) + low_word(yy, 27), low_word(xx, 26), low_word(xy, 26), low_word(yy, 26));
}

/* The pixel nearest to the picture's middle that the triangle may reach: vertices count from there. */
static void middle_pixel(const struct gradients *g, const struct surface_corners *c, int32_t pixel[2])
{
    int32_t first[2] = {c->at.v[0]->x, c->at.v[0]->y}, low[2] = {first[0], first[1]}, high[2] = {first[0], first[1]};

    for (int k = 1; k < 3; k++) {
        low[0] = min32(low[0], c->at.v[k]->x);
        low[1] = min32(low[1], c->at.v[k]->y);
        high[0] = max32(high[0], c->at.v[k]->x);
        high[1] = max32(high[1], c->at.v[k]->y);
    }
    for (int i = 0; i < 2; i++) { /* corner 0 lies at origin + 1/2 - centre */
        int32_t from_first = max32(low[i], min32(high[i], 0)) - first[i];
        pixel[i] = g->origin[i] + asr32(SUBPIXEL_HALF - g->centre[i] + from_first, SUBPIXEL_BITS);
    }
}

/* Blocks of 16 px to 1/4 degree a px, of 8 px to 1/2 (with |N| = 1/2; twice that with 1); 0: neither. Steps: Q2.29. */
static uint8_t block_shift(const struct slope slope[3])
{
    const int64_t half_degree = 4685000; /* 2^29 * pi / 360 */
    int64_t steepest = 0;

    for (int i = 0; i < 3; i++) {
        int64_t step = slope[i].dx < 0 ? -slope[i].dx : slope[i].dx;
        steepest = step > steepest ? step : steepest;
    }
    return steepest <= half_degree / 4 ? 4 : steepest <= half_degree / 2 ? 3 : 0;
}

/* Normals that are linear over the triangle. Returns 0 where their steps do not fit. */
static APART int linear_normals(struct setup *s, const struct surface_corners *c, const struct gradients *g)
{
    const struct lighting *l = &s->draw->light;
    int32_t n[3][3], middle[2];
    struct slope slope[3];

    weighted_normals(c, n);
    if (!normal_slopes(g, n, slope))
        return 0;
    s->fast = s->draw->early && !s->draw->colour.clamp;
    if (l->count > 1) {
        struct phong_lights_setup *several = (struct phong_lights_setup *)s;
        s->way = SHEEN_WAY_PHONG_LIGHTS;
        s->rows = sheen_phong_lights_rows;
        for (int i = 0; i < 3; i++)
            several->normal[i] = normal_plane(g, &slope[i]);
        return 1;
    }
    struct phong_setup *one = (struct phong_setup *)s;
    s->detail = block_shift(slope);
    s->way =
        s->detail != 0 && way_wanted(s->draw, SHEEN_WAY_PHONG_BLOCKS) ? SHEEN_WAY_PHONG_BLOCKS : SHEEN_WAY_PHONG_ROOT;
    s->rows = sheen_phong_rows;
    one->light = dot_plane(g, l->to[0], slope);
    one->view = dot_plane(g, l->view, slope);
    middle_pixel(g, c, middle);
    one->square = square_quadric(g, slope, middle);
    return 1;
}

static void phong_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    unsigned lights = s->draw->light.count;

    sheen_weigh(c);
    if (g == NULL || lights == 0 || (!(lights == 1 && sheen_phong_nodes(s, c, g)) && !linear_normals(s, c, g)))
        sheen_setup_mean_normal(s, c);
}

const struct sheen_shader sheen_phong = {.setup = phong_setup, .needs_normals = 1};
