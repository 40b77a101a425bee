/*
 * pixel.h - private: what a pixel is made of, a band's tile of them, and the depth test.
 */
#ifndef SHEEN_PIXEL_H
#define SHEEN_PIXEL_H

#include <stddef.h>

#include "../math/fixed.h"
#include "../math/newton.h"
#include "../sheen.h"

/* 1: count pixels, which costs time; pictures are the same. */
#ifndef SHEEN_STATS
#define SHEEN_STATS 0
#endif

/* 1: specialised loops for 565. Builds for size use only the general loops, which give the same pixels. */
#ifndef FAST_LOOPS
#ifdef __OPTIMIZE_SIZE__
#define FAST_LOOPS 0
#else
#define FAST_LOOPS 1
#endif
#endif

/*
 * Taps for a build that counts what its frames consist of: SHEEN_TAPS names the header that defines them
 * (host-sim/plan/taps.h). Without it SHEEN_TAP_ROWS just draws a set-up's rows in a tile, and the others do nothing.
 */
#ifdef SHEEN_TAPS
#include SHEEN_TAPS
#else
#define SHEEN_TAP(what, count) ((void)0)
#define SHEEN_TAP_SETUP(corners, gradients) ((void)0)
#define SHEEN_TAP_ROWS(tile, setup) (setup)->rows(tile, setup)
#endif

/* Intensities relative to the most that the draw's lights can give. */
struct lit {
    uint32_t diffuse, specular; /* UQ1.15, 0..32768; up to 65535 where rows step beyond a triangle */
};

/*
 * A material's power table, ready for a loop. Its argument is u = 1 - s, scaled so that 2^30 is the table's end, plus
 * one entry (POWER_GUARD): a u that rounding takes below 0 still finds a copy of the first entry.
 */
struct power {
    const uint32_t *table;
    uint32_t limit;    /* u in Q2.29 from which on there is no highlight; 0: no highlight at all */
    uint8_t up;        /* 1..4: the argument is u in Q2.29 << up, + POWER_GUARD */
    uint8_t shininess; /* n */
    uint16_t faint;    /* u in Q2.13 from which on the highlight gives at most 1/32 level; not beyond `limit` */
};

#define POWER_STEP 22 /* 2^22 of the argument is one entry */
#define POWER_GUARD (1u << POWER_STEP)

static inline struct power power_of(const struct sheen_shine *shine)
{
    const unsigned shift = shine != NULL ? shine->shift : 0;

    return (struct power){.table = shine != NULL ? shine->power : NULL,
                          .limit = shine != NULL ? 1u << (29u - shift) : 0,
                          .up = (uint8_t)(1u + shift),
                          .shininess = shine != NULL ? shine->shininess : 1};
}

/* s^n, UQ1.15; `at`: the argument, before the table's end. Range: drop < 2^15, so the product fits 32 bits. */
static inline uint32_t power_entry(const uint32_t *table, uint32_t at)
{
    uint32_t entry = table[at >> POWER_STEP], drop = entry & 0xffffu;

    return (entry - drop * (at >> (POWER_STEP - 16) & 0xffffu)) >> 16;
}

/* s^n for u = 1 - s in Q2.29, u any int32: UQ1.15. */
static inline uint32_t power_at(struct power p, int32_t u)
{
    uint32_t at = (uint32_t)max32(u, 0);

    SHEEN_TAP(POWER, at < p.limit);
    return at < p.limit ? power_entry(p.table, (at << p.up) + POWER_GUARD) : 0;
}

#define FADED (1 << 12) /* UQ1.15: from L.N = 1/8 on a highlight has its full strength */

/*
 * A light's highlight at L.N = ln > 0, UQ1.15: s^n times min(1, 8 L.N), so that it ends at L.N = 0 without a jump.
 * Range: 2^15 * 2^12.
 */
static inline uint32_t faded(uint32_t power, uint32_t ln)
{
    return ln < FADED ? (power * ln + FADED / 2) >> 12 : power;
}

static inline uint32_t highlight_at(struct power p, int32_t u, uint32_t ln)
{
    return faded(power_at(p, u), ln);
}

/* ---- a material's ramp ---- */

