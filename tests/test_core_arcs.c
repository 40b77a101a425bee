/*
 * test_core_arcs.c - great arcs by series, against sines in double precision.
 */
#include "test_core_worst.h"

#include "frame_stage.h"
#include "math/arc.h"
#include "sheen.h"

/* Every width up to a right angle; all the way in 1/128, and odd steps between. */
static void test_shares(void **unused)
{
    struct worst worst = {0};

    (void)unused;
    for (int32_t h = 0; h <= RIGHT_ANGLE; h++) {
        const double angle = 2 * asin(sqrt(h / 32768.0));
        struct arc_series series;
        sheen_arc_series(&series, h);
        for (int32_t t = h % 256; t <= 32768; t += 256) {
            const double exact = h == 0 ? t / 32768.0 : sin(t / 32768.0 * angle) / sin(angle);
            worst_note(&worst, arc_share(&series, t) - exact * 32768, "h %d, t %d", (int)h, (int)t);
        }
        assert_int_equal(arc_share(&series, 0), 0);
        assert_int_equal(arc_share(&series, 32768), 32768);
    }
    worst_assert(&worst, 1.9, "shares of an arc");
}

static double part_of(const double v[3], const double w[3])
{
    return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

/* A unit vector, as a mesh has it, and as it is then in double precision. */
static void any_normal(uint32_t *state, int16_t n[3], double unit[3])
{
    int32_t v[3];
    sheen_q30_t normal[3] = {0, 0, 1 << 30};

    for (int i = 0; i < 3; i++)
        v[i] = (int32_t)stage_random(state) >> 1;
    (void)sheen_normalize(v, normal);
    for (int i = 0; i < 3; i++) {
        n[i] = (int16_t)lround(normal[i] / 1073741824.0 * 32767);
        unit[i] = n[i];
    }
    const double size = sqrt(part_of(unit, unit));
    for (int i = 0; i < 3; i++)
        unit[i] /= size;
}

static void arc_at(const struct arc *arc, int32_t t, int32_t n[3])
{
    struct arc_blend blend;

    arc_blend_at(arc, t, &blend);
    for (int i = 0; i < 3; i++)
        n[i] = blended_part(&blend, i);
}

/* Arcs of any width, also of more than a right angle, which is cut at its middle. */
static void test_arcs_of_any_width(void **unused)
{
    struct worst worst = {0}, length = {0};
    uint32_t state = 5;

    (void)unused;
    for (int round = 0; round < 200000; round++) {
        int16_t end[2][3];
        double a[3], b[3], exact[3], got[3];
        const int32_t t = (int32_t)(stage_random(&state) % 32769);
        int32_t n[3];
        struct arc arc;
        any_normal(&state, end[0], a);
        any_normal(&state, end[1], b);
        const double angle = acos(fmax(-1, fmin(1, part_of(a, b))));
        if (angle > 3.0 || angle < 0.01) /* near opposite ends the arc's plane is that of their rounding */
            continue;
        sheen_arc_begin(&arc, end[0], end[1]);
        arc_at(&arc, t, n);
        for (int i = 0; i < 3; i++) {
            exact[i] = (sin((1 - t / 32768.0) * angle) * a[i] + sin(t / 32768.0 * angle) * b[i]) / sin(angle);
            got[i] = n[i] / 32767.0;
        }
        for (int i = 0; i < 3; i++)
            worst_note(&worst, (got[i] - exact[i]) * 32768, "angle %.3f, t %d", angle, (int)t);
        worst_note(&length, (sqrt(part_of(got, got)) - 1) * 32768, "angle %.3f, t %d", angle, (int)t);
    }
    worst_assert(&worst, 7, "parts of a normal on an arc");
    worst_assert(&length, 7, "its length");
}

/* Ends that all but agree are no obtuse arc. */
static void test_close_ends(void **unused)
{
    uint32_t state = 7;

    (void)unused;
    for (int round = 0; round < 20000; round++) {
        int16_t end[2][3];
        double unit[3];
        struct arc arc;
        any_normal(&state, end[0], unit);
        for (int i = 0; i < 3; i++) {
            const int part = end[0][i] + (int)(stage_random(&state) % 5) - 2;
            end[1][i] = (int16_t)(part > 32767 ? 32767 : part < -32767 ? -32767 : part);
        }
        sheen_arc_begin(&arc, end[0], end[1]);
        assert_int_equal(arc.parts, 1);
        assert_in_range(arc.h, 0, 1);
    }
}

static void test_opposite_ends(void **unused)
{
    static const int16_t up[3] = {0, 0, 32767}, down[3] = {0, 0, -32767};
    struct arc arc;
    int32_t n[3];

    (void)unused;
    sheen_arc_begin(&arc, up, down);
    arc_at(&arc, (1 << 14) - 1, n);
    assert_int_equal(n[2], 32767);
    arc_at(&arc, 1 << 14, n);
    assert_int_equal(n[2], -32767);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shares),
        cmocka_unit_test(test_arcs_of_any_width),
        cmocka_unit_test(test_close_ends),
        cmocka_unit_test(test_opposite_ends),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
