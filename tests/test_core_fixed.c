/*
 * test_core_fixed.c - core/math/fixed.h against exact 64- and 128-bit arithmetic.
 *
 * Tolerance: 0 raw steps for shifts, products and mul_16_32, which is exactly a floor; dot_q29 is a sum of three
 * floors, so it lies in (exact - 3, exact].
 */
#include <stdlib.h>

#include "test_core_worst.h"

#include "frame_stage.h"
#include "math/fixed.h"

#define CASES 200000

static const int32_t corners[] = {0,         1,          -1,         2,         -2,         32767,
                                  32768,     -32768,     -32769,     65535,     65536,      -65536,
                                  (1 << 30), -(1 << 30), 0x55555555, INT32_MAX, -INT32_MAX, INT32_MIN};
#define CORNERS (sizeof corners / sizeof corners[0])

/* All pairs of corner values first, then random numbers of every length. */
static int32_t sample(uint32_t *state, int i, int which)
{
    if (i < (int)(CORNERS * CORNERS))
        return corners[which == 0 ? (size_t)i % CORNERS : (size_t)i / CORNERS];
    uint32_t bits = stage_random(state), length = stage_random(state) % 32;

    return (int32_t)bits >> length;
}

/* floor(x / 2^n) by division. */
static int128 floor_shift(int128 x, unsigned n)
{
    int128 d = (int128)1 << n, q = x / d;

    return x % d < 0 ? q - 1 : q;
}

static void test_right_shifts_floor(void **unused)
{
    uint32_t state = 1;

    (void)unused;
    for (int i = 0; i < CASES; i++) {
        int32_t x = sample(&state, i, 0);
        int64_t wide = (int64_t)x * ((int64_t)1 << 32) + (uint32_t)sample(&state, i, 1);
        for (unsigned n = 0; n < 32; n++)
            assert_true(asr32(x, n) == floor_shift(x, n));
        unsigned n = (unsigned)i % 64;
        assert_true(asr64(wide, n) == floor_shift(wide, n));
    }
}

static void test_rounding_is_half_up(void **unused)
{
    uint32_t state = 2;

    (void)unused;
    for (int i = 0; i < CASES; i++) {
        int32_t a = sample(&state, i, 0), b = sample(&state, i, 1);
        unsigned n = 1 + (unsigned)i % 62;
        int64_t product = (int64_t)a * b;
        int128 exact = floor_shift((int128)product + ((int128)1 << (n - 1)), n);
        assert_true(round_shift64(product, n) == exact);
        if (exact >= INT32_MIN && exact <= INT32_MAX)
            assert_true(mul_round(a, b, n) == exact);
    }
    assert_int_equal(round_shift64(1, 1), 1); /* 1/2 up */
    assert_int_equal(round_shift64(-1, 1), 0);
    assert_int_equal(round_shift64(-3, 1), -1);
    /* both ends of the range that the header gives */
    assert_true(round_shift64(INT64_MAX - (INT64_C(1) << 61), 62) == 1);
    assert_true(round_shift64((INT64_C(1) << 61) - INT64_MAX, 62) == -1);
}

static void test_high_words_and_lengths(void **unused)
{
    uint32_t state = 3;

    (void)unused;
    for (int i = 0; i < CASES; i++) {
        uint32_t a = (uint32_t)sample(&state, i, 0), b = (uint32_t)sample(&state, i, 1);
        uint64_t wide = (uint64_t)a << 32 | b;
        assert_true(mul_high(a, b) == (uint32_t)(((uint128)a * b) >> 32));
        assert_true(magnitude32((int32_t)a) == (uint32_t)llabs((int32_t)a));
        unsigned length = 0, wide_length = 0;
        while (length < 32 && a >> length != 0)
            length++;
        while (wide_length < 64 && wide >> wide_length != 0)
            wide_length++;
        assert_int_equal(clz32(a), 32 - length);
        assert_int_equal(clz64(wide), 64 - wide_length);
        assert_int_equal(min32((int32_t)a, (int32_t)b), (int32_t)a < (int32_t)b ? (int32_t)a : (int32_t)b);
        assert_int_equal(max32((int32_t)a, (int32_t)b), (int32_t)a < (int32_t)b ? (int32_t)b : (int32_t)a);
    }
}

/* Every 16-bit factor, at the other's corners and at random. */
static void test_mul_16_32_is_a_floor(void **unused)
{
    uint32_t state = 4;

    (void)unused;
    for (int32_t n = INT16_MIN; n <= INT16_MAX; n++) {
        for (size_t k = 0; k < CORNERS; k++)
            assert_true(mul_16_32(n, corners[k]) == asr64((int64_t)n * corners[k], 16));
        int32_t v = (int32_t)stage_random(&state);
        assert_true(mul_16_32(n, v) == asr64((int64_t)n * v, 16));
    }
}

static void test_dot_is_within_three_steps_below(void **unused)
{
    uint32_t state = 5;
    double deepest = 0;

    (void)unused;
    for (int i = 0; i < CASES; i++) {
        double v[3], length = 0;
        int16_t n[3];
        int32_t q[3];
        for (int k = 0; k < 3; k++) {
            n[k] = (int16_t)stage_random(&state); /* any, so sqrt 3 long at the most */
            v[k] = stage_uniform(&state, -1, 1);
            length += v[k] * v[k];
        }
        for (int k = 0; k < 3; k++)
            q[k] = (int32_t)(v[k] / sqrt(length) * 1.001 * (1 << 30));
        int64_t exact = (int64_t)n[0] * q[0] + (int64_t)n[1] * q[1] + (int64_t)n[2] * q[2]; /* Q.45 */
        double above = (double)dot_q29(n, q) - (double)exact / 65536;
        assert_true(above <= 0 && above > -3);
        deepest = fmin(deepest, above);
    }
    assert_true(deepest < -2); /* the cases do reach what the header allows */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_right_shifts_floor),
        cmocka_unit_test(test_rounding_is_half_up),
        cmocka_unit_test(test_high_words_and_lengths),
        cmocka_unit_test(test_mul_16_32_is_a_floor),
        cmocka_unit_test(test_dot_is_within_three_steps_below),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
