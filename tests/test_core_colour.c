/*
 * test_core_colour.c - from intensities to channels and pixels of every format.
 *
 * Tolerances: a channel (2^15 + 2) / 2^fraction levels, the rounding of two factors of UQ1.15 intensities, and 2^-15
 * of its highest level, that of material times lights; grey backgrounds exact but within 1/500 level of a tie, where
 * the weights' 16 bits decide; all else exact.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "frame/frame.h"
#include "frame_stage.h"

static const enum sheen_pixel pixels[] = {SHEEN_RGB565_BE, SHEEN_RGB565_LE, SHEEN_GREY2, SHEEN_GREY16, SHEEN_GREY256};
#define PIXELS (sizeof pixels / sizeof pixels[0])

static void format_of(struct pixel_format *format, enum sheen_pixel pixel)
{
    const struct sheen_target target = {.pixel = (uint8_t)pixel};

    sheen_format_begin(format, &target);
}

static double top_level(enum sheen_pixel pixel, int k)
{
    static const double weight[3] = {0.2126, 0.7152, 0.0722}, top565[3] = {31, 63, 31};
    double top = pixel == SHEEN_GREY2 ? 1 : pixel == SHEEN_GREY16 ? 15 : 255;

    return pixel <= SHEEN_RGB565_LE ? top565[k] : top * weight[k];
}

/* ---- terms ---- */

struct colour_case {
    struct sheen_material material;
    struct lighting light;
};

/* Every fourth case has everything at its most: ambient 4, diffuse and specular 4 under four lights. */
static void random_case(struct colour_case *c, uint32_t *state, int i)
{
    int most = i % 4 == 0;
    double range = i % 4 == 1 ? 4 : i % 4 == 2 ? 1 : 0.4;

    memset(c, 0, sizeof *c);
    for (int k = 0; k < 3; k++) {
        c->material.base[k] = (uint8_t)(most ? 255 : stage_random(state));
        c->material.highlight[k] = (uint8_t)(most ? 255 : stage_random(state));
    }
    c->material.ambient = most ? 4 << 16 : SHEEN_Q16(stage_uniform(state, 0, range));
    c->material.diffuse = most ? 4 << 16 : SHEEN_Q16(stage_uniform(state, 0, range));
    c->material.specular = most ? 4 << 16 : SHEEN_Q16(stage_uniform(state, 0, range));
    c->light.diffuse_sum = most ? 4 << 16 : (int32_t)(stage_random(state) % (4 << 16 | 1));
    c->light.specular_sum = most ? 4 << 16 : (int32_t)(stage_random(state) % (c->light.diffuse_sum + 1u));
}

static void note_terms(struct worst *worst, const struct colour_case *c, enum sheen_pixel pixel)
{
    const struct sheen_material *m = &c->material;
    struct pixel_format format;
    struct colour_terms t;
    uint64_t brightest = 0;

    format_of(&format, pixel);
    sheen_colour_begin(&t, &format, m, c->light.diffuse_sum, c->light.specular_sum);
    double one = ldexp(1, t.fraction), diffuse = m->diffuse / 65536. * c->light.diffuse_sum / 65536;
    double specular = m->specular / 65536. * c->light.specular_sum / 65536;
    for (int k = 0; k < 3; k++) {
        double top = top_level(pixel, k), base = top * m->base[k] / 255, highlight = top * m->highlight[k] / 255;
        for (uint32_t i = 0; i < 9; i++) {
            const struct lit lit = {i % 3 * 16384, i / 3 * 16384};
            uint64_t wide = t.a[k] + (uint64_t)t.b[k] * lit.diffuse + (uint64_t)t.c[k] * lit.specular;
            double exact = base * (m->ambient / 65536. + diffuse * (i % 3) / 2) + highlight * specular * (i / 3) / 2;
            assert_true(wide + (1u << (t.fraction - 1)) < 1u << 31); /* with the half of the rounding */
            assert_true(wide == colour_channel(&t, k, &lit));
            /* 565 tops are exact, grey ones hold their weights in 16 bits; a byte of colour is within 2^-17 of 1.0 */
            double colour = top * 0x1p-17 * ((m->ambient + 65536 * diffuse + 65536 * specular) / 65536);
            worst_note(worst,
                       (wide / one - exact) / (32770 / one + top * 0x1p-15 + colour + exact * 0x1p-12 * format.grey),
                       "channel %d, pixel %d", k, pixel);
        }
        worst_note(worst, (t.top[k] / one - top) / (1 / one + 0x1p-8 * format.grey), "top of channel %d, pixel %d", k,
                   pixel);
        uint64_t most = t.a[k] + ((uint64_t)t.b[k] + t.c[k]) * 32768;
        brightest += most;
        /* what is not clamped rounds to a level that there is */
        assert_true(t.clamp || (most + (1u << (t.fraction - 1))) >> t.fraction <= ceil(top));
        assert_true(!t.clamp || format.grey || t.fraction <= 25);
    }
    if (format.grey) /* the three are summed, each up to its top, with a threshold below 1 */
        assert_true((uint64_t)t.top[0] + t.top[1] + t.top[2] + (1u << t.fraction) <= UINT32_MAX);
    assert_true(brightest < UINT64_C(3) << 31);
}

