/*
 * tinted_rows.c - pixels that have a normal and a colour each: a root and a reciprocal, and each light is a dot product
 * and six products.
 */
#include "normal_rows.h"
#include "quotient.h"
#include "tinted.h"

/* By channel, UQ2.30: weights sum to 1.0. */
struct tinted_sums {
    uint32_t diffuse[3], specular[3];
};

static void add_light(struct tinted_sums *sum, const struct draw *d, const struct tinted_lights *lights,
                      const struct pixel_normal *p, unsigned i, int32_t facing)
{
    const struct lighting *l = &d->light;
    const int32_t ln = unit_dot_at(p, l->to[i]), rounded = rounded_cosine(ln);
    const uint32_t response = l->ramp != NULL ? response_at(l->ramp, rounded) : (uint32_t)max32(rounded, 0);

    const uint32_t diffuse = (l->diffuse_weight[i] * response + HALF) >> 15;
    const uint32_t specular = ln > 0 ? (l->specular_weight[i] * pixel_highlight(d, i, ln, facing) + HALF) >> 15 : 0;

    for (int k = 0; k < 3; k++) {
        sum->diffuse[k] += lights->color[i][k] * diffuse;
        sum->specular[k] += lights->color[i][k] * specular;
    }
}

/* Channels with the draw's fraction. color: UQ1.15. Range: what it multiplies is below 2^31. */
static void light_tinted(const struct draw *d, const struct tinted_run *run, const uint32_t normal[3],
                         const int32_t color[3], uint32_t channel[3])
{
    struct tinted_sums sum = {{0, 0, 0}, {0, 0, 0}};
    struct pixel_normal p;

    if (pixel_normal(normal, &p)) {
        const int32_t facing = unit_dot_at(&p, d->light.view);
        for (unsigned i = 0; i < d->light.count; i++)
            add_light(&sum, d, &run->lights, &p, i, facing);
    }
    for (int k = 0; k < 3; k++) {
        const uint32_t base = run->lights.ambient[k] + d->colour.b[k] * ((sum.diffuse[k] + HALF) >> 15);
        channel[k] =
            2u * (uint32_t)mul_16_32(color[k], (int32_t)base) + d->colour.c[k] * ((sum.specular[k] + HALF) >> 15);
    }
}

void sheen_tinted_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                      const struct tinted_run *run)
{
    const struct rounding rounding = rounding_of(t, &d->colour, y);
    uint32_t at = tile_offset(t, x, y), z = run->z, weight = run->weight, n[3], c[3];

    for (int k = 0; k < 3; k++) {
        n[k] = run->n[k];
        c[k] = run->c[k];
    }
    for (; x < x1; x++, at++, z += run->dz, weight += run->dweight) {
        if (nearer(t, t->depth + at, z)) {
            uint32_t w = weight << 2, channel[3];
            const unsigned up = weight_up(&w);
            const uint32_t one_over = reciprocal_seed(w);
            int32_t color[3];
            for (int k = 0; k < 3; k++)
                color[k] = min32((int32_t)((quotient(c[k], up, one_over) + HALF) >> 15), 32768);
            light_tinted(d, run, n, color, channel);
            if (d->fog != NULL)
                put_fogged_terms(t, d, at, z, channel[0], channel[1], channel[2], rounding.threshold[(uint32_t)x & 7u],
                                 t->format->grey);
            else
                put_general(t, &d->colour, rounding, at, x, channel[0], channel[1], channel[2]);
        }
        for (int k = 0; k < 3; k++) {
            n[k] += run->dn[k];
            c[k] += run->dc[k];
        }
    }
}
