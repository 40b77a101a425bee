/*
 * phong.c - makes L.N, V.N and N.N over the triangle from normals at its corners (lecture, "Clever Implementation",
 * with the change in D corrected: its second difference is constant), and chooses among Phong's ways.
 */
#include "phong.h"
#include "../triangle/normal.h"

SETUP_FITS(struct phong_setup);
SETUP_FITS(struct phong_cells_setup);

/* px: in a triangle magnified beyond this, thousands of pixels share the error of its corners' 16 bits. */
#define LARGEST_BY_ROOT 2048
#define SMALLEST_CELLS (4u << 2 * 3) /* px: four cells of 8 by 8 */
#define FAR_SUM 26000                /* UQ0.15: the sum of |Ni - Nj|^2 / 4 is 0.8 */

/* ---- one light, normals far apart ---- */

/*
 * Limits of this way. Steps of 15 bits leave N.N off by about h 4^stretch / 2^16, at worst by 8 times that, with 4 h =
 * |Ni - Nj|^2: h 4^stretch, UQ.16, may be up to MOST_STRETCHED, which is 24.0, and four times as much for n <= 32. And
 * N.N gets too small if normals are over 50 degrees apart (FAR_APART) while 1/m changes along an edge by over 1/4 of
 * its mean (ROOT_LEAN).
 */
#define MOST_STRETCHED (24u << 16)
#define FAR_APART 767107767u
#define ROOT_LEAN 65536

/*
 * The excess (quadric.c) of N.N on an edge: -|wi Ni - wj Nj|^2 = -(wi wj h + (wi - wj)^2), Q.17. h: |Ni - Nj|^2;
 * w: UQ0.15, up to 1.0.
 */
static int32_t square_excess(const int32_t w[3], int i, int j, uint32_t h)
{
    uint32_t product = (uint32_t)(w[i] * w[j]) >> 15, apart = (uint32_t)((w[i] - w[j]) * (w[i] - w[j]));

    return -(int32_t)((product * (h >> 16) >> 12) + (apart >> 13));
}

/* 0 if N.N would not be exact enough. */
static APART COLD int root_way(struct setup *s, struct surface_corners *c, const struct gradients *g,
                               const struct facing *f)
{
    struct phong_setup *p = (struct phong_setup *)s;
    struct quadric_steps steps;
    int32_t w[3], lean[3];

    if (!sheen_quadric_steps(&steps, g)) /* refuses needles too, so 2^16 << 2 stretch stays in 32 bits */
        return 0;
    const unsigned more = s->draw->power.shininess > 32 ? 0 : 2; /* a highlight multiplies the error by n */
    if ((g->stretch > 0 && (f->apart >> 16) << 2 * g->stretch > MOST_STRETCHED << more) ||
        (f->apart > FAR_APART && !sheen_leans(lean, c, ROOT_LEAN)))
        return 0;
    sheen_corner_weights(c, w);
    const int32_t square = w[0] * w[0];
    const int32_t k[3] = {square_excess(w, 0, 1, f->h[0]), square_excess(w, 0, 2, f->h[1]),
                          square_excess(w, 1, 2, f->h[2])};
    s->way = SHEEN_WAY_PHONG_ROOT;
    s->rows = sheen_phong_rows;
    p->x = (int16_t)g->origin[0];
    p->y = (int16_t)g->origin[1];
    p->light = sheen_weighted_plane(g, w, f->ln);
    p->view = sheen_weighted_plane(g, w, f->nv);
    sheen_fine_quadric(&p->square, &steps, (uint32_t)square << 1, asr32(w[1] * w[1] - square, 13),
                       asr32(w[2] * w[2] - square, 13), k);
    return 1;
}

/* ---- several lights; one light over large triangles, or if no other way takes the triangle ---- */

/*
 * The plane of w x, w up to 2^15. sheen_plane takes differences of 15 bits; the bits cut off make a second plane,
 * except where planes are made in 64 bits anyway.
 */
static struct plane fine_plane(const struct gradients *g, const int32_t w[3], const int32_t x[3])
{
    const int32_t f[3] = {w[0] * x[0], w[1] * x[1], w[2] * x[2]};

