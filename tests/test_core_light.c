/*
 * test_core_light.c - the power table and the light at a normal against double precision.
 *
 * Tolerances in raw steps: s^n 20 of UQ1.15 (5.6e-4 by linear interpolation, n = 83, and the cut below 2^-16);
 * relative diffuse 5 of UQ1.15, one for each weight and one for L.N; relative specular 22 of UQ1.15: the table's 20,
 * and where the highlight fades, at L.N = 0, a step of L.N counts 8 times, but there the power counts less. Both more
 * by 1.5 / sum of the lights' intensities, which weights round.
 */
#include <string.h>

#include "test_core_worst.h"

#include "frame/frame.h"
#include "frame_stage.h"
#include "math/pose.h"

#define ONE 1073741824.0 /* Q1.30 */
#define WEIGHT(sum) (1.5 * 65536 / fmax(1, sum))

/* ---- s^n ---- */

static void test_powers(void **unused)
{
    struct worst worst = {0};

    (void)unused;
    for (int n = 1; n <= 128; n++) {
        struct sheen_shine shine;
        uint32_t last = 32768;
        assert_int_equal(sheen_shine_make(&shine, (unsigned)n), SHEEN_OK);
        for (uint32_t u = 0; u <= 1u << 30; u += (1u << 14) + 7) { /* Q2.29: 1 - s from 0 to 2 */
            uint32_t power = power_at(power_of(&shine), (int32_t)u);
            double s = fmax(0, 1 - u / (ONE / 2));
            worst_note(&worst, power - pow(s, n) * 32768, "n %d, s %.9f", n, s);
            assert_true(power <= last);
            last = power;
        }
        assert_int_equal(power_at(power_of(&shine), 0), 32768);
        assert_int_equal(power_at(power_of(&shine), -1), 32768); /* rounding above 1 erases no highlight */
        assert_int_equal(power_at(power_of(&shine), INT32_MIN), 32768);
        assert_int_equal(power_at(power_of(&shine), INT32_MAX), 0);
    }
    worst_assert(&worst, 20, "s^n");
}

static void test_shininesses_out_of_range(void **unused)
{
    struct sheen_shine shine, before;

    (void)unused;
    assert_int_equal(sheen_shine_make(&shine, 128), SHEEN_OK);
    before = shine;
    assert_int_equal(sheen_shine_make(&shine, 0), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_shine_make(&shine, 129), SHEEN_ERR_ARGUMENT);
    assert_memory_equal(&shine, &before, sizeof shine);
}

/* The const ones are those that are made. */
static void test_const_shines(void **unused)
{
    static const struct sheen_shine *const shines[] = {&sheen_shine_4,  &sheen_shine_8,  &sheen_shine_16,
                                                       &sheen_shine_32, &sheen_shine_64, &sheen_shine_128};

    (void)unused;
    for (unsigned i = 0; i < sizeof shines / sizeof shines[0]; i++) {
        struct sheen_shine made;
        memset(&made, 0, sizeof made);
        assert_int_equal(sheen_shine_make(&made, 4u << i), SHEEN_OK);
        assert_memory_equal(&made, shines[i], sizeof made);
    }
}

/* ---- light at a normal ---- */

struct scene {
    struct sheen_object draw;
    struct sheen_light light[SHEEN_MAX_LIGHTS];
    struct sheen_shine shine;
    struct lighting lighting;
};

static int light_begin(struct scene *s)
{
    return sheen_light_begin(&s->lighting, s->draw.lights, s->draw.light_count, s->draw.pose.rotation, NULL,
                             LIGHTS_FAR);
}

static void random_scene(struct scene *s, uint32_t *state, unsigned lights)
{
    memset(s, 0, sizeof *s);
    assert_int_equal(sheen_shine_make(&s->shine, 1 + stage_random(state) % 128), SHEEN_OK);
    sheen_pose_orbit(&s->draw.pose, stage_random(state), stage_random(state), stage_random(state), SHEEN_Q24(3));
    s->draw.lights = s->light;
    s->draw.light_count = (uint8_t)lights;
    for (unsigned i = 0; i < lights; i++) {
        for (int k = 0; k < 3; k++)
            s->light[i].to[k] = (int32_t)stage_random(state) >> (stage_random(state) % 4);
        s->light[i].intensity = (int32_t)(4096 + stage_random(state) % (65536 - 4096 + 1));
        s->light[i].no_highlight = stage_random(state) % 4 == 0;
    }
    assert_int_equal(light_begin(s), SHEEN_OK);
}