static void test_terms(void **unused)
{
    struct worst worst = {0};
    uint32_t state = 1;

    (void)unused;
    for (int i = 0; i < 20000; i++) {
        struct colour_case c;
        random_case(&c, &state, i);
        for (size_t p = 0; p < PIXELS; p++)
            note_terms(&worst, &c, pixels[p]);
    }
    worst_assert(&worst, 1, "channels in tolerances");
}

/* Intensities that sum to at most 1 need no clamp; the least above half a level does. */
static void test_clamp(void **unused)
{
    struct colour_case c = {{.base = {255, 255, 255}, .highlight = {255, 255, 255}},
                            {.diffuse_sum = 65536, .specular_sum = 65536}};
    struct pixel_format format;
    struct colour_terms t;

    (void)unused;
    for (size_t p = 0; p < PIXELS; p++) {
        format_of(&format, pixels[p]);
        c.material.ambient = SHEEN_Q16(0.25);
        c.material.diffuse = SHEEN_Q16(0.5);
        c.material.specular = SHEEN_Q16(0.25);
        sheen_colour_begin(&t, &format, &c.material, c.light.diffuse_sum, c.light.specular_sum);
        assert_int_equal(t.clamp, 0);
        c.material.specular += 65536 / 32;
        sheen_colour_begin(&t, &format, &c.material, c.light.diffuse_sum, c.light.specular_sum);
        assert_int_equal(t.clamp, 1);
    }
}

/* ---- pixels ---- */

static unsigned value_565(uint16_t stored, enum sheen_pixel pixel)
{
    uint8_t byte[2];

    memcpy(byte, &stored, 2);
    return pixel == SHEEN_RGB565_BE ? (unsigned)byte[0] << 8 | byte[1] : (unsigned)byte[1] << 8 | byte[0];
}

static void test_colours_on_565(void **unused)
{
    (void)unused;
    for (size_t p = 0; p < 2; p++) {
        struct pixel_format format;
        format_of(&format, pixels[p]);
        for (unsigned v = 0; v < 256; v++) {
            const uint8_t rgb[3] = {(uint8_t)v, (uint8_t)(255 - v), (uint8_t)(v * 7)};
            unsigned r = (31 * 2u * rgb[0] + 255) / 510, g = (63 * 2u * rgb[1] + 255) / 510,
                     b = (31 * 2u * rgb[2] + 255) / 510;
            assert_int_equal(value_565(sheen_colour_pixel(&format, rgb), pixels[p]), r << 11 | g << 5 | b);
        }
    }
}

static void test_colours_on_grey(void **unused)
{
    (void)unused;
    for (size_t p = 2; p < PIXELS; p++) {
        struct pixel_format format;
        unsigned top = pixels[p] == SHEEN_GREY2 ? 1 : pixels[p] == SHEEN_GREY16 ? 15 : 255, ties = 0;
        format_of(&format, pixels[p]);
        for (uint32_t i = 0; i < 1u << 24; i += 13) {
            const uint8_t rgb[3] = {(uint8_t)i, (uint8_t)(i >> 8), (uint8_t)(i >> 16)};
            double exact = top * (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]) / 255;
            double level = floor(exact + 0.5), from_tie = fabs(exact - floor(exact) - 0.5);
            if (from_tie < 0.002)
                ties++;
            else
                assert_true(sheen_colour_pixel(&format, rgb) == level);
        }
        assert_true(ties < (1u << 24) / 13 / 100);
        const uint8_t black[3] = {0, 0, 0}, white[3] = {255, 255, 255};
        assert_int_equal(sheen_colour_pixel(&format, black), 0);
        assert_int_equal(sheen_colour_pixel(&format, white), top);
    }
}

