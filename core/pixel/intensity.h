/*
 * intensity.h - private: intensities of light: highlights by power tables, diffuse light by ramps.
 */
#ifndef SHEEN_INTENSITY_H
#define SHEEN_INTENSITY_H

#include <stddef.h>

#include "../math/fixed.h"
#include "../math/newton.h"
#include "../sheen.h"
#include "build.h"

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

#endif