struct lighting;
struct tile;
struct draw;
struct normal_run;
struct shaded_run;

/* The code that reads ramps. Ramps point to it, so programs without ramps do not link it. */
struct sheen_ramp_reader {
    /*
     * Once per draw: makes *by from *m, with the ambient and diffuse light that result from low and span, at most 20.0
     * and 4.0. Returns by.
     */
    const struct sheen_material *(*begin)(struct draw *d, const struct sheen_material *m, struct sheen_material *by,
                                          int at_pixels);
    /* Replaces sheen_light_plainly; a normal of length zero gets no light. */
    void (*light)(const struct lighting *l, const struct power *power, const int16_t normal[3], struct lit *out);
    /* Replace sheen_normal_run and the loops of sheen_shaded_run; there f is L.N. */
    void (*normal_run)(const struct tile *t, const struct draw *d, int32_t x, int32_t x1, int32_t y,
                       const struct normal_run *run);
    void (*shaded_run)(const struct tile *t, const struct draw *d, uint32_t at, int32_t x, int32_t x1, int32_t y,
                       struct shaded_run *run, unsigned second);
};

/* A ramp's response at L.N = ln, Q0.15, clamped to +-1.0: UQ1.15 of the ramp's span. Range: 2^16 * 2^8. */
static inline uint32_t response_at(const struct sheen_ramp *ramp, int32_t ln)
{
    const uint32_t at = (uint32_t)(min32(max32(ln, -32768), 32767) + 32768);
    const uint16_t *value = ramp->value + (at >> 8);

    return (uint32_t)(value[0] * 256 + (value[1] - value[0]) * (int32_t)(at & 255u) + 128) >> 8;
}

/* s^n by repeated squaring, UQ0.32, with 1.0 as 0xffffffff; off by less than n * 2^-32. */
uint32_t sheen_raised(uint32_t s, unsigned n);

/* ---- colour: intensities -> channels of the target ---- */

/*
 * A target's pixel format. On 565 the channels are red, green and blue in levels; on grey they are the contributions of
 * red, green and blue to the level.
 */
struct pixel_format {
    uint32_t scale[3];  /* the level for 1.0 of red, green, blue, UQ8.16 */
    uint8_t level_bits; /* bits of the highest level: 6, 8, 4 or 1 */
    uint8_t grey;       /* 1: grey; a byte per pixel while drawing, packed before the push */
    uint8_t pixel_bits; /* in the target's memory */
    uint8_t swap;       /* 1: this machine and the target have different byte orders of 565 */
};

/*
 * A channel before rounding is a + b * diffuse + c * specular, unsigned with `fraction` fraction bits, below 2^31
 * whatever the lights (see colour.c).
 */
#define NO_DIFFUSE_RANGE 0xffffu /* low and high if there is no such range */

struct colour_terms {
    uint8_t fraction;
    uint8_t clamp;     /* 1: with some normal a channel may exceed 1.0 */
    uint8_t unit_log2; /* a 64th of 1.0 of a channel is 2^unit_log2 */
    /* by sheen_colour_reach: */
    uint16_t faint_specular; /* the specular intensity, UQ1.15, of at most 1/32 of a 64th of 1.0; see faint_highlight */
    uint16_t diffuse_tolerance; /* the difference of diffuse intensities that gives at most 1/8 of a 64th */
    uint16_t low;               /* from this diffuse intensity to `high` all channels of 565 stay 1/32 level */
    uint16_t high;              /* below 1.0 and, unless they are constant, above 0 */
    uint32_t a[3];
    uint16_t b[3], c[3];
    uint32_t top[3]; /* a channel's value at 1.0, to which it is clamped */
};

/*
 * The same for the specialised loops on 565, with LOOP_FRACTION bits, in the order in which they are loaded: a and b of
 * each channel, then the c. Without dither a includes the 1/2 of the one rounding.
 */
#define LOOP_FRACTION 24 /* fraction bits of 565 channels that stay below 2.0 */

struct loop_terms {
    uint32_t ab[6], c[3];
    uint32_t power_end;    /* the power table's argument from which on there is no highlight */
    const uint32_t *power; /* the power table */
    uint8_t usable;        /* 1: 565, LOOP_FRACTION bits, no ramp, no fog: these loops suffice */
};

