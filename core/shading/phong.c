/*
 * phong.c - normals at the corners to L.N, V.N and N.N over the triangle (lecture, "Clever Implementation"; the change
 * in D as mended: its second difference is constant), and the choice among Phong's ways.
 */
#include "phong.h"

SETUP_FITS(struct phong_setup);
SETUP_FITS(struct phong_lights_setup);

/* ---- one light, normals far apart ---- */

/* N.N from 15 bits of steps is off by h 4^stretch: UQ.16 of it, 4 h = |Ni - Nj|^2; */
#define MOST_STRETCHED (24u << 16)
/* and where it gets small: 50 degrees and 1/m over an edge in the ratio of 1 1/4 at once. */
#define FAR_APART 767107767u
#define STEEPEST_LEAN 65536

/* A difference of Q0.30 in 2^-14: |f - f0| <= 2^31 - 2^16. */
static int32_t cut_cosine(int32_t f, int32_t f0)
{
    return asr32(asr32(f, 1) - asr32(f0, 1) + (1 << 14), 15);
}

/* L.N or N.V times weight at the corners, Q0.30, as a plane. */
static struct plane weighted_plane(const struct gradients *g, const int32_t w[3], const int32_t cosine[3])
{
    const int32_t f = w[0] * cosine[0];

    return sheen_plane(g, (uint32_t)f, cut_cosine(w[1] * cosine[1], f), cut_cosine(w[2] * cosine[2], f), 16);
}

/* |wi Ni - wj Nj|^2 = wi wj h + (wi - wj)^2 is what N.N lacks between corners: Q.17. w: UQ0.15, up to 1.0. */
static int32_t square_excess(const int32_t w[3], int i, int j, uint32_t h)
{
    uint32_t product = (uint32_t)(w[i] * w[j]) >> 15, apart = (uint32_t)((w[i] - w[j]) * (w[i] - w[j]));

    return -(int32_t)((product * (h >> 16) >> 12) + (apart >> 13));
}

/* 0 where N.N would be off. */
static APART int square_root_way(struct setup *s, struct surface_corners *c, const struct gradients *g,
                                 const struct facing *f)
{
    struct phong_setup *p = (struct phong_setup *)s;
    struct quadric_steps steps;
    int32_t w[3], lean[3];

    if (g->stretch > 0 && (f->apart >> 16) << 2 * g->stretch > MOST_STRETCHED)
        return 0;
    if ((f->apart > FAR_APART && !sheen_leans(lean, c, STEEPEST_LEAN)) || !sheen_quadric_steps(&steps, g))
        return 0;
    sheen_weigh(c);
    for (int k = 0; k < 3; k++)
        w[k] = (int32_t)((c->weight[k] >> 17) + (c->weight[k] >> 16 & 1u));
    const int32_t square = w[0] * w[0];
    const int32_t k[3] = {square_excess(w, 0, 1, f->h[0]), square_excess(w, 0, 2, f->h[1]),
                          square_excess(w, 1, 2, f->h[2])};
    s->way = SHEEN_WAY_PHONG_ROOT;
    s->rows = sheen_phong_rows;
    p->x = (int16_t)g->origin[0];
    p->y = (int16_t)g->origin[1];
    p->light = weighted_plane(g, w, f->ln);
    p->view = weighted_plane(g, w, f->nv);
    sheen_fine_quadric(&p->square, &steps, (uint32_t)square << 1, asr32(w[1] * w[1] - square, 13),
                       asr32(w[2] * w[2] - square, 13), k);
    return 1;
}

/* ---- several lights, and the rest ---- */

/* Planes of the normal times weight, Q1.30. Range: |normal| <= 2^15, weight <= 2^15. */
static APART void normal_planes(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    struct phong_lights_setup *p = (struct phong_lights_setup *)s;
    int32_t w[3];

    sheen_weigh(c);
    for (int k = 0; k < 3; k++) {
        w[k] = (int32_t)((c->weight[k] >> 17) + (c->weight[k] >> 16 & 1u));
        w[k] = c->back ? -w[k] : w[k];
    }
    s->way = SHEEN_WAY_PHONG_LIGHTS;
    s->rows = sheen_phong_lights_rows;
    for (int i = 0; i < 3; i++) {
        const int32_t n[3] = {c->at.normal[0][i], c->at.normal[1][i], c->at.normal[2][i]};
        p->normal[i] = weighted_plane(g, w, n);
    }
}

static void phong_setup(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    const unsigned lights = s->draw->light.count;
    struct facing f;

    if (g == NULL || lights == 0) {
        sheen_setup_mean_normal(s, c);
        return;
    }
    if (lights == 1 && (c->at.v[0]->flags & LIT_AS_SEEN) == 0) { /* pieces keep no cosines */
        sheen_face(&f, c);
        if (sheen_setup_reflection(s, c, g, &f) || square_root_way(s, c, g, &f))
            return;
    }
    normal_planes(s, c, g);
}

const struct sheen_shader sheen_phong = {.light = sheen_keep_cosines, .setup = phong_setup, .needs_normals = 1};
