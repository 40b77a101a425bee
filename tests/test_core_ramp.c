/*
 * test_core_ramp.c - ramps over L.N, made and named, and light at a normal by them, against double precision.
 */
#include <string.h>

#include "test_core_worst.h"

#include "frame/frame.h"
#include "frame_stage.h"

#define STEPS SHEEN_RAMP_STEPS

static double ramp_value(const struct sheen_ramp *ramp, unsigned i)
{
    return ramp->low / 65536.0 + ramp->span / 65536.0 * ramp->value[i] / 32768;
}

static void test_named(void **unused)
{
    struct worst half = {0}, toon = {0};

    (void)unused;
    for (unsigned i = 0; i <= STEPS; i++) {
        double x = i / 128.0 - 1, lit = (1 + x) / 2;
        worst_note(&half, (ramp_value(&sheen_ramp_half, i) - lit * lit) * 32768, "entry %u", i);
        worst_note(&toon, (ramp_value(&sheen_ramp_toon, i) - ((x > 0) + (x > .25) + (x > .7)) / 3.0) * 32768,
                   "entry %u", i);
    }
    worst_assert(&half, 0.5, "half");
    worst_assert(&toon, 0.5, "toon");
}

/* Off by half a step of 2^-15 of the span and one of low and span, and what 32 bits leave of a root. */
static void test_gamma(void **unused)
{
    struct worst worst = {0};
    unsigned steepest = 0, dark = 0;

    (void)unused;
    for (sheen_q16_t ambient = 0; ambient <= 4 << 16; ambient += 6553)
        for (double diffuse = 64; diffuse <= 4 << 16; diffuse *= 1.19) {
            struct sheen_ramp ramp;
            const double a = ambient / 65536.0, d = (sheen_q16_t)diffuse / 65536.0;
            assert_int_equal(sheen_ramp_make_gamma(&ramp, ambient, (sheen_q16_t)diffuse), SHEEN_OK);
            double rises = 0, step = d * ramp.span / 65536 / 65536 + d / 65536 * 1.5 + 1e-6;
            for (unsigned i = 0; i <= STEPS; i++) {
                double x = fmax(0, i / 128.0 - 1), exact = pow(a + d * x, 1 / 2.2) - a;
                worst_note(&worst, (ramp_value(&ramp, i) * d - exact) / step, "%g + %g, entry %u", a, d, i);
                assert_true(ramp.value[i] <= 32768 && (i == 0 || ramp.value[i] >= ramp.value[i - 1]));
                if (i > 0)
                    rises = fmax(rises, (ramp_value(&ramp, i) - ramp_value(&ramp, i - 1)) * 128);
            }
            double coarse = ramp.span / 65536.0 / 128; /* what half a step more or less makes of the steepest part */
            assert_true(rises <= ldexp(1, ramp.steep) + coarse &&
                        (ramp.steep == 0 || rises > ldexp(1, ramp.steep - 1) - coarse));
            steepest = ramp.steep > steepest ? ramp.steep : steepest;
            dark += ramp.low < 0;
        }
    worst_assert(&worst, 1, "gamma in tolerances");
    assert_true(steepest >= 9 && dark > 100);
}