/*
 * How much a highlight may give and still be left out; least: what gives 1/32 level. When an area of one colour is
 * dithered, each 1/64 level of a channel changes 1/64 of its pixels: 3/256 level of green and half as much of red and
 * blue change 1.5 in 64.
 */
static inline uint32_t faint_highlight(uint32_t least, unsigned dither)
{
    return dither ? 3 * least >> 3 : least;
}

/*
 * Light on texels, for draws with a texture: channel k's light is a + b * diffuse, in [0, 36]; c * specular is added in
 * levels of 565.
 */
#define LIGHT_BITS 24  /* fraction bits of light, and of channels if light is at most 1.0 */
#define BRIGHT_BITS 19 /* fraction bits of channels if light may exceed 1.0 */
#define GREY_BITS 11   /* fraction bits of channels from which grey levels are made */

struct texel_terms {
    const struct sheen_texture *texture;
    uint32_t a[3];    /* with `fraction` bits; about 2^30 at most with b * 1.0 */
    uint16_t b[3];    /* with 15 bits less, for diffuse in UQ1.15 */
    uint16_t c[3];    /* c * specular, UQ1.15, is in levels / 2^(BRIGHT_BITS + c_shift) */
    uint16_t gloss;   /* what 1.0 of specular gives if the highlight is white, UQ1.15 */
    uint16_t grey[3]; /* a 565 level / 2^GREY_BITS of each channel in grey levels, with 31 - level_bits fraction bits */
    uint8_t fraction; /* 24..30 */
    uint8_t c_shift;
    uint8_t alike;     /* 1: light is the same in all channels */
    uint8_t white;     /* 1: the highlight is the same in all channels, at most 1.0 */
    uint8_t uv_packed; /* 1: both texel coordinates are stepped in one word: see texel_steps.h */
    uint8_t unlit;     /* 1: light is 1.0 everywhere, and there is no highlight */
};

/* Colours of lights, for draws that read them. */
struct tint_terms {
    uint32_t low[3]; /* by channel, what a ramp's `low` gives with white lights; `a` does not include it */
    uint8_t color[SHEEN_MAX_LIGHTS][3];
    uint8_t is_tinted;  /* 1: a light has a colour or is a point, so light is found by sheen_light_tinted */
    uint8_t point_mask; /* bit i is set if light i is a point light */
    int32_t reach;      /* units that raw 32768 of the posed mesh stands for, Q7.24; read if there are point lights */
    const struct sheen_points *points;   /* NULL: no point lights */
    const struct sheen_texture *texture; /* of shadings that have one */
};

/* A material's intensity, at most 4.0, times the sum of its lights' intensities; UQ.16, at most 16.0. */
static inline uint32_t intensities(sheen_q16_t of_material, sheen_q16_t of_lights)
{
    return mul_high((uint32_t)of_material << 12, (uint32_t)of_lights << 4);
}

/* x times a byte of colour, 255 = 1.0. */
static inline uint32_t by_colour(uint32_t x, uint8_t colour)
{
    return colour == 255 ? x : mul_high(x, colour * 0x01010101u);
}

static inline uint32_t clamped(uint32_t x, uint32_t top)
{
    return x > top ? top : x;
}

static inline uint32_t colour_channel(const struct colour_terms *t, int k, const struct lit *lit)
{
    return t->a[k] + t->b[k] * lit->diffuse + t->c[k] * lit->specular;
}

/* A 565 value in the target's byte order. */
static inline uint16_t pixel_order(uint32_t value, unsigned swap)
{
#ifdef __GNUC__
    return swap ? __builtin_bswap16((uint16_t)value) : (uint16_t)value;
#else
    return (uint16_t)(swap ? (value << 8 | value >> 8) : value);
#endif
}

/* The same for a value in the high half of a word; where one instruction swaps all four bytes it needs no shift. */
static inline uint16_t high_order(uint32_t value, unsigned swap)
{
#if defined(__GNUC__) && (defined(__arm__) || defined(__x86_64__))
    if (swap)
        return (uint16_t)__builtin_bswap32(value);
#endif
    return pixel_order(value >> 16, swap);
}

