/*
 * tinted.c - a triangle's normals and colours from the shares of its corners, row by row.
 */
#include "tinted.h"

static void begin_lights(struct tinted_lights *lights, const struct draw *d)
{
    for (int k = 0; k < 3; k++) {
        uint32_t all = 0; /* UQ2.30 */
        for (unsigned i = 0; i < d->light.count; i++) {
            lights->color[i][k] = (uint16_t)by_colour(32768, d->tint.color[i][k]);
            all += (uint32_t)d->light.diffuse_weight[i] * lights->color[i][k];
        }
        lights->ambient[k] = d->colour.a[k] + mul_high(d->tint.low[k], all << 1) * 2;
    }
}

void sheen_tinted_begin(struct tinted_run *run, const struct setup *s, union shared_triangle of,
                        const struct shares *planes)
{
    int32_t step[3];

    begin_lights(&run->lights, s->draw);
    sheen_shared_colors(s, of, run->color);
    run->planes = planes;
    shares_step(planes, step);
    sheen_shared(step, run->color, run->dc);
    run->dweight = planes->weight.dx;
    run->dz = s->depth.dx;
}

void sheen_tinted_row(struct tinted_run *run, const struct setup *s, int32_t x, int32_t y, int32_t share[3])
{
    shares_at(run->planes, x, y, share);
    sheen_shared(share, run->color, run->c);
    run->weight = plane_at(&run->planes->weight, x, y);
    run->z = plane_at(&s->depth, x, y);
}

void sheen_tinted_rows(const struct tile *t, const struct setup *s)
{
    const struct shares_setup *p = (const struct shares_setup *)s;
    struct tinted_run run;
    int32_t share[3];
    int16_t normal[3][3];

    sheen_tinted_begin(&run, s, p->of, &p->shares);
    sheen_shared_normals(s, p->of, normal);
    shares_step(&p->shares, share);
    sheen_shared(share, normal, run.dn);
    for (unsigned row = 0; row < t->rows; row++) {
        const int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        if (x >= x1)
            continue;
        sheen_tinted_row(&run, s, x, y, share);
        sheen_shared(share, normal, run.n);
        sheen_tinted_run(t, s->draw, x, x1, y, &run);
    }
}

void sheen_setup_tinted(struct setup *s, struct surface_corners *c, const struct gradients *g)
{
    sheen_setup_shares((struct shares_setup *)s, c, g);
    s->way = SHEEN_WAY_PHONG_LIGHTS;
    s->rows = sheen_tinted_rows;
    s->fast = 0;
}
