/*
 * fog_rows.c - pixels under fog: unrounded colours are blended with the fog's, by a share that is linear in z16.
 */
#include "fogged_light.h"
#include "normal_rows.h"
#include "packed_rows.h"
#include "quadric_rows.h"
#include "quotient.h"
#include "textured.h"

/* ---- colours that are constant or linear on the screen ---- */

/*
 * Stepped along a run: `left` is the share of the colour that the fog leaves, UQ2.30, `apart` the fog's level minus a
 * channel, with the draw's fraction, read as int32_t. Unsigned, because the step after a run's last pixel may overflow.
 */
struct fog_at {
    uint32_t z, left, apart[3];
};

#if FAST_LOOPS && defined(__ARM_ARCH_6M__) /* it adds any register, but subtracts only low ones */
#define FOG_ADDS 1
#else
#define FOG_ADDS 0
#endif

/*
 * A channel under fog, 24 fraction bits. share: what the fog leaves, UQ2.14; adds: share is negated. Range: |apart| <
 * 2^16 with 10 fraction bits, so the product is below 2^30.
 */
SPECIALISED uint32_t under_fog(uint32_t level, uint32_t apart, int32_t share, unsigned adds)
{
    const uint32_t gone = (uint32_t)(asr32((int32_t)apart, LOOP_FRACTION - 10) * share);

    return adds ? level + gone : level - gone;
}

/* A run on 565 with nothing to clamp. even: it has one colour; adds: as in under_fog. */
SPECIALISED void unclamped_run(const struct tile *t, const struct draw *d, uint16_t *depth, uint32_t x, int32_t count,
                               const uint8_t *threshold, struct fog_at at, struct fog_at step, unsigned swap,
                               unsigned even, unsigned adds)
{
    const intptr_t to_pixel = t->to_pixel;
    const uint16_t *end = depth + count;
    const uint16_t *level = d->fog->level;
    const uint32_t half = threshold == NULL ? 1u << 9 : 0;
    const uint32_t r = (level[0] + half) << 14, g = (level[1] + half) << 14, b = (level[2] + half) << 14;

    if (adds) {
        OPAQUE(step.apart[0]);
        OPAQUE(step.apart[1]);
        OPAQUE(step.apart[2]);
    }
    do {
        if (nearer(t, depth, at.z)) {
            const uint32_t up = threshold == NULL ? 0 : (uint32_t)threshold[x & 7u] << 17;
            const int32_t left = asr32((int32_t)at.left, 16), share = adds ? -left : left;
            *pixel_at(depth, to_pixel) =
                fast_pixel(under_fog(r, at.apart[0], share, adds) + up, under_fog(g, at.apart[1], share, adds) + up,
                           under_fog(b, at.apart[2], share, adds) + up, 24, swap);
        }
        at.z += step.z;
        at.left += step.left;
        if (!even) {
            at.apart[0] += step.apart[0];
            at.apart[1] += step.apart[1];
            at.apart[2] += step.apart[2];
        }
        if (threshold != NULL)
            x++;
    } while (++depth != end);
}

/* 1 if a and b are in 0..most; then what is linear between them is, too. */
static inline int within(uint32_t a, uint32_t b, uint32_t most)
{
    return a <= most && b <= most;
}

#define FOG_MARGIN 4 /* of 2^15: more than the error of 640 steps, 2^-23 each */

static void fog_steps(const struct linear_setup *l, struct fog_at *step)
{
    const struct fog_terms *fog = l->s.draw->fog;

    step->z = l->s.depth.dx;
    const int32_t left = mul_16_32(fog->scale, (int32_t)l->s.depth.dx);
    step->left = fog->shift < 16 ? (uint32_t)left << (16 - fog->shift) : (uint32_t)asr32(left, fog->shift - 16u);
    for (int k = 0; k < 3; k++)
        step->apart[k] = 0u - l->channel[k].dx;
}

/*
 * *at: at (x, y). Returns 1 if neither the fog's share nor a channel has to be clamped there or in `last` px more, and
 * fog_steps is right.
 */
static int fog_run(const struct linear_setup *l, int32_t x, int32_t y, int32_t last, struct fog_at *at)
{
    const struct draw *d = l->s.draw;
    const struct fog_terms *fog = d->fog;
    const uint32_t near = (uint32_t)fog->start - FOG_MARGIN, z = plane_at(&l->s.depth, x, y);
    const uint32_t end = z + (uint32_t)last * l->s.depth.dx;
    int unclamped = d->colour.fraction == LOOP_FRACTION &&
                    within(near - (z >> fog->shift), near - (end >> fog->shift), fog->reach - 2u * FOG_MARGIN);

    /* of two pixels 2^15 steps of z16 or more apart the step's sign is lost, and with it that of the fog's step */
    if (last > 0 && (end > z) != ((int32_t)l->s.depth.dx > 0))
        unclamped = 0;
    at->z = z;
    at->left = (1u << 30) - ((uint32_t)fog->start - (z >> fog->shift)) * fog->scale;
    for (int k = 0; k < 3; k++) {
        const uint32_t channel = plane_at(&l->channel[k], x, y);
        at->apart[k] = ((uint32_t)fog->level[k] << (LOOP_FRACTION - 10)) - channel;
        unclamped &= within(channel, channel + (uint32_t)last * l->channel[k].dx, d->colour.top[k]);
    }
    return unclamped;
}

