/*
 * colored_texels.c - rows of coloured texels, drawn in parts: exact at a part's ends and middle, linear in between.
 */
#include "colored_texels.h"
#include "../math/inverse.h"

/* Range: differences are below 2^31, and shares sum to 1.0. */
void sheen_mix_corners(struct at_corners *at, const struct shares_setup *s)
{
    const int32_t first = at->f[0], d1 = at->f[1] - first, d2 = at->f[2] - first;

    for (int k = 0; k < 3 && (s->s.detail & SHARES_PIECE) != 0; k++) {
        const int16_t *share = s->of.piece[k];
        at->f[k] = first + sheen_mul_round(d1, share[0] + (share[0] >> 14), 15) +
                   sheen_mul_round(d2, share[1] + (share[1] >> 14), 15);
    }
}

/*
 * Added to channels so that the rounding of quotients, and of steps along a part, cannot take a channel below 0;
 * 24 / 2^24 level, times 31 or 63 at most, does not show.
 */
#define CHANNEL_BIAS 24

/*
 * Channels at corner k, with the draw's fraction: the light divided by the levels of a full texel, 31 or 63, and the
 * highlight. color: the vertex's; NULL: white. Returns 0 if there is no highlight.
 */
HOT static APART uint32_t color_corner(struct texel_corners *c, uint32_t k, const struct glow *glow,
                                       const uint8_t *color)
{
    static const uint32_t one_level[3] = {0x08421085u, 0x04104105u, 0x08421085u}; /* 2^32 / 31, 63 */

    for (int i = 0; i < 3; i++) {
        const uint32_t base = color != NULL ? by_colour(glow->base[i], color[i]) : glow->base[i];
        c->channel[i].f[k] = (int32_t)(mul_high(base, one_level[i]) + CHANNEL_BIAS);
        c->channel[3 + i].f[k] = (int32_t)(glow->highlight[i] + CHANNEL_BIAS);
    }
    return glow->highlight[0] | glow->highlight[1] | glow->highlight[2];
}

void sheen_color_corners(struct texel_corners *c, const struct shares_setup *s, const struct glow glow[3])
{
    const struct draw *d = s->s.draw;
    const uint32_t triangle = shared_triangle_of(&s->s, s->of);
    const uint8_t *colors = d->mesh->colors;
    uint32_t some = d->colour.clamp;

    for (uint32_t k = 0; k < 3; k++)
        some |=
            color_corner(c, k, &glow[k], colors != NULL ? colors + 3 * mesh_index(d->mesh, 3 * triangle + k) : NULL);
    c->channels = some != 0 ? 6 : 3;
    for (unsigned i = 0; i < c->channels; i++)
        sheen_mix_corners(&c->channel[i], s);
}

/* What a triangle's rows are drawn with. */
struct texel_rows {
    const struct shares_setup *s;
    const struct texel_corners *c;
    struct colored_run run;
};

/*
 * The perspective-correct shares of corners 1 and 2 at pixel (x, y), Q3.28 (lecture, "Fixing Distortion"). Rounding may
 * take a weight below 0 where 1/m is less than 2^-20 of the triangle's largest, and on a needle above 1.0; it counts as
 * 1.0 then. Near such a corner shares are of any size.
 */
static inline void corner_shares(const struct shares *p, int32_t x, int32_t y, int32_t share[2])
{
    const uint32_t weight = plane_at(&p->weight, x, y) | 1u;
    const struct inverse i = inverse_of(weight >> 30 == 0 ? weight : (1u << 30) - 1);

    for (int j = 0; j < 2; j++) /* a weight is below 1.0: i.up >= 2 */
        share[j] = over(i, (int32_t)(plane_at(&p->part[j], x, y) << (i.up - 2)));
}

/* A channel, linear in space. share: UQ1.15. */
static inline uint32_t channel_between(const struct at_corners *f, const int32_t share[2])
{
    return (uint32_t)f->f[0] +
           2u * (uint32_t)(mul_16_32(share[0], f->f[1] - f->f[0]) + mul_16_32(share[1], f->f[2] - f->f[0]));
}

/* The same for a texel coordinate, modulo 2^32. share: Q3.28. Range: differences <= 2^29. */
static inline uint32_t texels_between(const struct at_corners *f, const int32_t share[2])
{
    const int32_t first = (int32_t)((uint32_t)share[0] * 4u), second = (int32_t)((uint32_t)share[1] * 4u);

    return (uint32_t)f->f[0] + 4u * ((uint32_t)PRODUCT_FORM(high)(first, f->f[1] - f->f[0]) +
                                     (uint32_t)PRODUCT_FORM(high)(second, f->f[2] - f->f[0]));
}

/* The exact values at pixel (x, y) of the triangle. */
HOT static APART void texel_values_at(const struct texel_rows *r, int32_t x, int32_t y, uint32_t value[TEXEL_VALUES])
{
    const struct texel_corners *c = r->c;
    int32_t fine[2], share[2];
    uint32_t n[3];

    SHEEN_TAP(COLORED_END, 1);
    corner_shares(&r->s->shares, x, y, fine);
    for (int j = 0; j < 2; j++)
        share[j] = max32(0, min32(asr32(fine[j] + (1 << 12), 13), 32768));
    for (unsigned i = 0; i < c->channels; i++)
        value[2 + i] = channel_between(&c->channel[i], share);
    if (c->texel_of == NULL) {
        value[0] = texels_between(&c->place[0], fine);
        value[1] = texels_between(&c->place[1], fine);
        return;
    }
    for (int i = 0; i < 3; i++) {
        const int32_t *f = c->place[i].f;
        n[i] = (uint32_t)(f[0] * 32768) + (uint32_t)(share[0] * (f[1] - f[0])) + (uint32_t)(share[1] * (f[2] - f[0]));
    }
    c->texel_of(r->s->s.draw->tint.texture, n, value);
}