/* B8 from [[0, 2], [3, 1]] by [[4 B, 4 B + 2], [4 B + 3, 4 B + 1]]. */
static unsigned bayer(unsigned size, unsigned x, unsigned y)
{
    static const unsigned quarter[2][2] = {{0, 2}, {3, 1}};

    if (size == 1)
        return 0;
    unsigned half = size / 2;
    return 4 * bayer(half, x % half, y % half) + quarter[y / half][x / half];
}

/* Held to the levels as wholes: below 0, within, and up to what two times 1.0 and a threshold make. */
static void test_held_channels(void **unused)
{
    const int32_t whole[8] = {-1, 0, 1, 30, 31, 32, 62, 126}, part[3] = {0, 1 << 23, (1 << 24) - 1};

    (void)unused;
    for (unsigned i = 0; i < 8 * 8 * 8; i++)
        for (unsigned k = 0; k < 3; k++) {
            const int32_t r = whole[i % 8], g = whole[i / 8 % 8], b = whole[i / 64];
            const int32_t held = max32(0, min32(r, 31)) << 11 | max32(0, min32(g, 63)) << 5 | max32(0, min32(b, 31));
            const int32_t one = 1 << LOOP_FRACTION;
            assert_int_equal(clamped_565((uint32_t)(r * one + part[k]), (uint32_t)(g * one + part[k]),
                                         (uint32_t)(b * one + part[k]), 1),
                             held);
            if (r >= 0 && g >= 0 && b >= 0)
                assert_int_equal(clamped_565((uint32_t)(r * one + part[k]), (uint32_t)(g * one + part[k]),
                                             (uint32_t)(b * one + part[k]), 0),
                                 held);
        }
}

static void test_thresholds(void **unused)
{
    const struct tile tile = {.thresholds = sheen_thresholds};

    (void)unused;
    for (int32_t y = 0; y < 20; y++)
        for (unsigned x = 0; x < 8; x++) {
            const unsigned b = bayer(8, x, (unsigned)y % 8), reversed = 16 * (b % 4) + 4 * (b / 4 % 4) + b / 16;
            assert_int_equal(sheen_reversed_thresholds[(uint32_t)y % 8][x], 2 * reversed + 1);
            assert_int_equal(sheen_reversed_thresholds[NO_DITHER][x], 64);
            assert_int_equal(threshold_row(&tile, 1, y)[x], 2 * bayer(8, x, (unsigned)y % 8) + 1);
            assert_int_equal(threshold_row(&tile, 0, y)[x], 64);
        }
}

static void test_packing(void **unused)
{
    uint32_t state = 2;

    (void)unused;
    for (size_t p = 2; p < PIXELS; p++)
        for (unsigned width = 1; width < 40; width++) {
            struct pixel_format format;
            uint8_t level[40 * 3], packed[40 * 3];
            const unsigned rows = 3;
            format_of(&format, pixels[p]);
            unsigned bits = sheen_pixel_bits(pixels[p]), row_bytes = (width * bits + 7) / 8;
            for (unsigned i = 0; i < width * rows; i++)
                level[i] = (uint8_t)(stage_random(&state) >> (32 - bits));
            memcpy(packed, level, sizeof packed);
            sheen_pack_grey(&format, packed, width, rows);
            for (unsigned y = 0; y < rows; y++) {
                for (unsigned x = 0; x < width; x++) {
                    unsigned bit = x * bits, byte = packed[y * row_bytes + bit / 8];
                    assert_int_equal(byte >> (8 - bits - bit % 8) & ((1u << bits) - 1), level[y * width + x]);
                }
                if (width * bits % 8 != 0) /* what is left of the row's last byte is 0 */
                    assert_int_equal(packed[y * row_bytes + row_bytes - 1] & (0xffu >> width * bits % 8), 0);
            }
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_terms),          cmocka_unit_test(test_clamp),
        cmocka_unit_test(test_colours_on_565), cmocka_unit_test(test_colours_on_grey),
        cmocka_unit_test(test_held_channels),  cmocka_unit_test(test_thresholds),
        cmocka_unit_test(test_packing),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
