/*
 * test_panel_first_light.c - the first-light picture, in plain memory against literals, then on every panel.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "sheen_first_light.h"
#include "test_panel_canvas.h"

/* Plain memory as a target: one value per pixel, unpacked. */
struct memory {
    uint16_t *values;
    uint16_t width;
    uint8_t pixel;
    unsigned pushes;
};

static uint16_t unpack(const uint8_t *row, unsigned bits, unsigned x)
{
    if (bits == 16)
        return (uint16_t)(row[2 * x] << 8 | row[2 * x + 1]);
    return (uint16_t)(row[x * bits / 8] >> (8 - bits - x * bits % 8) & ((1u << bits) - 1));
}

static int memory_push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    struct memory *memory = ctx;
    unsigned bits = sheen_pixel_bits((enum sheen_pixel)memory->pixel), width = (unsigned)(rect.x1 - rect.x0);

    memory->pushes++;
    for (int y = rect.y0; y < rect.y1; y++)
        for (unsigned x = 0; x < width; x++)
            memory->values[(unsigned)y * memory->width + (unsigned)rect.x0 + x] =
                unpack((const uint8_t *)pixels + (unsigned)(y - rect.y0) * ((width * bits + 7) / 8), bits, x);
    return 0;
}

/* First light of this size and format in plain memory, which the caller frees. */
static uint16_t *plain(uint16_t width, uint16_t height, uint8_t pixel, unsigned align)
{
    struct memory memory = {calloc((size_t)width * height, 2), width, pixel, 0};
    struct sheen_target target = {.ctx = &memory,
                                  .push = memory_push,
                                  .width = width,
                                  .height = height,
                                  .pixel = pixel,
                                  .align_x = (uint8_t)align,
                                  .align_y = (uint8_t)align};
    static uint8_t buffer[480 * 16 * 2];

    assert_non_null(memory.values);
    assert_int_equal(sheen_first_light(&target, buffer, sizeof buffer), 0);
    return memory.values;
}

/* 48x32: marks of 5 px, bars from (12, 8) to (36, 24). */
static const char *const small[32] = {
    "WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW", "W..............................................W",
    "W.RRRRR..................................GGGGG.W", "W.RRRRR..................................G...G.W",
    "W.RRRRR..................................G...G.W", "W.RRRRR..................................G...G.W",
    "W.RRRRR..................................GGGGG.W", "W..............................................W",
    "W...........RRRRRRRRGGGGGGGGBBBBBBBB...........W", "W...........RRRRRRRRGGGGGGGGBBBBBBBB...........W",
    "W...........RRRRRRRRGGGGGGGGBBBBBBBB...........W", "W...........RRRRRRRRGGGGGGGGBBBBBBBB...........W",
    "W...........RRRRRRRRGGGGGGGGBBBBBBBB...........W", "W...........RRRRRRRRGGGGGGGGBBBBBBBB...........W",
    "W...........RRRRRRRRGGGGGGGGBBBBBBBB...........W", "W...........RRRRRRRRGGGGGGGGBBBBBBBB...........W",
    "W...........000111222333444555666777...........W", "W...........000111222333444555666777...........W",
    "W...........000111222333444555666777...........W", "W...........000111222333444555666777...........W",
    "W...........000111222333444555666777...........W", "W...........000111222333444555666777...........W",
    "W...........000111222333444555666777...........W", "W...........000111222333444555666777...........W",
    "W..............................................W", "W.BBBBB..................................W...W.W",
    "W..BBBB...................................W.W..W", "W...BBB....................................W...W",
    "W....BB...................................W.W..W", "W.....B..................................W...W.W",
    "W..............................................W", "WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW",
};

/* RGB565 of the 8 greys 0, 36, 72, 109, 145, 182, 218, 255. */
static const uint16_t greys[8] = {0x0000, 0x2124, 0x4A49, 0x6B6D, 0x9492, 0xB5B6, 0xDEDB, 0xFFFF};

static uint16_t colour_of(char letter)
{
    switch (letter) {
    case 'W':
        return 0xFFFF;
    case 'R':
        return 0xF800;
    case 'G':
        return 0x07E0;
    case 'B':
        return 0x001F;
    case '.':
        return 0;
    default:
        return greys[letter - '0'];
    }
}

static void pattern_in_colour(void **state)
{
    uint16_t *values = plain(48, 32, SHEEN_RGB565_BE, 1);

    (void)state;
    for (unsigned y = 0; y < 32; y++)
        for (unsigned x = 0; x < 48; x++)
            if (values[y * 48 + x] != colour_of(small[y][x]))
                fail_msg("(%u, %u) is %04X, not %c", x, y, values[y * 48 + x], small[y][x]);
    free(values);
}