/*
 * What is added before the one rounding, by row y mod 8 and column x mod 8: the thresholds (B + 1/2) / 64 of the 8x8
 * Bayer matrix, in 1/128. The ninth row is 1/2 throughout: no dither.
 */
#define NO_DITHER 8
extern const uint8_t sheen_thresholds[9][8];

/*
 * The same with B's base-4 digits reversed, for draws that leave out pixels by B itself: the pixels that are left have
 * low B only, so B's thresholds would all be low.
 */
extern const uint8_t sheen_reversed_thresholds[9][8];

/*
 * Thresholds in 1/2048 for channels with 11 fraction bits: each word has its threshold in both halves (shifting it to
 * 24 fraction bits drops the high one), each row is stored twice over. Loops that do not count columns find a pixel's
 * threshold by the address of its depth, relative to an entry that is chosen for each row of a tile (DITHER_ROW).
 */
#if FAST_LOOPS
typedef uint32_t threshold_t;
#define THRESHOLD(t) ((t)*0x100010u)
#else
typedef uint8_t threshold_t;
#define THRESHOLD(t) (t)
#endif
extern const threshold_t sheen_dither_rows[8][16];

static inline uint32_t threshold_pair(const threshold_t *row, const uint16_t *depth)
{
#if !FAST_LOOPS
    return row[(uintptr_t)depth >> 1 & 7u] * 0x100010u;
#elif defined(__ARM_ARCH_6M__) /* two shifts */
    return *(const uint32_t *)((const char *)row + ((uint32_t)(uintptr_t)depth << 28 >> 27));
#else
    return row[(uintptr_t)depth >> 1 & 7u];
#endif
}

/*
 * Channels in two words. red_blue is 2^16 red + blue, each UQ5.11, as an exact sum: what blue borrows when it goes
 * below 0, it gives back later. green is UQ6.26.
 */
struct packed {
    uint32_t red_blue, green;
};

/*
 * A colour on a 565 target over the diffuse intensity, without highlight. Without dither, finished pixels: entry i +
 * SHADES_GUARD is for the middle between i / 2^SHADES_BITS and the next; the guard entries catch what rounding puts
 * below 0 or above 1. With dither, segments of width 2^-SEGMENT_BITS, two of them to spare: the channels where a
 * segment begins, and what each 2^-SEGMENT_STEPS_BITS of it adds.
 */
#define SHADES_BITS 10
#define SHADES_GUARD 8
#define SHADES_PIXELS (SHADES_GUARD + (1 << SHADES_BITS) + SHADES_GUARD)

#define SEGMENT_BITS 7
#define SEGMENT_STEPS_BITS 5
#define SEGMENTS ((1 << SEGMENT_BITS) + 2)

struct shade_segment { /* as struct packed, in the order in which loops load them */
    uint32_t red_blue, red_blue_step;
    uint32_t green, green_step;
};

struct shades {
    union {
        uint16_t pixel[SHADES_PIXELS]; /* in the target's byte order */
        struct shade_segment segment[SEGMENTS];
    };
    uint32_t a[3]; /* the struct colour_terms that the table was made from */
    uint16_t b[3];
    uint8_t fraction; /* 0: not made yet */
    uint8_t dither;   /* 1: segments */
};

/* Channels, at most 1.0, rounded to a tile's pixel: 565 in the target's byte order, or a grey level. */
uint16_t sheen_finished(const struct colour_terms *t, unsigned is_565, unsigned swap, const uint32_t channel[3]);

void sheen_format_begin(struct pixel_format *format, const struct sheen_target *target);
void sheen_colour_begin(struct colour_terms *t, const struct pixel_format *format, const struct sheen_material *m,
                        sheen_q16_t diffuse_sum, sheen_q16_t specular_sum);
/* Fills in faint_specular, diffuse_tolerance, low and high, for set-ups that ask whether an intensity shows. */
void sheen_colour_reach(struct colour_terms *t, const struct pixel_format *format);
/* Sets `limit`, where a highlight gives less than faint_highlight, and `faint`, where it gives less than 1/32 level. */
void sheen_power_end(struct power *power, const struct colour_terms *t, const struct pixel_format *format,
                     unsigned dither);
