/*
 * fogged_light.c - light that is quadratic along a run, under fog: on 565, colours are exact at the ends of blocks and
 * linear in between. Two blocks of n px are tried at a time, then shorter ones if their three ends are not in a line.
 */
#include "fogged_light.h"
#include "quadric_rows.h"

/*
 * Limits of bend_of, in 1/2048 level. Up to MOST_BENT each of the two blocks is off by at most 1/16 level. Up to
 * NEARLY_STRAIGHT both are drawn as one, which is off by at most 1/25 level. If light or fog begins or ends within a
 * block, the error is up to 1/4 level.
 */
#define MOST_BENT 1024
#define NEARLY_STRAIGHT 160

/* The most px of a block with a highlight. */
#define LONGEST_SHINY_BLOCK 8

/* Apart, so that it has the registers that it needs. */
HOT static APART void colour_here(struct fogged_colour *c, const struct draw *d, const struct shaded_run *at,
                                  enum second second)
{
    const struct colour_terms *terms = &d->colour;
    const struct fog_terms *fog = d->fog;
    const struct lit lit = lit_of(&d->loop, at->f, at->u, second);
    const int32_t share = fog_share(fog, at->z);
    const unsigned down = terms->fraction - 10u;

    for (int k = 0; k < 3; k++) {
        const int32_t channel = (int32_t)(clamped(colour_channel(terms, k, &lit), terms->top[k]) >> down);
        c->channel[k] = 2 * channel + asr32((fog->level[k] - channel) * share, 13);
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

/* How far the middle one of three colours is off the others' line, times 2, for the channel where that is most. */
static uint32_t bend_of(const struct fogged_colour c[3])
{
    uint32_t most = 0;

    for (int k = 0; k < 3; k++) {
        const uint32_t bend = magnitude32(c[0].channel[k] + c[2].channel[k] - 2 * c[1].channel[k]);
        most = bend > most ? bend : most;
    }
    return most;
}

#define FADES (1 << 27)        /* L.N, Q1.30, below which the highlight fades: 1/8 */
#define NEARLY_FADES (3 << 26) /* 1/16 more: if L.N dips between two ends, it does so by less than that */

/*
 * 1 if light begins or ends between three ends, whose L.N is f, or comes and goes, or goes and comes back, or if a
 * highlight begins to fade: light then has a bend that the three ends may not show.
 */
static int is_edge_of_light(const int32_t f[3], const struct shaded_run *from, const struct shaded_run *to,
                            enum second second)
{
    const int32_t least = min32(f[0], min32(f[1], f[2])), most = max32(f[0], max32(f[1], f[2]));
    const int rises = (int32_t)from->df > 0 && (int32_t)to->df < 0;
    const int sinks = (int32_t)from->df < 0 && (int32_t)to->df > 0;

    if (most <= 0)
        return rises;
    return least <= 0 || (sinks && least < NEARLY_FADES) || (second == SECOND_POWER && least < FADES && most > FADES);
}

static int32_t longest_of(const struct shaded_run *run, enum second second)
{
    const uint32_t bend = magnitude32((int32_t)run->ddu);

    if (second != SECOND_POWER)
        return LONGEST_BLOCK;
    return bend < 1u << 24 ? LONGEST_SHINY_BLOCK : bend < 1u << 26 ? LONGEST_SHINY_BLOCK / 2 : 1;
}

/*
 * Range: a colour may be made one pixel beyond the run's end; if the light there is invalid, the three ends are not in
 * a line, and shorter blocks are tried.
 */
static void draw_blocks(struct fogged_run *r, const struct draw *d, struct shaded_run *at, int32_t left,
                        enum second second)
{
    const int32_t longest = longest_of(at, second);
    struct fogged_colour c[3];
    struct shaded_run end;
    int32_t f[3];
    uint32_t bend;
    int first = 0; /* the first of the three colours that is not known yet */

    for (int32_t n; left > 0; left -= 2 * n) {
        for (n = min32(longest, left >> 1);; n >>= 1) {
            end = *at;
            f[0] = (int32_t)at->f;
            for (int k = first; k < (n > 0 ? 3 : 1); k++) {
                if (k > 0)
                    run_on(&end, (uint32_t)n);
                f[k] = (int32_t)end.f;
                colour_here(&c[k], d, &end, second);
            }
            first = 1;
            bend = n > 0 ? bend_of(c) : 0;
            if (n <= 1 || (bend <= MOST_BENT && !is_edge_of_light(f, at, &end, second)))
                break;
        }
        if (n == 0) {
            sheen_fogged_block(r, at->z, &c[0], &c[0], 1, 0);
            return;
        }
        if (bend <= NEARLY_STRAIGHT) {
            sheen_fogged_block(r, at->z, &c[0], &c[2], n, 1);
        } else {
            sheen_fogged_block(r, at->z, &c[0], &c[1], n, 0);
            sheen_fogged_block(r, at->z + (uint32_t)n * at->dz, &c[1], &c[2], n, 0);
        }
        *at = end;
        c[0] = c[2];
    }
}

HOT void sheen_fogged_shaded_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1,
                                 int32_t y, struct shaded_run *run, unsigned second)
{
    uint16_t *depth = t->depth + at;
    struct fogged_run r = {t, depth, DITHER_ROW(t, depth - x, y), run->dz};

    /* stippled draws have other thresholds than those that packed channels are dithered with */
    if (d->pixel_ramp || !d->fog->is_565 || (t->dither && t->thresholds != sheen_thresholds))
        sheen_fogged_any_run(t, d, at, x, x1, y, run, second);
    else
        draw_blocks(&r, d, run, x1 - x, (enum second)second);
}
