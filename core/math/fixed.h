/*
 * fixed.h - multiply, shift, round: the few operations all fixed point is made of.
 *
 * Qi.f is signed, UQi.f unsigned: value = raw / 2^f. Right shifts of negative
 * numbers, which C leaves to the compiler, go through asr32 and asr64 only.
 */
#ifndef SHEEN_FIXED_H
#define SHEEN_FIXED_H

#include <stdint.h>

/* Forces x to be computed here: compilers otherwise move its computation behind branches, and spill its operands. */
#ifdef __GNUC__
#define IN_REGISTER(x) __asm__("" : "+r"(x))
#else
#define IN_REGISTER(x) ((void)0)
#endif

/* Not inlined, so that the callers' stack (of which there is 1 KB) or their code stays small. */
#ifdef __GNUC__
#define APART __attribute__((noinline))
#else
#define APART
#endif

/*
 * Optimised for size even in builds for speed: for what runs once per draw or at pixels of rare targets, or is as fast
 * that way.
 */
#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#define COLD __attribute__((noinline, cold))
#else
#define COLD
#endif

/*
 * What takes most of a frame while bands are drawn. A build may define SHEEN_HOT_SECTION, how the names of these
 * functions' sections begin, to have a linker script put them into fast memory (firmware/README.md).
 */
#ifdef SHEEN_HOT_SECTION
#define HOT_TEXT(name) #name
#define HOT_NAME(section, n) HOT_TEXT(section.n)
/* Each function has a section of its own, so that a linker leaves out what is not called. */
#define HOT __attribute__((section(HOT_NAME(SHEEN_HOT_SECTION, __COUNTER__))))
#else
#define HOT
#endif

/*
 * floor(x / 2^n), 0 <= n <= 31. GCC and Clang document >> of a negative number as arithmetic; for other compilers the
 * complement of a non-negative number is shifted.
 */
static inline int32_t asr32(int32_t x, unsigned n)
{
#ifdef __GNUC__
    return x >> n;
#else
    return x >= 0 ? x >> n : ~(~x >> n);
#endif
}

/* floor(x / 2^n), 0 <= n <= 63. */
static inline int64_t asr64(int64_t x, unsigned n)
{
#ifdef __GNUC__
    return x >> n;
#else
    return x >= 0 ? x >> n : ~(~x >> n);
#endif
}

/* floor(x / 2^n + 1/2), 1 <= n <= 62; x MUST be below 2^63 - 2^(n - 1). */
static inline int64_t round_shift64(int64_t x, unsigned n)
{
    return asr64(x + ((int64_t)1 << (n - 1)), n);
}

/* round(a * b / 2^n), 1 <= n <= 62; the caller ensures that the result fits. */
static inline int32_t mul_round(int32_t a, int32_t b, unsigned n)
{
    return (int32_t)round_shift64((int64_t)a * b, n);
}

/* mul_round() as a shared function, 1 <= n <= 32, for code that runs once per draw and need not be fast. */
int32_t sheen_mul_round(int32_t a, int32_t b, unsigned n);

/*
 * floor(a / b), b > 0. Where division is a library function of 270 B, builds for size have one of 30 B, which is
 * slower; that costs little, because most edges are short and need no division.
 */
#ifndef QUOTIENT_BY_BITS
#if defined(__OPTIMIZE_SIZE__) && defined(__ARM_ARCH_6M__)
#define QUOTIENT_BY_BITS 1
#else
#define QUOTIENT_BY_BITS 0
#endif
#endif

#if QUOTIENT_BY_BITS
uint32_t sheen_quotient(uint32_t a, uint32_t b);
#define QUOTIENT(a, b) sheen_quotient(a, b)
#else
#define QUOTIENT(a, b) ((a) / (b))
#endif

/* High word of the product: floor(a * b / 2^32). */
static inline uint32_t mul_high(uint32_t a, uint32_t b)
{
    return (uint32_t)(((uint64_t)a * b) >> 32);
}

/*
 * Stands before a loop of at most four iterations: unrolled except in builds for size, because GCC otherwise keeps the
 * loop's arrays in memory.
 */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__OPTIMIZE_SIZE__)
#define UNROLLED _Pragma("GCC unroll 4")
#else
#define UNROLLED
#endif

/*
 * Hides from the compiler how x, an integer or a pointer, was computed, so that it keeps the code as it is written.
 * OPAQUE_BOTH does so for two at once.
 */