SPECIALISED void held_row(const struct tile *t, const struct linear_setup *l, int32_t x, int32_t x1, int32_t y)
{
    const struct plane *c = l->channel;
    const uint8_t *threshold = threshold_row(t, t->dither, y);
    uint32_t at = tile_offset(t, x, y), z = plane_at(&l->s.depth, x, y);
    uint32_t r = plane_at(&c[0], x, y), g = plane_at(&c[1], x, y), b = plane_at(&c[2], x, y);

    for (; x < x1; x++, at++, z += l->s.depth.dx, r += c[0].dx, g += c[1].dx, b += c[2].dx)
        if (nearer(t, t->depth + at, z))
            put_fogged_terms(t, l->s.draw, at, z, not_negative(r), not_negative(g), not_negative(b),
                             threshold[(uint32_t)x & 7u], t->format->grey);
}

HOT static void fogged_rows(const struct tile *t, const struct setup *s)
{
    const struct linear_setup *l = (const struct linear_setup *)s;
    struct fog_at at, step;

    fog_steps(l, &step);
    for (unsigned row = 0; row < t->rows; row++) {
        const int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        const uint8_t *threshold = t->dither ? threshold_row(t, 1, y) : NULL;
        if (x >= x1)
            continue;
        if (!fog_run(l, x, y, x1 - 1 - x, &at) || t->format->grey) {
            SHEEN_TAP(FOG_HELD, x1 - x);
            held_row(t, l, x, x1, y);
            continue;
        }
        uint16_t *depth = t->depth + tile_offset(t, x, y);
        if (FAST_LOOPS && threshold == NULL && t->format->swap && s->way == SHEEN_WAY_FLAT)
            unclamped_run(t, s->draw, depth, (uint32_t)x, x1 - x, NULL, at, step, 1, 1, 0);
        else if (FAST_LOOPS && threshold == NULL && t->format->swap)
            unclamped_run(t, s->draw, depth, (uint32_t)x, x1 - x, NULL, at, step, 1, 0, FOG_ADDS);
        else
            unclamped_run(t, s->draw, depth, (uint32_t)x, x1 - x, threshold, at, step, t->format->swap, 0, 0);
    }
}

static void fogged_quotient_rows(const struct tile *t, const struct setup *s)
{
    quotient_rows(t, (const struct quotient_setup *)s, 1);
}

/* ---- intensities, normals ---- */

HOT void sheen_fogged_block(struct fogged_run *r, uint32_t z, const struct fogged_colour *from,
                            const struct fogged_colour *to, int32_t n, unsigned twice)
{
    static const uint16_t part[LONGEST_BLOCK + 1] = {0,    16384, 8192, 5461, 4096, 3277, 2731, 2341, 2048,
                                                     1820, 1638,  1489, 1365, 1260, 1170, 1092, 1024}; /* 2^14 / n */
    const struct tile *t = r->t;
    struct packed_way way = {.to_pixel = t->to_pixel, .dither = t->dither, .swap = t->format->swap};
    const uint32_t half = t->dither ? 0 : 1u << 10; /* of the one rounding */
    const struct packed_at at = {z,
                                 {((uint32_t)from->channel[0] << 16) + (uint32_t)from->channel[2] + half * 0x10001u,
                                  ((uint32_t)from->channel[1] + half) << 15}};
    int32_t step[3];

    for (int k = 0; k < 3; k++)
        step[k] = asr32((to->channel[k] - from->channel[k]) * part[n] + (1 << 13), 14 + twice);
    const struct packed_at by = {r->dz, {((uint32_t)step[0] << 16) + (uint32_t)step[2], (uint32_t)step[1] << 15}};
    n <<= twice;
    if (FAST_LOOPS && way.swap && !way.dither) {
        way.swap = 1;
        way.dither = 0;
        packed_run(t, r->depth, n, at, by, way, NULL);
    } else {
        packed_run(t, r->depth, n, at, by, way, r->thresholds);
    }
    r->depth += n;
}

void sheen_fogged_any_run(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                          struct shaded_run *run, unsigned second)
{
    general_loop(t, d, at, x, x1, y, run, (enum second)second, d->pixel_ramp, 1);
}