/* The definition's light, relative to the sums of the intensities. `behind` counts lights with R.V > 0 and N.V < 0. */
static void exact_light(const struct scene *s, const int16_t normal[3], double *diffuse, double *specular, int *behind)
{
    double unit = sqrt((double)normal[0] * normal[0] + (double)normal[1] * normal[1] + (double)normal[2] * normal[2]);
    double n[3] = {normal[0] / unit, normal[1] / unit, normal[2] / unit};
    const sheen_q30_t *r = s->draw.pose.rotation;
    double seen[3], diffuse_sum = 0, specular_sum = 0;

    *diffuse = *specular = 0;
    for (int k = 0; k < 3; k++)
        seen[k] = (r[3 * k] * n[0] + r[3 * k + 1] * n[1] + r[3 * k + 2] * n[2]) / ONE;
    for (unsigned i = 0; i < s->draw.light_count; i++) {
        const struct sheen_light *light = &s->light[i];
        double length = sqrt((double)light->to[0] * light->to[0] + (double)light->to[1] * light->to[1] +
                             (double)light->to[2] * light->to[2]);
        double ln = (light->to[0] * seen[0] + light->to[1] * seen[1] + light->to[2] * seen[2]) / length;
        double rv = 2 * ln * seen[2] - light->to[2] / length, highlight = light->no_highlight ? 0 : light->intensity;
        diffuse_sum += light->intensity;
        specular_sum += highlight;
        if (ln <= 0)
            continue;
        *diffuse += light->intensity * ln;
        *specular += highlight * pow(fmin(1, fmax(0, rv)), s->shine.shininess) * fmin(1, 8 * ln);
        *behind += seen[2] < -0.1 && rv > 0.5;
    }
    *diffuse /= fmax(1, diffuse_sum);
    *specular /= fmax(1, specular_sum);
}

static void test_light_at_a_normal(void **unused)
{
    struct worst diffuse = {0}, specular = {0};
    uint32_t state = 1;
    int behind = 0, highlights = 0;

    (void)unused;
    for (unsigned i = 0; i < 4000; i++) {
        struct scene s;
        random_scene(&s, &state, i % (SHEEN_MAX_LIGHTS + 1));
        for (int k = 0; k < 64; k++) {
            int32_t v[3] = {(int32_t)stage_random(&state), (int32_t)stage_random(&state),
                            (int32_t)stage_random(&state)};
            sheen_q30_t unit[3];
            int16_t n[3];
            double exact_diffuse, exact_specular;
            struct lit lit;
            if (k % 4 == 0 && s.draw.light_count > 0) /* about halfway between light and eye: a highlight */
                for (int j = 0; j < 3; j++)
                    v[j] = s.lighting.to[0][j] / 2 + s.lighting.view[j] / 2 + v[j] / (8 << k / 4);
            assert_int_equal(sheen_normalize(v, unit), SHEEN_OK);
            for (int j = 0; j < 3; j++)
                n[j] = (int16_t)lrint(unit[j] / ONE * 32767);
            exact_light(&s, n, &exact_diffuse, &exact_specular, &behind);
            light_normal(&s.lighting, (struct power[]){power_of(&s.shine)}, n, &lit);
            worst_note(&diffuse, (lit.diffuse - exact_diffuse * 32768) / (5 + WEIGHT(s.lighting.diffuse_sum)),
                       "scene %u, normal %d", i, k);
            worst_note(&specular, (lit.specular - exact_specular * 32768) / (22 + WEIGHT(s.lighting.specular_sum)),
                       "scene %u, normal %d, n %d", i, k, s.shine.shininess);
            highlights += lit.specular > 16384;
        }
    }
    worst_assert(&diffuse, 1, "diffuse in tolerances");
    worst_assert(&specular, 1, "specular in tolerances");
    print_message("           R.V > 1/2 where N.V < 0: %d, highlights: %d\n", behind, highlights);
    assert_true(behind > 1000 && highlights > 10000);
}

static void test_a_zero_normal_has_no_light(void **unused)
{
    const int16_t zero[3] = {0, 0, 0};
    uint32_t state = 2;

    (void)unused;
    for (unsigned i = 0; i <= SHEEN_MAX_LIGHTS; i++) {
        struct scene s;
        struct lit lit = {1, 1};
        random_scene(&s, &state, i);
        light_normal(&s.lighting, (struct power[]){power_of(&s.shine)}, zero, &lit);
        assert_true(lit.diffuse == 0 && lit.specular == 0);
    }
}

/* Every 16-bit vector has a light in range, whatever its length. */
static void test_any_normal(void **unused)
{
    uint32_t state = 3;

    (void)unused;
    for (unsigned i = 0; i < 2000; i++) {
        struct scene s;
        random_scene(&s, &state, i % (SHEEN_MAX_LIGHTS + 1));
        for (int k = 0; k < 100; k++) {
            int16_t n[3];
            struct lit lit;
            for (int j = 0; j < 3; j++)
                n[j] = (int16_t)(k < 8 ? (k >> j & 1) != 0 ? 32767 : -32768 : (int)(int16_t)stage_random(&state));
            light_normal(&s.lighting, (struct power[]){power_of(&s.shine)}, n, &lit);
            assert_true(lit.diffuse <= 32768 && lit.specular <= 32768);
        }
    }
}

