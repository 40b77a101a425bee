/*
 * fogged_light.c - light that is quadratic along a run, under fog: on 565 colours are exact at the ends of blocks and
 * linear between. Two blocks of n px are tried at a time; where the three ends are not in a line, shorter ones.
 */
#include "packed_rows.h"
#include "quadric_rows.h"

/*
 * What the middle of three ends may be off the others' line, 1/2048 level: each block is off by 1/16 level then; both
 * drawn as one, by 1/25. Where light or fog begins or ends within a block it is up to 1/4.
 */
#define MOST_BENT 1024
#define NEARLY_STRAIGHT 160

/* px, at the most, of a block; in highlights. */
#define LONGEST 16
#define LONGEST_SHINY 8

/* A run on its way. */
struct fogged_run {
    const struct tile *t;
    const struct draw *d;
    uint16_t *depth;
    const threshold_t *thresholds; /* of the row */
    enum second second;
    uint32_t dz;
    uint32_t half; /* of the one rounding, where nothing dithers */
};

/* Levels in 1/2048. */
struct fogged_colour {
    int32_t channel[3];
};

static void colour_here(struct fogged_colour *c, const struct fogged_run *r, const struct shaded_run *at)
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

/* Of three colours, what the middle one is off, of the channel where that is most. */
static uint32_t bend_of(const struct fogged_colour c[3])
{
    uint32_t most = 0;

    for (int k = 0; k < 3; k++) {
        const uint32_t bend = magnitude32(c[0].channel[k] + c[2].channel[k] - 2 * c[1].channel[k]);
        most = bend > most ? bend : most;
    }
    return most;
}

static int32_t longest_of(const struct shaded_run *run, enum second second)
{
    const uint32_t bend = magnitude32((int32_t)run->ddu);

    if (second != SECOND_POWER)
        return LONGEST;
    return bend < 1u << 24 ? LONGEST_SHINY : bend < 1u << 26 ? LONGEST_SHINY / 2 : 1;
}

/* From a colour to before another, n px, and `twice` 1: 2 n. */
static void draw_block(struct fogged_run *r, uint32_t z, const struct fogged_colour *from,
                       const struct fogged_colour *to, int32_t n, unsigned twice)
{
    static const uint16_t part[LONGEST + 1] = {0,    16384, 8192, 5461, 4096, 3277, 2731, 2341, 2048,
                                               1820, 1638,  1489, 1365, 1260, 1170, 1092, 1024}; /* 2^14 / n */
    const struct packed_at at = {
        z, {((uint32_t)from->channel[0] << 16) + (uint32_t)from->channel[2], (uint32_t)from->channel[1] << 15}};
    int32_t step[3];

    for (int k = 0; k < 3; k++)
        step[k] = asr32((to->channel[k] - from->channel[k]) * part[n] + (1 << 13), 14 + twice);
    const struct packed_at by = {r->dz, {((uint32_t)step[0] << 16) + (uint32_t)step[2], (uint32_t)step[1] << 15}};
    sheen_fogged_block(r->t, r->depth, n << twice, &at, &by, r->thresholds);
    r->depth += n << twice;
}

/* Range: a run may be looked at one pixel beyond its end; what has no colour there is no line. */
static void draw_blocks(struct fogged_run *r, struct shaded_run *at, int32_t left)
{
    const int32_t longest = longest_of(at, r->second);
    struct fogged_colour c[3];
    struct shaded_run end;
    uint32_t bend;
    int first = 0; /* of the colours that are not known yet */

    for (int32_t n; left > 0; left -= 2 * n) {
        for (n = min32(longest, left >> 1);; n >>= 1) {
            end = *at;
            for (int k = first; k < (n > 0 ? 3 : 1); k++) {
                if (k > 0)
                    run_on(&end, (uint32_t)n);
                colour_here(&c[k], r, &end);
            }
            first = 1;
            bend = n > 0 ? bend_of(c) : 0;
            if (n <= 1 || bend <= MOST_BENT)
                break;
        }
        if (n == 0) {
            draw_block(r, at->z, &c[0], &c[0], 1, 0);
            return;
        }
        if (bend <= NEARLY_STRAIGHT) {
            draw_block(r, at->z, &c[0], &c[2], n, 1);
        } else {
            draw_block(r, at->z, &c[0], &c[1], n, 0);
            draw_block(r, at->z + (uint32_t)n * at->dz, &c[1], &c[2], n, 0);
        }
        *at = end;
        c[0] = c[2];
    }
}

void sheen_fogged_light_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t count, int32_t y,
                            struct shaded_run *run, unsigned second)
{
    struct fogged_run r = {
        t, d, t->depth + at, t->dither_rows[y & 7], (enum second)second, run->dz, t->dither ? 0 : 1u << 10};

    draw_blocks(&r, run, count);
}