static void test_gamma_out_of_range(void **unused)
{
    static const sheen_q16_t wrong[][2] = {{-1, 65536},        {(4 << 16) + 1, 65536}, {0, 63}, {0, (4 << 16) + 1},
                                           {65536, INT32_MIN}, {INT32_MAX, INT32_MAX}, {0, 0}};
    struct sheen_ramp ramp = sheen_ramp_half;

    (void)unused;
    for (unsigned i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        assert_int_equal(sheen_ramp_make_gamma(&ramp, wrong[i][0], wrong[i][1]), SHEEN_ERR_ARGUMENT);
    assert_memory_equal(&ramp, &sheen_ramp_half, sizeof ramp);
}

/* Linear between entries, and held at both ends. */
static void test_between_entries(void **unused)
{
    struct worst worst = {0};
    struct sheen_ramp ramp = sheen_ramp_half;
    uint32_t state = 1;

    (void)unused;
    for (unsigned i = 0; i <= STEPS; i++)
        ramp.value[i] = (uint16_t)(stage_random(&state) % 32769);
    for (int32_t ln = -32768; ln < 32768; ln++) {
        unsigned i = (unsigned)(ln + 32768) >> 8;
        double t = (ln & 255) / 256.0;
        worst_note(&worst, response_at(&ramp, ln) - ((1 - t) * ramp.value[i] + t * ramp.value[i + 1]), "L.N %d", ln);
    }
    worst_assert(&worst, 0.5, "between entries");
    assert_int_equal(response_at(&ramp, INT32_MIN), ramp.value[0]);
    assert_int_equal(response_at(&ramp, INT32_MAX), response_at(&ramp, 32767));
}

/* The response to a ramp that is max(0, L.N) is that of no ramp, by a step for each light. */
static void test_lambert_by_a_ramp(void **unused)
{
    struct sheen_ramp ramp = sheen_ramp_half;
    uint32_t state = 2;
    int lit_ones = 0;

    (void)unused;
    for (unsigned i = 0; i <= STEPS; i++)
        ramp.value[i] = (uint16_t)(i < STEPS / 2 ? 0 : (i - STEPS / 2) * 256);
    for (int i = 0; i < 20000; i++) {
        struct sheen_light light[SHEEN_MAX_LIGHTS] = {{.intensity = 0}};
        const unsigned count = 1 + stage_random(&state) % SHEEN_MAX_LIGHTS;
        struct lighting lighting;
        struct lit plain, by_ramp;
        struct sheen_pose pose;
        sheen_q30_t unit[3];
        int16_t n[3];
        sheen_pose_identity(&pose);
        for (unsigned k = 0; k < 3 * count; k++)
            light[k / 3].to[k % 3] = (int32_t)stage_random(&state);
        const int32_t v[3] = {(int32_t)stage_random(&state), (int32_t)stage_random(&state),
                              (int32_t)stage_random(&state)};
        assert_int_equal(sheen_normalize(v, unit), SHEEN_OK);
        for (int k = 0; k < 3; k++)
            n[k] = (int16_t)(unit[k] / 32769);
        assert_int_equal(sheen_light_begin(&lighting, light, count, pose.rotation, NULL, LIGHTS_FAR), SHEEN_OK);
        light_normal(&lighting, (struct power[]){power_of(&sheen_shine_16)}, n, &plain);
        lighting.ramp = &ramp;
        light_normal(&lighting, (struct power[]){power_of(&sheen_shine_16)}, n, &by_ramp);
        assert_in_range(by_ramp.diffuse + SHEEN_MAX_LIGHTS - plain.diffuse, 0, 2 * SHEEN_MAX_LIGHTS);
        assert_int_equal(by_ramp.specular, plain.specular);
        lit_ones += plain.specular > 0;
    }
    assert_true(lit_ones > 1000);
}

/* Half-Lambert would give a normal at right angles a quarter. */
static void test_zero_normal(void **unused)
{
    const struct sheen_light light = {.to = {0, 0, 1 << 30}};
    const int16_t zero[3] = {0, 0, 0}, aside[3] = {32767, 0, 0};
    struct lighting lighting;
    struct sheen_pose pose;
    struct lit lit;

    (void)unused;
    sheen_pose_identity(&pose);
    assert_int_equal(sheen_light_begin(&lighting, &light, 1, pose.rotation, NULL, LIGHTS_FAR), SHEEN_OK);
    lighting.ramp = &sheen_ramp_half;
    light_normal(&lighting, (struct power[]){power_of(NULL)}, aside, &lit);
    assert_in_range(lit.diffuse, 8191, 8193);
    light_normal(&lighting, (struct power[]){power_of(NULL)}, zero, &lit);
    assert_int_equal(lit.diffuse, 0);
    assert_int_equal(lit.specular, 0);
}

/* Whatever a table holds, intensities and channels stay in range. */
static void test_garbage(void **unused)
{
    struct sheen_ramp ramp = sheen_ramp_half;
    uint32_t state = 3;

    (void)unused;
    for (int i = 0; i < 20000; i++) {
        const struct sheen_light light = {.to = {(int32_t)stage_random(&state), (int32_t)stage_random(&state), 1}};
        const struct pixel_format format = {.scale = {31 << 16, 63 << 16, 31 << 16}, .level_bits = 6};
        struct sheen_material material = {.base = {255, 255, 255}, .ambient = 4 << 16, .diffuse = 4 << 16};
        const int16_t n[3] = {(int16_t)stage_random(&state), (int16_t)stage_random(&state),
                              (int16_t)stage_random(&state)};
        struct sheen_material by_ramp;
        struct colour_terms terms;
        struct draw draw;
        struct sheen_pose pose;
        struct lit lit;
        for (unsigned k = 0; k <= STEPS; k++)
            ramp.value[k] = (uint16_t)stage_random(&state);
        ramp.low = (int32_t)stage_random(&state);
        ramp.span = (int32_t)stage_random(&state);
        material.ramp = &ramp;
        sheen_pose_identity(&pose);
        assert_int_equal(sheen_light_begin(&draw.light, &light, 1, pose.rotation, NULL, LIGHTS_FAR), SHEEN_OK);
        draw.light.diffuse_sum = 4 << 16;
        assert_ptr_equal(sheen_ramp_reader.begin(&draw, &material, &by_ramp, i & 1), &by_ramp);
        assert_int_equal(draw.pixel_ramp & 1, i & 1);
        light_normal(&draw.light, (struct power[]){power_of(NULL)}, n, &lit);
        assert_true(lit.diffuse <= 32768);
        assert_in_range(by_ramp.ambient, 0, 20 << 16);
        assert_in_range(by_ramp.diffuse, 0, 4 << 16);
        sheen_colour_begin(&terms, &format, &by_ramp, 4 << 16, 4 << 16);
        for (int k = 0; k < 3; k++)
            assert_true((uint64_t)terms.a[k] + (uint64_t)terms.b[k] * 32768 < 1u << 31);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_named),
        cmocka_unit_test(test_gamma),
        cmocka_unit_test(test_gamma_out_of_range),
        cmocka_unit_test(test_between_entries),
        cmocka_unit_test(test_lambert_by_a_ramp),
        cmocka_unit_test(test_zero_normal),
        cmocka_unit_test(test_garbage),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