#define LONGEST_PART 32 /* px; a quarter for normals: they may bend both ways, which a part's middle may not show */

/* (to - from) / count, count 1..LONGEST_PART. */
static uint32_t part_step(uint32_t from, uint32_t to, int32_t count)
{
    static const uint16_t part[LONGEST_PART + 1] = {0,    0,    32768, 21845, 16384, 13107, 10923, 9362, 8192,
                                                    7282, 6554, 5958,  5461,  5041,  4681,  4369,  4096, 3855,
                                                    3641, 3449, 3277,  3121,  2979,  2849,  2731,  2621, 2521,
                                                    2427, 2341, 2260,  2185,  2114,  2048}; /* 2^16 / count */
    const int32_t difference = (int32_t)(to - from);

    return (uint32_t)(count == 1 ? difference : mul_16_32(part[count], difference));
}

/*
 * 1 if linear interpolation between a part's ends is off in its middle by more than 1/8 texel (1/32 for normals) or by
 * more than 1/8 of a 64th of 1.0. Over each half by itself the error is a quarter of that.
 */
static int bends(const struct texel_rows *r, const uint32_t from[], const uint32_t middle[], const uint32_t end[],
                 int32_t half, int32_t count)
{
    const uint32_t eighth = 1u << (r->s->s.draw->colour.unit_log2 - 3),
                   texel = r->c->texel_of != NULL ? 1u << 11 : 1u << 13;

    for (unsigned i = 0; i < r->run.values; i++) {
        const uint32_t linear = from[i] + (uint32_t)half * part_step(from[i], end[i], count);
        if (magnitude32((int32_t)(middle[i] - linear)) > (i < 2 ? texel : i < 5 ? eighth >> 6 : eighth))
            return 1;
    }
    return 0;
}

/* Draws `count` pixels, up to the one before `end`; `from` is overwritten. */
HOT static void put_part(struct texel_rows *r, uint32_t from[], const uint32_t end[], int32_t count)
{
    struct colored_run *run = &r->run;
    uint32_t step[TEXEL_VALUES];

    for (unsigned i = 0; i < run->values; i++)
        step[i] = part_step(from[i], end[i], count);
    run->count = count;
    run->from = from;
    run->step = step;
    sheen_colored_run(run);
    run->offset += (uint32_t)count;
    run->x += count;
    run->z += (uint32_t)count * run->dz;
}

/* The row's last part ends at its last pixel, because beyond the triangle weights may be invalid. */
HOT static APART void colored_row(struct texel_rows *r, int32_t left)
{
    uint32_t value[3][TEXEL_VALUES], *from = value[0], *middle = value[1], *end = value[2];
    const int32_t y = r->run.y, longest = r->c->texel_of != NULL ? LONGEST_PART / 4 : LONGEST_PART;

    texel_values_at(r, r->run.x, y, from);
    while (left > 1) {
        const int32_t x = r->run.x;
        int32_t to = min32(left - 1, longest), half;
        uint32_t *spare = from;
        texel_values_at(r, x + to, y, end);
        for (half = to / 2; half > 0; half = to / 2) {
            texel_values_at(r, x + half, y, middle);
            if (!bends(r, from, middle, end, half, to))
                break;
            uint32_t *beyond = end;
            end = middle;
            middle = beyond;
            to = half;
        }
        if (half > 0) {
            put_part(r, from, middle, half);
            put_part(r, middle, end, to - half);
        } else {
            put_part(r, from, end, to);
        }
        from = end;
        end = spare;
        left -= to;
    }
    put_part(r, from, from, 1);
}

HOT void sheen_colored_texels(const struct tile *t, const struct setup *s, const struct texel_corners *c)
{
    const struct sheen_texture *texture = s->draw->tint.texture;
    const int repeats = c->texel_of != NULL || (texture->clamp_u | texture->clamp_v) == 0;
    struct texel_rows r = {(const struct shares_setup *)s, c, {.t = t, .d = s->draw, .values = 2 + c->channels}};

    r.run.plain = !t->format->grey && s->draw->fog == NULL && s->draw->colour.fraction == LOOP_FRACTION &&
                  (texture->bits & 15) == 0 && !texture->keyed && !texture->bilinear && repeats;

    r.run.dz = s->depth.dx;
    for (unsigned row = 0; row < t->rows; row++) {
        const int32_t x = t->spans[row].x0, y = t->first_row + (int32_t)row, left = t->spans[row].x1 - x;
        if (left <= 0)
            continue;
        r.run.x = x;
        r.run.y = y;
        r.run.offset = tile_offset(t, x, y);
        r.run.z = plane_at(&s->depth, x, y);
        colored_row(&r, left);
    }
}