    if (g->wide)
        return sheen_gradient_plane(g, f, 0);
    const int32_t low1 = asr32(f[1], 1) - asr32(f[0], 1) - cut_cosine(f[1], f[0]) * 32768;
    const int32_t low2 = asr32(f[2], 1) - asr32(f[0], 1) - cut_cosine(f[2], f[0]) * 32768;
    const struct plane high = sheen_weighted_plane(g, w, x);
    struct plane p;

    sheen_plane(&p, g, high.base, low1, low2, 1);
    p.dx += high.dx;
    p.dy += high.dy;
    return p;
}

/* How far the normal may turn over a cell, in 1/1000 rad; half as far if normals are far apart. */
static uint32_t cell_turn(const struct draw *d, int far)
{
    static const uint8_t turn[2][3] = {{200, 140, 70}, {100, 65, 33}}; /* second row: highlights above 1/2 */
    const unsigned n = d->power.shininess;

    return (uint32_t)turn[d->strong][n > 32 ? 2 : n > 16 ? 1 : 0] >> far;
}

/* N.N of the shortest corner normal, UQ0.15: pieces' normals are linear between the mesh's, and so shorter than 1.0. */
static uint32_t shortest_of(const struct surface_corners *c)
{
    uint32_t least = UINT32_MAX;

    for (int k = 0; k < 3; k++) {
        const int16_t *n = c->at.normal[k];
        uint32_t square = (uint32_t)(n[0] * n[0]) + (uint32_t)(n[1] * n[1]) + (uint32_t)(n[2] * n[2]);
        least = square < least ? square : least;
    }
    return least < 1u << 30 ? least >> 15 : 1u << 15;
}

/* A sum of squares of steps, Q1.30 each and below 2^-5: UQ.40. */
static uint32_t square_of_steps(uint32_t x, uint32_t y, uint32_t z)
{
    const int32_t s[3] = {asr32((int32_t)x, 10), asr32((int32_t)y, 10), asr32((int32_t)z, 10)};

    return (uint32_t)(s[0] * s[0]) + (uint32_t)(s[1] * s[1]) + (uint32_t)(s[2] * s[2]);
}

/*
 * The value of `detail`; 0: the triangle is too steep or too small for cells. The normal turns by at most |Nx| / |N|
 * per pixel. Over the triangle N.N is at least the smallest weight's square times the difference of the shortest
 * normal's N.N and the sum of |Ni - Nj|^2 / 4.
 */
static unsigned cells_of(const struct phong_normals_setup *p, const struct surface_corners *c,
                         const struct gradients *g, const struct facing *f, const int32_t w[3])
{
    const struct plane *n = p->normal;
    const uint32_t apart = ((f->h[0] >> 2) + (f->h[1] >> 2) + (f->h[2] >> 2)) >> 15, pixels = g->area >> 13;
    const uint32_t smallest = (uint32_t)min32(w[0], min32(w[1], w[2]));
    const uint32_t shortest = shortest_of(c);
    const uint32_t least = (smallest * smallest >> 15) * (apart < shortest ? shortest - apart : 0) >> 15;
    unsigned shift = 5;

    for (int i = 0; i < 3; i++)
        if (magnitude32((int32_t)n[i].dx) >= 1u << 25 || magnitude32((int32_t)n[i].dy) >= 1u << 25)
            return 0;
    const uint32_t xx = square_of_steps(n[0].dx, n[1].dx, n[2].dx), yy = square_of_steps(n[0].dy, n[1].dy, n[2].dy);
    if (least == 0)
        return 0;
    const struct draw *draw = p->s.draw;
    const int far = apart > FAR_SUM;
    const uint32_t turn = cell_turn(draw, far), rate = QUOTIENT(xx > yy ? xx : yy, least); /* UQ.25 */
    while (shift >= 3 && (rate > (turn * turn * 33u + 500u) >> 2 * shift || pixels < 4u << 2 * shift))
        shift--;
    if (shift < 3)
        return 0;
    /* draws with other dither thresholds than squares have do not set is_565: see take_general_loops */
    /* linear over 4 px, a highlight is off by at most 4^2 / 8 of its second difference, 4 n rate: 1/6 level */
    const uint32_t most = draw->colour.c[0] > draw->colour.c[1] ? draw->colour.c[0] : draw->colour.c[1];
    int squares = draw->is_565 && draw->loop.usable && rate < 1u << 16 &&
                  (rate * draw->power.shininess >> 8) * (most >> 7) < 10486u >> far;
    return shift | (squares ? CELLS_IN_SQUARES : 0);
}

