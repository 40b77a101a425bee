/*
 * fogged_rows.c - light that is quadratic along a run, under fog: on 565 colours are exact at the ends of blocks and
 * linear between. Two blocks of n px are tried at a time; where the three ends are not in a line, shorter ones.
 */
#include "packed_rows.h"
#include "quadric_rows.h"

#define MOST_BENT 1024 /* 1/4 level in 1/2048: a block is off by 1/32, by 1/8 where light or fog ends in it */

/* px, at the most, of a block; in highlights: no block steps over one. Divides what channels change by. */
#define LONGEST 16
#define LONGEST_SHINY 8

/* A run on its way. */
struct fogged_run {
    const struct tile *t;
    const struct draw *d;
    uint16_t *depth;
    const threshold_t *thresholds; /* of the row */
    enum second second;
    uint32_t half; /* of the one rounding, where nothing dithers */
};

/* Levels in 1/2048. */
struct fogged_colour {
    int32_t channel[3];
};

static APART void colour_here(struct fogged_colour *c, const struct fogged_run *r, const struct shaded_run *at)
{
    const struct colour_terms *terms = &r->d->colour;
    const struct fog_terms *fog = r->d->fog;
    const struct lit lit = lit_of(&r->d->loop, at->f, at->u, r->second);
    const int32_t share = fog_share(fog, at->z);
    const unsigned down = terms->fraction - 10u;

    for (int k = 0; k < 3; k++) {
        const int32_t channel = (int32_t)(clamped(colour_channel(terms, k, &lit), terms->top[k]) >> down);
        c->channel[k] = 2 * channel + asr32((fog->level[k] - channel) * share, 13) + (int32_t)r->half;
    }
}

static void run_on(struct shaded_run *at, uint32_t n)
{
    const uint32_t pair = n * (n - 1) / 2;

    at->z += n * at->dz;
    at->f += n * at->df + pair * at->ddf;
    at->df += n * at->ddf;
    at->u += n * at->du + pair * at->ddu;
    at->du += n * at->ddu;
}

static int is_bent(const struct fogged_colour c[3])
{
    for (int k = 0; k < 3; k++)
        if (magnitude32(c[0].channel[k] + c[2].channel[k] - 2 * c[1].channel[k]) > MOST_BENT)
            return 1;
    return 0;
}

static int32_t longest_of(const struct shaded_run *run, enum second second)
{
    const uint32_t bend = magnitude32((int32_t)run->ddu);

    if (second != SECOND_POWER)
        return LONGEST;
    return bend < 1u << 24 ? LONGEST_SHINY : bend < 1u << 26 ? LONGEST_SHINY / 2 : 1;
}

/* n px from the first colour on to before the second. */
static void draw_block(struct fogged_run *r, const struct shaded_run *at, const struct fogged_colour *c, int32_t n)
{
    static const uint16_t part[LONGEST + 1] = {0, 16384, 8192, 5461, 4096, 3277, 2731, 2341, 2048, 1820, 1638, 1489, 1365, 1260, 1170, 1092, 1024};
    const struct tile *t = r->t;
    struct packed_way way = {.to_pixel = t->to_pixel, .dither = t->dither, .swap = t->format->swap};
    int32_t step[3];

    for (int k = 0; k < 3; k++)
        step[k] = asr32((c[1].channel[k] - c[0].channel[k]) * part[n] + (1 << 13), 14);
    const struct packed_at from = {at->z, {((uint32_t)c->channel[0] << 16) + (uint32_t)c->channel[2],
                                           (uint32_t)c->channel[1] << 15}};
    const struct packed_at by = {at->dz, {((uint32_t)step[0] << 16) + (uint32_t)step[2], (uint32_t)step[1] << 15}};
    if (FAST_LOOPS && way.swap && !way.dither) {
        way.swap = 1;
        way.dither = 0;
        packed_run(t, r->depth, n, from, by, way, NULL);
    } else {
        packed_run(t, r->depth, n, from, by, way, r->thresholds);
    }
    r->depth += n;
}

/* Range: a run may be looked at one pixel beyond its end; what has no colour there is no line. */
static void draw_blocks(struct fogged_run *r, struct shaded_run *at, int32_t left)
{
    const int32_t longest = longest_of(at, r->second);
    struct fogged_colour c[3];

    colour_here(&c[0], r, at);
    for (int32_t n; left > 0; left -= n) {
        struct shaded_run end;
        for (n = min32(longest, left >> 1); n > 1; n >>= 1) {
            end = *at;
            run_on(&end, (uint32_t)n);
            colour_here(&c[1], r, &end);
            run_on(&end, (uint32_t)n);
            colour_here(&c[2], r, &end);
            if (!is_bent(c))
                break;
        }
        if (n > 1) {
            draw_block(r, at, &c[0], n);
            run_on(at, (uint32_t)n);
            draw_block(r, at, &c[1], n);
            *at = end;
            c[0] = c[2];
            n *= 2;
            continue;
        }
        n = 1;
        c[1] = c[0];
        draw_block(r, at, &c[0], 1);
        run_on(at, 1);
        if (left > 1)
            colour_here(&c[0], r, at);
    }
}

void sheen_fogged_shaded_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                             struct shaded_run *run, unsigned second)
{
    struct fogged_run r = {t, d, t->depth + at, t->dither_rows[y & 7], (enum second)second, t->dither ? 0 : 1u << 10};

    /* stippled, thresholds are others than packed channels take */
    if (d->by_ramp || !d->fog->is_565 || (t->dither && t->thresholds != sheen_thresholds))
        general_loop(t, d, at, x, x1, y, run, (enum second)second, d->by_ramp, 1);
    else
        draw_blocks(&r, run, x1 - x);
}
