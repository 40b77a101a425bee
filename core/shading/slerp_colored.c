/*
 * slerp_colored.c - slerp with colours of vertices and lights: normals go along arcs, colours are linear in space.
 */
#include "../triangle/tinted.h"
#include "slerp.h"

/* As struct shares_setup, with the corners' places and weights besides. */
struct slerp_colored_setup {
    struct setup s;
    union shared_triangle of;
    struct shares shares;
    int16_t x[3], y[3]; /* clockwise; in the units of struct slerp_corner */
    uint16_t weight[3];
};
SETUP_FITS(struct slerp_colored_setup);

struct tinted_arc_row {
    struct arc_row of;
    struct tinted_run run;
};

static void draw_tinted(const struct tile *t, struct arc_row *r, const struct part *p)
{
    struct tinted_arc_row *row = (struct tinted_arc_row *)r;
    int32_t share[3];

    sheen_slerp_normals(r, p, row->run.n, row->run.dn);
    sheen_tinted_row(&row->run, r->s, p->x, r->y, share);
    sheen_tinted_run(t, r->s->draw, p->x, p->x1, r->y, &row->run);
}

/* Makes the corners. Normals come in the mesh's order, which is counter-clockwise for a front face. */
static APART void tinted_corners(const struct slerp_colored_setup *s, struct slerp_corners *at)
{
    struct surface_corners c = {.back = 0, .flat_weight = 0};
    struct vertex v[3];
    int16_t kept[3][3], normal[3][3];

    sheen_shared_normals(&s->s, s->of, kept);
    for (int k = 0; k < 3; k++) {
        const int16_t *own = kept[k == 0 || (s->s.detail & SHARES_BACK) != 0 ? k : 3 - k];
        int32_t unit[3] = {own[0], own[1], own[2]};
        const int piece = (s->s.detail & SHARES_PIECE) != 0 && sheen_normalize(unit, unit) == SHEEN_OK;
        for (int i = 0; i < 3; i++)
            normal[k][i] = piece ? (int16_t)min32(round15(unit[i]), 32767) : own[i];
        v[k].x = s->x[k];
        v[k].y = s->y[k];
        c.at.v[k] = &v[k];
        c.at.normal[k] = normal[k];
        c.weight[k] = (uint32_t)s->weight[k] << 16;
    }
    sheen_slerp_corners(at, &c, NULL);
}

static void tinted_slerp_rows(const struct tile *t, const struct setup *setup)
{
    const struct slerp_colored_setup *s = (const struct slerp_colored_setup *)setup;
    struct slerp_corners at;
    struct tinted_arc_row row;

    tinted_corners(s, &at);
    row.of.s = setup;
    row.of.at = &at;
    row.of.parts = sheen_slerp_normal_parts;
    row.of.draw = draw_tinted;
    sheen_tinted_begin(&row.run, setup, s->of, &s->shares);
    sheen_slerp_draw(t, &row.of);
}

/* If normals nearly agree, linear ones suffice: arcs differ from them by less than a level shows. */
static void slerp_colored_setup(struct setup *setup, struct surface_corners *c, const struct gradients *g)
{
    struct slerp_colored_setup *s = (struct slerp_colored_setup *)setup;
    const int piece = (c->at.v[0]->flags & LIT_AS_SEEN) != 0; /* pieces have shares in place of normals */
    uint32_t h[3];

    if (g != NULL && !piece && sheen_setup_tinted_quadrics(setup, c, g, CLOSE_ARCS))
        return;
    sheen_setup_tinted(setup, c, g);
    if (g == NULL || setup->draw->light.count == 0 || (!piece && sheen_normals_apart(c->at.normal, h) <= CLOSE_ARCS))
        return;
    for (unsigned k = 0; k < 3; k++) {
        s->x[k] = c->at.v[k]->x;
        s->y[k] = c->at.v[k]->y;
        s->weight[k] = slerp_weight(c, k);
    }
    setup->way = SHEEN_WAY_SLERP_NORMALS;
    setup->rows = tinted_slerp_rows;
}

const struct sheen_shader sheen_slerp_colored = {.begin = sheen_tinted_quadrics_begin,
                                                 .light = sheen_keep_cosines,
                                                 .carry = sheen_carry_shares,
                                                 .setup = slerp_colored_setup,
                                                 .needs_normals = 1,
                                                 .corners = OF_MESH(normals),
                                                 .reads_normals = 1,
                                                 .unit_normals = LINEAR_IN_SPACE,
                                                 .at_pixels = 1};