COLD void sheen_phong_lights_rows(const struct tile *t, const struct setup *s)
{
    const struct plane *p = ((const struct phong_normals_setup *)s)->normal;

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        struct normal_run run = {plane_at(&s->depth, x, y),
                                 s->depth.dx,
                                 {plane_at(&p[0], x, y), plane_at(&p[1], x, y), plane_at(&p[2], x, y)},
                                 {p[0].dx, p[1].dx, p[2].dx}};
        if (x < x1)
            draw_normal_run(t, s->draw, x, x1, y, &run);
    }
}

/* The plane of N.v for a unit vector v, Q1.30; exact at the origin pixel, off by 2^-31 per pixel from there. */
static struct plane dot_plane(const struct plane normal[3], const struct gradients *g, const int32_t v[3])
{
    const int32_t x = g->origin[0], y = g->origin[1];
    struct plane p = {0, 0, 0};

    for (int i = 0; i < 3; i++) {
        const struct plane *n = &normal[i];
        p.dx += (uint32_t)sheen_mul_round((int32_t)n->dx, v[i], 30);
        p.dy += (uint32_t)sheen_mul_round((int32_t)n->dy, v[i], 30);
        p.base += (uint32_t)sheen_mul_round((int32_t)plane_at(n, x, y), v[i], 30);
    }
    p.base -= (uint32_t)x * p.dx + (uint32_t)y * p.dy;
    return p;
}

/* Makes the planes of N. f: of the one light, if cells are wanted, else NULL. Returns 0 if there can be no cells. */
static APART int normal_planes(struct setup *s, struct surface_corners *c, const struct gradients *g,
                               const struct facing *f)
{
    struct phong_normals_setup *p = (struct phong_normals_setup *)s;
    int32_t w[3], seen[3];

    sheen_corner_weights(c, w);
    for (int k = 0; k < 3; k++)
        seen[k] = c->back ? -w[k] : w[k];
    for (int i = 0; i < 3; i++) {
        const int32_t x[3] = {c->at.normal[0][i], c->at.normal[1][i], c->at.normal[2][i]};
        p->normal[i] = fine_plane(g, seen, x);
    }
    s->way = SHEEN_WAY_PHONG_LIGHTS;
    s->rows = sheen_phong_lights_rows;
    if (f == NULL)
        return 1;
    s->detail = cells_of(p, c, g, f, w) & 15u;
    if (s->detail == 0)
        return 0;
    struct phong_cells_setup *cells = (struct phong_cells_setup *)s;
    cells->light = dot_plane(p->normal, g, s->draw->light.to[0]);
    cells->view = dot_plane(p->normal, g, s->draw->light.view);
    s->way = SHEEN_WAY_PHONG_CELLS;
    s->rows = sheen_phong_cell_rows;
    return 1;
}

HOT static void phong_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    const unsigned lights = s->draw->light.count;
    struct facing f;

    if (g == NULL || lights == 0) {
        sheen_setup_mean_normal(s, c);
        return;
    }
    if (lights == 1) {
        const int piece = (c->at.v[0]->flags & LIT_AS_SEEN) != 0; /* pieces keep no cosines */
        sheen_face(&f, c);
        if ((!piece && sheen_setup_reflection(s, c, g, &f)) ||
            (g->area >> 13 >= SMALLEST_CELLS && way_wanted(s->draw, SHEEN_WAY_PHONG_CELLS) &&
             normal_planes(s, c, g, &f)) ||
            (!piece && !s->draw->pixel_ramp && !s->draw->fog && g->area >> 13 < LARGEST_BY_ROOT &&
             root_way(s, c, g, &f)))
            return;
    }
    (void)normal_planes(s, c, g, NULL);
}

const struct sheen_shader sheen_phong = {.begin = sheen_reflection_begin,
                                         .light = sheen_keep_cosines,
                                         .setup = phong_setup,
                                         .quads = QUADS_REFLECTED,
                                         .find_shades = sheen_shades_of,
                                         .needs_normals = 1,
                                         .corners = OF_MESH(normals),
                                         .reads_normals = 1,
                                         .at_pixels = 1};
