/*
 * tinted.c - a triangle's normals and colours from the shares of its corners, row by row.
 */
#include "tinted.h"

#if !FAST_LOOPS
void put_tinted(const struct tile *t, const struct draw *d, struct rounding rounding, uint32_t at, int32_t x,
                uint32_t z, struct channels c)
{
    put_tinted_here(t, d, rounding, at, x, z, c);
}
#endif

/* The part of a channel's step that a light of that weight, UQ1.15, and colour has. */
static uint16_t step_of(uint32_t step, uint32_t weight, uint8_t colour)
{
    return (uint16_t)((step * by_colour(weight, colour) + HALF) >> 15);
}

HOT void sheen_tinted_beam(struct tinted_beam *beam, const struct draw *d, unsigned light)
{
    const uint8_t *colour = d->tint.color[light];

    for (int k = 0; k < 3; k++) {
        beam->base[k] = step_of(d->colour.b[k], d->light.diffuse_weight[light], colour[k]);
        beam->gloss[k] = step_of(d->colour.c[k], d->light.specular_weight[light], colour[k]);
    }
}

void sheen_tinted_begin(struct tinted_run *run, const struct setup *s, union shared_triangle of,
                        const struct shares *planes)
{
    int32_t step[3];

    for (unsigned i = 0; i < s->draw->light.count; i++)
        sheen_tinted_beam(&run->beam[i], s->draw, i);
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

HOT void sheen_tinted_rows(const struct tile *t, const struct setup *s)
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
}
