/*
 * test_core_newton.c - reciprocal and reciprocal root against exact residuals.
 *
 *   test_core_newton        every 4099th argument, and both ends
 *   test_core_newton all    every argument: 2^31 and 3 * 2^30
 *
 * Tolerances: the seeds 1.7 and 1.5 raw steps of UQ1.15, the results 2^-29 of their own size, tighter than what
 * newton.h promises (over all arguments 1.68, 1.50, 2^-29.3, 2^-29.1); over a root 2^-26.8. 2.0 is held at 65535
 * and 0xffffffff.
 *
 * No reference is computed: r is within e of 1/x where x (r - e) <= 1 <= x (r + e), for the root likewise with r^2.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "math/inverse.h"

#define RECIPROCAL_SEED 1.7
#define ROOT_SEED 1.5
#define RELATIVE 0x1p-29
#define OVER_ROOT 0x1.2p-27

static uint32_t stride = 4099;

/* x r - 1 for x: UQ0.32, r: UQ1.31; below, x r^2 - 1. Exact up to one or two roundings to 53 bits. */
static double reciprocal_residual(uint32_t x, uint32_t r)
{
    return (double)(int64_t)((uint64_t)x * r - (UINT64_C(1) << 63)) * 0x1p-63;
}

static double root_residual(uint32_t x, uint32_t r)
{
    uint128 product = (uint128)((uint64_t)r * r) * x; /* 1.0 is 2^94 */

    return (double)(int128)(product - ((uint128)1 << 94)) * 0x1p-94;
}

/* Largest and smallest residuals over [from, 2^32), without libm or branches a step. */
struct range {
    double low, high, seed;
    uint32_t low_at, high_at, seed_at;
};

static void range_add(struct range *r, uint32_t x, double residual, double seed)
{
    if (residual < r->low) {
        r->low = residual;
        r->low_at = x;
    }
    if (residual > r->high) {
        r->high = residual;
        r->high_at = x;
    }
    if (seed > r->seed) {
        r->seed = seed;
        r->seed_at = x;
    }
}

static void range_assert(const struct range *r, double relative, double seed, const char *what)
{
    print_message("           %s: residual %.3g at %08x to %.3g at %08x, seed off by %.3f at %08x\n", what, r->low,
                  r->low_at, r->high, r->high_at, r->seed, r->seed_at);
    assert_true(r->low >= -relative && r->high <= relative);
    assert_true(r->seed <= seed);
    assert_true(r->low < 0 && r->seed > 0.5);
}

static void test_reciprocal(void **unused)
{
    struct range range = {0};

    (void)unused;
    for (uint64_t i = UINT64_C(1) << 31; i <= UINT32_MAX; i += stride) {
        uint32_t x = (uint32_t)i;
        double seed = reciprocal_residual(x, reciprocal_seed(x) << 16);
        range_add(&range, x, reciprocal_residual(x, sheen_reciprocal(x)), fabs(seed) * 0x1p47 / x);
    }
    range_assert(&range, RELATIVE, RECIPROCAL_SEED, "reciprocal");
}

/* 1/sqrt(x) (1 + e)^2 - 1 is 2 e + e^2, so half the residual is the relative error. */
static void test_root(void **unused)
{
    struct range range = {0}, slow = {0};

    (void)unused;
    for (uint64_t i = UINT64_C(1) << 30; i <= UINT32_MAX; i += stride) {
        uint32_t x = (uint32_t)i, seed = root_seed(x >> 1);
        double off = fabs(root_residual(x, seed << 16)) / 2 * seed;
        range_add(&range, x, root_residual(x, sheen_root_step(x, seed << 16)), off);
        range_add(&slow, x, root_residual(x, sheen_reciprocal_root(x)), off);
    }
    range_assert(&range, 2 * RELATIVE, ROOT_SEED, "reciprocal root");
    range_assert(&slow, 2 * RELATIVE, ROOT_SEED, "without the table");
}

/* A division by a root, in 16-bit products: INT32_MAX is as good as 2.0 in Q1.30. */
static void test_over_root(void **unused)
{
    struct range range = {0};

    (void)unused;
    for (uint64_t i = UINT64_C(1) << 30; i <= UINT32_MAX; i += stride) {
        uint32_t x = (uint32_t)i;
        double r = over(inverse_root(x, 0), INT32_MAX) * 0x1p-29, off = fabs(root_seed(x >> 1) - 32768 * r);
        range_add(&range, x, x * 0x1p-32 * r * r - 1, off);
    }
    range_assert(&range, 2 * OVER_ROOT, ROOT_SEED, "over a root");
}

/* The root's seed goes on a little above 1.0, where rounding may take N.N of a unit vector. */
static void test_root_seed_above_one(void **unused)
{
    struct worst worst = {0};

    (void)unused;
    for (uint32_t d = 1u << 31; d < (1u << 31) + (1u << 22); d++)
        worst_note(&worst, root_seed(d) - 32768 / sqrt(d * 0x1p-31), "%08x", d);
    worst_assert(&worst, ROOT_SEED, "root seed above 1");
}

static void test_ends(void **unused)
{
    (void)unused;
    assert_int_equal(reciprocal_seed(0x80000000u), 65535);
    assert_int_equal(root_seed(1u << 29), 65535);
    assert_true(sheen_reciprocal(0x80000000u) >= 0xfffffff0u);
    assert_true(sheen_reciprocal_root(0x40000000u) >= 0xfffffff0u);
    assert_true(sheen_reciprocal(UINT32_MAX) - 0x7ffffff0u <= 32);
    assert_true(sheen_reciprocal_root(UINT32_MAX) - 0x7ffffff0u <= 32);
}

int main(int count, char **words)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reciprocal),          cmocka_unit_test(test_root), cmocka_unit_test(test_over_root),
        cmocka_unit_test(test_root_seed_above_one), cmocka_unit_test(test_ends),
    };

    if (count == 2 && strcmp(words[1], "all") == 0) {
        stride = 1;
    } else if (count != 1) {
        (void)fprintf(stderr, "usage: %s [all]\n", words[0]);
        return 2;
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