/* Whether a texture is as sheen.h demands; t may be NULL. */
int sheen_texture_valid(const struct sheen_texture *t);
/* Whether it can be a matcap too: a bilinear one has to clamp, as the sphere's picture does not repeat. */
int sheen_sphere_valid(const struct sheen_texture *t);
void sheen_texel_begin(struct texel_terms *t, const struct pixel_format *format, const struct sheen_material *m,
                       sheen_q16_t diffuse_sum, sheen_q16_t specular_sum);
/* A colour as a tile's pixel, rounded and not dithered: 565 in the target's byte order, or a grey level. */
uint16_t sheen_colour_pixel(const struct pixel_format *format, const uint8_t rgb[3]);
/* Packs a tile's grey levels, one per byte, as the target has them, in place. */
void sheen_pack_grey(const struct pixel_format *format, uint8_t *pixels, unsigned width, unsigned rows);

/* ---- a tile, and what rows do at a pixel ---- */

/* A row of a triangle inside the tile: x0 <= x < x1; empty if x0 >= x1. */
struct span {
    int16_t x0, x1;
};

/*
 * The next span. Without OPAQUE gcc keeps two pointers, one to read spans and one to compare with the end. On ARMv6-M,
 * where loads of int16_t have no offset, that does no harm.
 */
static inline const struct span *next_span(const struct span *span)
{
    span++;
#if !defined(__ARM_ARCH_6M__)
    OPAQUE(span);
#endif
    return span;
}

/* The facet (a side of a polygon or triangle) that was lit last in a tile: a polygon's triangles mostly follow. */
struct lit_facet {
    const void *draw; /* NULL: none yet */
    uint32_t facet;
    uint16_t diffuse, specular; /* as in struct lit */
    uint16_t pixel;             /* for flat shading without dither */
};

/* A band's pixels while it is drawn: rows without gaps, as wide as its rectangle. */
struct tile {
    struct sheen_rect rect; /* px on the target */
    uint16_t pitch;         /* px */
    uint8_t dither;
    void *pixels; /* uint16_t, or uint8_t on grey */
    uint16_t *depth;
    intptr_t to_pixel; /* on 565: bytes from a pixel's depth to its colour */
    const struct pixel_format *format;
    const uint8_t (*thresholds)[8];        /* sheen_thresholds, or the reversed ones */
    const threshold_t *const *dither_rows; /* by y & 7, for specialised loops: entries of sheen_dither_rows */
    int32_t centre_x, centre_y;            /* the viewport's, 1/64 px on the target: where struct vertex counts from */
    const struct span *spans;
    int16_t first_row; /* the row of spans[0] */
    uint16_t rows;     /* number of spans */
    struct lit_facet facet;
#if SHEEN_STATS
    uint32_t *shaded;
#endif
};

/* For loops that are written once and specialised by constant arguments. */
#if FAST_LOOPS
#define SPECIALISED static inline __attribute__((always_inline))
#else
#define SPECIALISED static inline
#endif

/* The same for specialisations of which a program may link one alone, without the others' code. */
#ifdef __GNUC__
#define SPLIT static inline __attribute__((always_inline))
#else
#define SPLIT static inline
#endif

/* Counts a pixel that passed the depth test, in builds that count. */
#if SHEEN_STATS
#define COUNT_SHADED(t) (++*(t)->shaded)
#else
#define COUNT_SHADED(t) ((void)0)
#endif

/*
 * The thresholds of row y, starting at the entry relative to which a depth's address finds its threshold. line: the
 * address that column 0's depth would have. For specialised loops sheen_dither_begin has chosen them for the whole
 * tile.
 */
#if FAST_LOOPS
void sheen_dither_begin(const struct tile *t, const threshold_t *thresholds[8]);
#define DITHER_ROW(t, line, y) ((void)(line), (t)->dither_rows[(y)&7])
#else
#define DITHER_ROW(t, line, y) (&sheen_dither_rows[(y)&7][-(unsigned)((uintptr_t)(line) >> 1) & 7u])
#endif

/* The index of pixel (x, y) in the tile. */
SPECIALISED uint32_t tile_offset(const struct tile *t, int32_t x, int32_t y)
{
    return (uint32_t)(y - t->rect.y0) * t->pitch + (uint32_t)(x - t->rect.x0);
}

