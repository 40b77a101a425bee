/*
 * tinted.c - a triangle's normals and colours from the shares of its corners, row by row.
 */
#include "tinted.h"

static void begin_lights(struct tinted_lights *lights, const struct draw *d)
{
    for (int k = 0; k < 3; k++) {
        uint32_t all = 0;
        for (unsigned i = 0; i < d->light.count; i++) {
            const uint8_t color = d->tint.color[i][k];
            lights->diffuse[i][k] = (uint16_t)by_colour(d->light.diffuse_weight[i], color);
            lights->specular[i][k] = (uint16_t)by_colour(d->light.specular_weight[i], color);
            all += lights->diffuse[i][k];
        }
        lights->ambient[k] = d->colour.a[k] + mul_high(d->tint.low[k], all << 16) * 2;
    }
}

void sheen_tinted_begin(struct tinted_run *run, struct tinted_triangle *triangle, const struct setup *s,
                        union shared_triangle of, const struct shares *planes)
{
    begin_lights(&run->lights, s->draw);
    sheen_shared_colors(s, of, triangle->color);
    triangle->planes = planes;
    shares_step(planes, triangle->step);
    sheen_shared(triangle->step, triangle->color, run->dc);
    run->dweight = planes->weight.dx;
    run->dz = s->depth.dx;
}

void sheen_tinted_row(struct tinted_run *run, struct tinted_triangle *triangle, const struct setup *s, int32_t x,
                      int32_t y, int32_t share[3])
{
    shares_at(triangle->planes, x, y, share);
    sheen_shared(share, triangle->color, run->c);
    run->weight = plane_at(&triangle->planes->weight, x, y);
    run->z = plane_at(&s->depth, x, y);
}

void sheen_tinted_rows(const struct tile *t, const struct setup *s)
{
    const struct shares_setup *p = (const struct shares_setup *)s;
    struct tinted_triangle triangle;
    struct tinted_run run;
    int16_t normal[3][3];

    sheen_tinted_begin(&run, &triangle, s, p->of, &p->shares);
    sheen_shared_normals(s, p->of, normal);
    sheen_shared(triangle.step, normal, run.dn);
    for (unsigned row = 0; row < t->rows; row++) {
        const int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        int32_t share[3];
        if (x >= x1)
            continue;
        sheen_tinted_row(&run, &triangle, s, x, y, share);
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
