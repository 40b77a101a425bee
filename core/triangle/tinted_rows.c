/*
 * tinted_rows.c - pixels that have a normal and a colour each: a root and a reciprocal per pixel, and per light a dot
 * product and, in its highlight, six products.
 */
#include "normal_rows.h"
#include "quotient.h"
#include "tinted.h"

/* color: UQ1.15. */
static struct channels light_tinted(const struct draw *d, const struct tinted_run *run, const uint32_t normal[3],
                                    const uint32_t color[3])
{
    const struct lighting *l = &d->light;
    struct channels c = ambient_channels(d), gloss = {0, 0, 0};
    const struct tinted_beam *beam = run->beam;
    struct pixel_normal p;

    if (pixel_normal(normal, &p)) {
        const int32_t facing = unit_dot_at(&p, l->view);
        for (unsigned i = 0; i < l->count; i++, beam++) {
            const int32_t ln = unit_dot_at(&p, l->to[i]), rounded = rounded_cosine(ln);
            add_light(&c, beam->base, l->ramp != NULL ? response_at(l->ramp, rounded) : (uint32_t)max32(rounded, 0));
            if (ln > 0)
                add_light(&gloss, beam->gloss, pixel_highlight(d, i, ln, facing));
        }
    }
    return (struct channels){times_colour(c.r, color[0]) + gloss.r, times_colour(c.g, color[1]) + gloss.g,
                             times_colour(c.b, color[2]) + gloss.b};
}

HOT void sheen_tinted_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
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
            uint32_t w = weight << 2, color[3];
            const unsigned up = weight_up(&w);
            const uint32_t one_over = reciprocal_seed(w);
            for (int k = 0; k < 3; k++)
                color[k] = clamped((quotient(c[k], up, one_over) + HALF) >> 15, 32768);
            put_tinted(t, d, rounding, at, x, z, light_tinted(d, run, n, color));
        }
        for (int k = 0; k < 3; k++) {
            n[k] += run->dn[k];
            c[k] += run->dc[k];
        }
    }
}