/* The depth test: 1 if z (UQ16.16 of z16) is nearer, and then it is stored; on a tie the first drawn stays. */
SPECIALISED int nearer(const struct tile *t, uint16_t *depth, uint32_t z)
{
    uint32_t z16 = z >> 16;

    (void)t;
    if (z16 <= *depth)
        return 0;
    *depth = (uint16_t)z16;
    COUNT_SHADED(t);
    return 1;
}

/* On 565: where the colour that belongs to a depth is. */
static inline uint16_t *pixel_at(uint16_t *depth, intptr_t to_pixel)
{
    return (uint16_t *)(void *)((char *)depth + to_pixel);
}

/* Row y's thresholds. */
static inline const uint8_t *threshold_row(const struct tile *t, unsigned dither, int32_t y)
{
    return t->thresholds[dither ? (unsigned)y & 7u : NO_DITHER];
}

/* A test of dithering defines this to see each pixel's unrounded channels. */
#ifndef SHEEN_TEST_TAP
#define SHEEN_TEST_TAP(tile, at, r, g, b, fraction) ((void)0)
#endif

/*
 * The pixel in the high half of a word, where red's whole levels are already; blue's are shifted up to it, which shifts
 * red's out.
 */
SPECIALISED uint32_t packed_high(struct packed p)
{
    const uint32_t red_blue = p.red_blue & 0xf800f800u, green = (p.green >> 26) << 21;

#if defined(__ARM_ARCH_6M__) /* in this order it needs two registers only */
    return green | red_blue | red_blue << 5;
#else
    return red_blue | red_blue << 5 | green;
#endif
}

SPECIALISED uint16_t packed_565(struct packed p, unsigned swap)
{
    return high_order(packed_high(p), swap);
}

/* The same dithered; pair: threshold_pair of the pixel. */
SPECIALISED uint32_t dithered_high(const struct tile *t, const uint16_t *depth, struct packed p, uint32_t pair)
{
    (void)t;
    (void)depth;
    SHEEN_TEST_TAP(t, (uint32_t)(depth - t->depth), p.red_blue >> 16, p.green >> 15, p.red_blue & 0xffffu, 11);
    p.red_blue += pair;
    p.green += pair << 15; /* the high half is shifted out */
    return packed_high(p);
}

SPECIALISED uint16_t dithered_565(const struct tile *t, const uint16_t *depth, struct packed p, uint32_t pair,
                                  unsigned swap)
{
    return high_order(dithered_high(t, depth, p, pair), swap);
}

/* A row's thresholds, and the shift that brings them to the draw's fraction bits. */
struct rounding {
    const uint8_t *threshold;
    unsigned shift;
};

SPECIALISED struct rounding rounding_of(const struct tile *t, const struct colour_terms *terms, int32_t y)
{
    struct rounding r = {threshold_row(t, t->dither, y), terms->fraction - 7u};

    return r;
}

/* The one rounding: floor(channel + threshold), each channel clamped to 1.0; grey, fraction, swap: the draw's own. */
SPECIALISED void put_rounded(const struct tile *t, const struct colour_terms *terms, uint32_t threshold, uint32_t at,
                             uint32_t r, uint32_t g, uint32_t b, unsigned grey, unsigned fraction, unsigned swap)
{
    SHEEN_TEST_TAP(t, at, r, g, b, fraction);
    r = clamped(r, terms->top[0]) + threshold;
    g = clamped(g, terms->top[1]);
    b = clamped(b, terms->top[2]);
    if (grey) {
        ((uint8_t *)t->pixels)[at] = (uint8_t)((r + g + b) >> fraction);
        return;
    }
    uint32_t value = (r >> fraction) << 11 | ((g + threshold) >> fraction) << 5 | (b + threshold) >> fraction;
    ((uint16_t *)t->pixels)[at] = pixel_order(value, swap);
}

/* put_rounded as a function, for builds for size. */
void sheen_put_clamped(const struct tile *t, const struct colour_terms *terms, uint32_t threshold, uint32_t at,
                       uint32_t r, uint32_t g, uint32_t b);