#ifdef __GNUC__
#define OPAQUE(x) __asm__("" : "+r"(x))
#define OPAQUE_BOTH(x, y) __asm__("" : "+r"(x), "+r"(y))
#define OPAQUE_FIRST(x) __asm__ volatile("" : "+r"(x)::"memory") /* nothing is loaded or stored across it */
#else
#define OPAQUE(x) ((void)0)
#define OPAQUE_BOTH(x, y) ((void)0)
#define OPAQUE_FIRST(x) ((void)0)
#endif

/* Leading zero bits, 0..32. */
static inline unsigned clz32(uint32_t x)
{
#ifdef __GNUC__
    return x == 0 ? 32u : (unsigned)__builtin_clz(x);
#else
    unsigned zeros = 32;
    for (; x != 0; x >>= 1)
        zeros--;
    return zeros;
#endif
}

static inline unsigned clz64(uint64_t x)
{
    uint32_t high = (uint32_t)(x >> 32);
    return high != 0 ? clz32(high) : 32u + clz32((uint32_t)x);
}

/* |x| without the overflow at INT32_MIN. */
static inline uint32_t magnitude32(int32_t x)
{
    return x < 0 ? 0u - (uint32_t)x : (uint32_t)x;
}

static inline int32_t min32(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static inline int32_t max32(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

/*
 * A Q1.30 (or any 32-bit) factor times a 16-bit one without a 64-bit product: floor(n * v / 2^16). Range: |n| <= 2^15,
 * so n times the low half is below 2^31; the result fits if |n| < 2^15 or |v| < 2^31.
 */
static inline int32_t mul_16_32(int32_t n, int32_t v)
{
    return n * asr32(v, 16) + asr32(n * (int32_t)((uint32_t)v & 0xffffu), 16);
}

/*
 * Products of more than 32 bits have two forms that give the same bits: wide_*, for processors that multiply to 64
 * bits, and halves_*, made of 16-bit products, for those without such an instruction (Armv6-M and the like).
 */
#ifndef WIDE_PRODUCTS
#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 1
#define WIDE_PRODUCTS 0
#else
#define WIDE_PRODUCTS 1
#endif
#endif

#if WIDE_PRODUCTS
#define PRODUCT_FORM(name) wide_##name
#else
#define PRODUCT_FORM(name) halves_##name
#endif

/* mul_16_32() for an n of 16 bits. */
static inline int32_t wide_part(int16_t n, int32_t v)
{
    return (int32_t)asr64((int64_t)(n * (1 << 16)) * v, 32);
}

static inline int32_t halves_part(int16_t n, int32_t v)
{
    return mul_16_32(n, v);
}

/*
 * Dot product of a 16-bit unit vector (Q0.15) and a Q1.30 one: Q2.29, within 3
 * raw steps. Range: |v| <= 1.005, a unit vector turned by three rotations that are
 * off by 1/1024 each, so every partial sum stays below 2^31.
 */
static inline int32_t dot_q29(const int16_t n[3], const int32_t v[3])
{
    return PRODUCT_FORM(part)(n[0], v[0]) + PRODUCT_FORM(part)(n[1], v[1]) + PRODUCT_FORM(part)(n[2], v[2]);
}

/* The same for |n| <= 2^15 held as int32_t, by 32-bit products only. */
static inline int32_t dot32_q29(const int32_t n[3], const int32_t v[3])
{
    return mul_16_32(n[0], v[0]) + mul_16_32(n[1], v[1]) + mul_16_32(n[2], v[2]);
}

/*
 * What a unit normal lacks of its full length. Normals hold 1.0 as 32767; rounding their components may leave the
 * length half a step off, which a highlight of n = 128 shows. 1/|n| = (1 + lacking / 2^31) / 32767. Clamped to what
 * rounding can do: +-65535.
 */
static inline int32_t lacking(const int16_t n[3])
{
    const uint32_t unit = 32767 * 32767;
    uint32_t square = (uint32_t)(n[0] * n[0]) + (uint32_t)(n[1] * n[1]) + (uint32_t)(n[2] * n[2]); /* <= 3 * 2^30 */

    return square > unit ? -min32((int32_t)((square - unit) >> 1), 32767) * 2 : min32((int32_t)(unit - square), 65535);
}

/*
 * Dot product of such a normal, corrected to full length, and a Q1.30 vector: Q2.29; lacks: lacking(n). Range: |dot| <
 * 2^30, so 2^14 * 2^16.
 */
static inline int32_t unit_dot_q29(const int16_t n[3], int32_t lacks, const int32_t v[3])
{
    int32_t dot = dot_q29(n, v);

    return dot + asr32(dot, 15) + asr32(asr32(dot, 16) * lacks, 15);
}

#endif