void sheen_fogged_normal_run(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                             const struct normal_run *run)
{
    if (d->pixel_ramp)
        normal_loop(t, d, x, x1, y, run, 1, 1);
    else
        normal_loop(t, d, x, x1, y, run, 0, 1);
}

/* ---- lines ---- */

/* Levels of a pixel as stored in a tile, with 16 - level_bits fraction bits. */
static void levels_of(uint16_t level[3], const struct pixel_format *format, uint32_t pixel)
{
    const unsigned fraction = 16u - format->level_bits;
    const uint32_t rgb = pixel_order(pixel, format->swap);

    level[0] = (uint16_t)((format->grey ? pixel : rgb >> 11) << fraction);
    level[1] = (uint16_t)((rgb >> 5 & 63u) << fraction);
    level[2] = (uint16_t)((rgb & 31u) << fraction);
}

static int32_t fogged_line_run(const struct fog_terms *fog, const struct pixel_format *format, int32_t z,
                               int32_t z_step, int32_t steps, uint16_t *pixel)
{
    const unsigned fraction = 16u - format->level_bits;
    const uint32_t half = 1u << (fraction - 1);
    uint16_t level[3];
    int32_t run = 0, last = -1;

    levels_of(level, format, *pixel);
    for (uint32_t first = 0; run < steps; run++, z += z_step) {
        const int32_t share = fog_share(fog, (uint32_t)z << 8);
        if (share == last)
            continue;
        const uint32_t r = fogged(level[0], fog->level[0], share) + half;
        const uint32_t value = format->grey
                                   ? r >> fraction
                                   : fast_pixel(r, fogged(level[1], fog->level[1], share) + half,
                                                fogged(level[2], fog->level[2], share) + half, 10, format->swap);
        if (run != 0 && value != first)
            break;
        first = value;
        last = share;
        *pixel = (uint16_t)value;
    }
    return run;
}

/* ---- the mixers ---- */

static COLD int fog_begin(struct fog_terms *terms, const struct sheen_fog *fog, const struct projection *p,
                          const struct pixel_format *format)
{
    if (fog->start <= 0 || fog->end <= fog->start)
        return SHEEN_ERR_ARGUMENT;
    /*
     * With perspective a start before 2^-14 of near is moved there, which makes a difference of less than 2^-14, and an
     * end before 2^-13 of near there, which makes none: all that is drawn is behind it.
     */
    const sheen_q24_t least = p->orthographic != 0 ? 1 : max32(p->near >> 14, 1);
    const int64_t start = sheen_depth_beyond(p, max32(fog->start, least));
    const int64_t reach = start - sheen_depth_beyond(p, max32(fog->end, 2 * least));
    if (reach < (int64_t)256 << 16)
        return SHEEN_ERR_ARGUMENT;
    const unsigned shift = 48 - clz64((uint64_t)reach);
    const int64_t from = asr64(start, shift), most = 1 << 30;
    terms->mixer = fog->mixer;
    terms->is_565 = !format->grey;
    terms->shift = (uint8_t)min32((int32_t)shift, 31); /* from there on z makes no difference */
    terms->start = (int32_t)(from > most ? most : from < -most ? -most : from);
    terms->reach = (uint16_t)asr64(reach, shift);
    terms->scale = (uint16_t)((sheen_reciprocal((uint32_t)terms->reach << 16) >> 17) + 1);
    levels_of(terms->level, format, sheen_colour_pixel(format, fog->color));
    return SHEEN_OK;
}

static void fog_draw(struct draw *d, const struct fog_terms *terms)
{
    take_general_loops(d);
    d->loop.usable = 0;
    d->fog = terms;
}

static void line_fog_draw(struct draw *d, const struct fog_terms *terms)
{
    (void)d;
    (void)terms;
}

static void fog_setup(struct setup *s)
{
    if (s->way >= SHEEN_WAY_TEXTURED_LINEAR && s->special_loop != TEXTURED_ANY)
        s->special_loop = TEXTURED_FOGGED;
    else if (s->way == SHEEN_WAY_FLAT || s->way == SHEEN_WAY_GOURAUD_LINEAR)
        s->rows = fogged_rows;
    else if (s->way == SHEEN_WAY_GOURAUD_QUOTIENT)
        s->rows = fogged_quotient_rows;
}

const struct sheen_fog_mixer sheen_fog_mixer = {.begin = fog_begin,
                                                .draw = fog_draw,
                                                .setup = fog_setup,
                                                .shaded_run = sheen_fogged_shaded_run,
                                                .normal_run = sheen_fogged_normal_run,
                                                .texel_run = sheen_fogged_texel_run,
                                                .line_run = fogged_line_run};

/* Fog on lines alone: line_fog_draw leaves draws without fog, so the other functions are never called. */
const struct sheen_fog_mixer sheen_line_fog_mixer = {
    .begin = fog_begin, .draw = line_fog_draw, .line_run = fogged_line_run};