SPECIALISED void put_clamped(const struct tile *t, const struct colour_terms *terms, uint32_t threshold, uint32_t at,
                             uint32_t r, uint32_t g, uint32_t b, unsigned grey, unsigned fraction, unsigned swap)
{
    if (FAST_LOOPS)
        put_rounded(t, terms, threshold, at, r, g, b, grey, fraction, swap);
    else
        sheen_put_clamped(t, terms, threshold, at, r, g, b);
}

SPECIALISED void put_general(const struct tile *t, const struct colour_terms *terms, struct rounding rounding,
                             uint32_t at, int32_t x, uint32_t r, uint32_t g, uint32_t b)
{
    uint32_t threshold = (uint32_t)rounding.threshold[(uint32_t)x & 7u] << rounding.shift;

    put_clamped(t, terms, threshold, at, r, g, b, t->format->grey, terms->fraction, t->format->swap);
}

/* floor of channels that include the rounding and that no corner takes above the highest level. */
SPECIALISED uint16_t fast_pixel(uint32_t r, uint32_t g, uint32_t b, unsigned fraction, unsigned swap)
{
    return pixel_order((r >> fraction) << 11 | (g >> fraction) << 5 | b >> fraction, swap);
}

/* max(0, x) for a sum that rounding may have taken below 0. */
SPECIALISED uint32_t not_negative(uint32_t x)
{
    return (int32_t)x < 0 ? 0 : x;
}

/*
 * A 565 pixel in the machine's byte order, from channels with LOOP_FRACTION bits that include the rounding; clamped to
 * the highest level. Range: below 2^31, as int32_t; they may be below 0, which counts as 0, only if `below` is 1.
 */
SPECIALISED uint32_t clamped_565(uint32_t r, uint32_t g, uint32_t b, int below)
{
    r = (uint32_t)asr32((int32_t)r, LOOP_FRACTION);
    g = (uint32_t)asr32((int32_t)g, LOOP_FRACTION);
    b = (uint32_t)asr32((int32_t)b, LOOP_FRACTION);
#ifdef __ARM_FEATURE_SAT /* these become instructions that shift and saturate at once */
    (void)below;
    r = (uint32_t)max32(min32((int32_t)r, 31), 0);
    g = (uint32_t)max32(min32((int32_t)g, 63), 0);
    b = (uint32_t)max32(min32((int32_t)b, 31), 0);
#else
    uint32_t all = g >> 1 | r;
    OPAQUE(all); /* so that it is computed in place by instructions of two operands */
    if ((all | b) > 31) {
        if (below) {
            r = not_negative(r);
            g = not_negative(g);
            b = not_negative(b);
        }
        r = r < 31 ? r : 31;
        g = g < 63 ? g : 63;
        b = b < 31 ? b : 31;
    }
#endif
    return (r << 6 | g) << 5 | b;
}

/* Channels with LOOP_FRACTION bits. lit: L.N, UQ1.15; shines: 0: no highlight is added. */
struct loop_channels {
    uint32_t r, g, b;
};

SPECIALISED struct loop_channels loop_channels(const struct loop_terms *q, uint32_t lit, int shines, uint32_t specular)
{
    struct loop_channels at = {q->ab[0] + q->ab[1] * lit, q->ab[2] + q->ab[3] * lit, q->ab[4] + q->ab[5] * lit};

    if (shines) {
        at.r += q->c[0] * specular;
        at.g += q->c[1] * specular;
        at.b += q->c[2] * specular;
    }
    return at;
}

/*
 * A 565 pixel in the machine's byte order, from loop_channels and the threshold that is added to each of them before
 * the one rounding. Range: channels are below 2.0 plus a threshold, so below 2^31.
 */
SPECIALISED uint32_t loop_pixel(const struct tile *t, const uint16_t *depth, const struct loop_terms *q, uint32_t lit,
                                int shines, uint32_t specular, uint32_t threshold)
{
    const struct loop_channels at = loop_channels(q, lit, shines, specular);

    (void)t;
    (void)depth;
    if (threshold != 0)
        SHEEN_TEST_TAP(t, (uint32_t)(depth - t->depth), at.r, at.g, at.b, LOOP_FRACTION);
    return clamped_565(at.r + threshold, at.g + threshold, at.b + threshold, 0);
}

#endif