/* In 16 levels: white is 15, bars have their luminance, marks are white, the 8 greys are evenly spaced. */
static void pattern_in_grey(void **state)
{
    static const uint8_t steps[8] = {0, 2, 4, 6, 9, 11, 13, 15};
    uint16_t *values = plain(48, 32, SHEEN_GREY16, 2);

    (void)state;
    for (unsigned y = 0; y < 32; y++) {
        for (unsigned x = 0; x < 48; x++) {
            char letter = small[y][x];
            int bar = y >= 8 && y < 16 && x >= 12 && x < 36;
            unsigned expected = letter == '.'                    ? 0
                                : letter >= '0' && letter <= '7' ? steps[letter - '0']
                                : bar && letter == 'R'           ? 3
                                : bar && letter == 'G'           ? 11
                                : bar && letter == 'B'           ? 1
                                                                 : 15;

            assert_int_equal(values[y * 48 + x], expected);
        }
    }
    free(values);
}

/* Rows that end within a byte: a buffer for the core's rows suffices, and the border is in the right place. */
static void widths_that_fill_no_byte(void **state)
{
    (void)state;
    for (uint16_t width = 121; width < 138; width++) {
        for (int pixel = SHEEN_GREY2; pixel <= SHEEN_GREY256; pixel++) {
            unsigned per_byte = 8 / sheen_pixel_bits((enum sheen_pixel)pixel), white = (1u << 8 / per_byte) - 1;
            size_t bytes = 8 * ((width + per_byte - 1) / per_byte);
            struct memory memory = {calloc(width, 64 * 2), width, (uint8_t)pixel, 0};
            struct sheen_target target = {.ctx = &memory,
                                          .push = memory_push,
                                          .width = width,
                                          .height = 64,
                                          .pixel = (uint8_t)pixel,
                                          .align_x = 8,
                                          .align_y = 8};
            uint8_t *buffer = malloc(bytes); /* so that the sanitizer watches its end */

            assert_non_null(buffer);
            assert_int_equal(sheen_first_light(&target, buffer, bytes - 1), SHEEN_ERR_MEMORY);
            assert_int_equal(sheen_first_light(&target, buffer, bytes), SHEEN_OK);
            for (unsigned y = 0; y < 64; y++) {
                assert_int_equal(memory.values[y * width], white);
                assert_int_equal(memory.values[y * width + width - 1], white);
                assert_int_equal(memory.values[y * width + 1], y == 0 || y == 63 ? white : 0);
            }
            free(buffer);
            free(memory.values);
        }
    }
}

static void little_endian_and_errors(void **state)
{
    struct memory memory = {calloc(48 * 32, 2), 48, SHEEN_RGB565_LE, 0};
    struct sheen_target target = {
        .ctx = &memory, .push = memory_push, .width = 48, .height = 32, .pixel = SHEEN_RGB565_LE};
    uint8_t buffer[96 * 5];

    (void)state;
    assert_int_equal(sheen_first_light(&target, buffer, sizeof buffer), 0);
    assert_int_equal(memory.pushes, 7); /* bands of 5 rows */
    assert_int_equal(memory.values[2 * 48 + 2], 0x00F8);
    assert_int_equal(sheen_first_light(&target, buffer, 95), SHEEN_ERR_MEMORY);
    target.align_y = 8;
    assert_int_equal(sheen_first_light(&target, buffer, sizeof buffer), SHEEN_ERR_MEMORY);
    assert_int_equal(sheen_first_light(&target, NULL, 96), SHEEN_ERR_ARGUMENT);
    assert_int_equal(sheen_first_light(NULL, buffer, 96), SHEEN_ERR_ARGUMENT);
    free(memory.values);
}

static void every_panel_shows_it(void **state)
{
    const struct sheen_panel_record *record;
    static uint8_t buffer[480 * 16 * 2];
    struct canvas canvas;

    (void)state;
    for (size_t i = 0; (record = sheen_panel_at(i)); i++) {
        for (unsigned k = 0; k < 8; k++) {
            canvas_open(&canvas, record->name, (int)k, 0, 0);
            const struct sheen_target *target = canvas.target;

            free(canvas.ideal);
            canvas.ideal = plain(target->width, target->height, target->pixel, target->align_y);
            assert_int_equal(sheen_first_light(target, buffer, sizeof buffer), 0);
            if (canvas_differences(&canvas))
                fail_msg("%s, orientation %u: %u pixels differ", record->name, k, canvas_differences(&canvas));
            canvas_quiet(&canvas);
            canvas_close(&canvas);
        }
    }
}

static void errors_travel(void **state)
{
    static uint8_t buffer[480 * 16 * 2];
    struct canvas canvas;

    (void)state;
    canvas_open(&canvas, "ili9341", -1, 0, 0);
    sheen_sim_bus_fault(sheen_sim_panel_bus(canvas.panel), SHEEN_FAULT_TIMEOUT, 30);
    assert_int_equal(sheen_first_light(canvas.target, buffer, sizeof buffer), SHEEN_ERR_TIMEOUT);
    canvas_close(&canvas);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pattern_in_colour),        cmocka_unit_test(pattern_in_grey),
        cmocka_unit_test(widths_that_fill_no_byte), cmocka_unit_test(little_endian_and_errors),
        cmocka_unit_test(every_panel_shows_it),     cmocka_unit_test(errors_travel),
    };

    return cmocka_run_group_tests_name("panel_first_light", tests, NULL, NULL);
}