static void test_sums_and_weights(void **unused)
{
    uint32_t state = 4;

    (void)unused;
    for (unsigned i = 0; i < 20000; i++) {
        struct scene s;
        random_scene(&s, &state, i % (SHEEN_MAX_LIGHTS + 1));
        unsigned diffuse = 0, specular = 0;
        int32_t diffuse_sum = 0, specular_sum = 0;
        for (unsigned k = 0; k < s.draw.light_count; k++) {
            diffuse += s.lighting.diffuse_weight[k];
            specular += s.lighting.specular_weight[k];
            diffuse_sum += s.light[k].intensity;
            specular_sum += s.light[k].no_highlight ? 0 : s.light[k].intensity;
        }
        assert_int_equal(s.lighting.diffuse_sum, diffuse_sum);
        assert_int_equal(s.lighting.specular_sum, specular_sum);
        assert_true(diffuse <= 32768 && diffuse + 4 + WEIGHT(diffuse_sum) >= (diffuse_sum > 0 ? 32768 : 0));
        assert_true(specular <= 32768 && specular + 4 + WEIGHT(specular_sum) >= (specular_sum > 0 ? 32768 : 0));
    }
}

static void test_lights_out_of_range(void **unused)
{
    uint32_t state = 5;
    struct scene s;

    (void)unused;
    random_scene(&s, &state, 4);
    s.draw.light_count = 5;
    assert_int_equal(light_begin(&s), SHEEN_ERR_ARGUMENT);
    s.draw.light_count = 4;
    s.light[3].intensity = 65536;
    assert_int_equal(light_begin(&s), SHEEN_OK);
    s.light[3].intensity = 65537;
    assert_int_equal(light_begin(&s), SHEEN_ERR_ARGUMENT);
    s.light[3].intensity = -1;
    assert_int_equal(light_begin(&s), SHEEN_ERR_ARGUMENT);
    s.light[3].intensity = 0;
    memset(s.light[3].to, 0, sizeof s.light[3].to);
    assert_int_equal(light_begin(&s), SHEEN_ERR_DEGENERATE);
    s.draw.lights = NULL;
    assert_int_equal(light_begin(&s), SHEEN_ERR_ARGUMENT);
    s.draw.light_count = 0;
    assert_int_equal(light_begin(&s), SHEEN_OK);
}

/* View and object off by as much as allowed: a light in the model's space is at most 1.005 long, which does no harm. */
static void test_lights_turned_by_slack(void **unused)
{
    const double leans = (sqrt(1 + 2.99 / 1024) - 1) / 3; /* so that rows are off by 1/1024 in all products */
    const struct sheen_light light = {.to = {1, 1, 1}};
    struct sheen_pose slack = {.scale = 1 << 16}, both;
    struct lighting l;
    double length = 0;

    (void)unused;
    for (int k = 0; k < 9; k++)
        slack.rotation[k] = (int32_t)lrint(ONE * ((k % 4 == 0) + leans));
    assert_int_equal(sheen_pose_place(&slack, &slack, &both), SHEEN_OK);
    assert_int_equal(sheen_light_begin(&l, &light, 1, both.rotation, slack.rotation, LIGHTS_FAR), SHEEN_OK);
    for (int k = 0; k < 3; k++)
        length += pow(l.to[0][k] / ONE, 2);
    assert_true(length > 1.004 * 1.004 && length < 1.005 * 1.005);
    const int16_t normal[3] = {18918, 18918, 18918}, back[3] = {-18918, -18918, -18918};
    const double dot = 18918 * ((double)l.to[0][0] + l.to[0][1] + l.to[0][2]) / 65536;
    assert_true(fabs(dot_q29(normal, l.to[0]) - dot) < 4);
    assert_true(fabs(dot_q29(back, l.to[0]) + dot) < 4);
    assert_int_equal(sheen_unit_cosine(normal, lacking(normal), l.to[0]), 1 << 30);
    assert_int_equal(sheen_unit_cosine(back, lacking(back), l.to[0]), -(1 << 30));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lights_turned_by_slack),
        cmocka_unit_test(test_powers),
        cmocka_unit_test(test_shininesses_out_of_range),
        cmocka_unit_test(test_const_shines),
        cmocka_unit_test(test_light_at_a_normal),
        cmocka_unit_test(test_a_zero_normal_has_no_light),
        cmocka_unit_test(test_any_normal),
        cmocka_unit_test(test_sums_and_weights),
        cmocka_unit_test(test_lights_out_of_range),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
