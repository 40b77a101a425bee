/*
 * test_panel_off.c - switching panels off and on again, and the TE output.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "sheen_first_light.h"
#include "sim_panel.h"

static uint8_t band[480 * 8 * 2];

static uint16_t *light(struct sheen_sim_panel *panel, const struct sheen_sim_choice *choice)
{
    uint16_t *picture = calloc((size_t)choice->width * choice->height, sizeof *picture);

    assert_non_null(picture);
    assert_int_equal(sheen_first_light(sheen_sim_panel_target(panel), band, sizeof band), 0);
    assert_int_equal(sheen_sim_panel_picture(panel, picture), 0);
    return picture;
}

static size_t lit(const uint16_t *picture, size_t pixels)
{
    size_t count = 0;

    for (size_t i = 0; i < pixels; i++)
        count += picture[i] != 0;
    return count;
}

/* Every panel is dark after sheen_panel_off() and shows the same picture after the next push. */
static void off_is_dark_and_on_again_is_right(void **state)
{
    const struct sheen_panel_record *record;

    (void)state;
    for (size_t i = 0; (record = sheen_panel_at(i)) != NULL; i++) {
        struct sheen_sim_choice choice = {.record = record, .orientation = sheen_panel_default_orientation(record)};
        struct sheen_sim_panel *sim;
        uint16_t *before, *after, *dark;
        size_t pixels;

        sheen_panel_size(record, choice.orientation, &choice.width, &choice.height);
        pixels = (size_t)choice.width * choice.height;
        assert_int_equal(sheen_sim_panel_open(&sim, &choice), 0);
        before = light(sim, &choice);
        assert_true(lit(before, pixels) > pixels / 10);

        /* The target's ctx is the simulated panel's driver. */
        assert_int_equal(sheen_panel_off(sheen_sim_panel_target(sim)->ctx), 0);
        dark = calloc(pixels, sizeof *dark);
        assert_non_null(dark);
        assert_int_equal(sheen_sim_panel_picture(sim, dark), 0);
        assert_int_equal(lit(dark, pixels), 0);
        /* Switching off twice sends nothing the second time. */
        uint64_t sent = sheen_sim_bus_counters(sheen_sim_panel_bus(sim)).bytes;
        assert_int_equal(sheen_panel_off(sheen_sim_panel_target(sim)->ctx), 0);
        assert_true(sheen_sim_bus_counters(sheen_sim_panel_bus(sim)).bytes == sent);

        after = light(sim, &choice);
        assert_memory_equal(before, after, pixels * sizeof *before);
        assert_string_equal(sheen_sim_panel_complaint(sim), "");
        free(before);
        free(after);
        free(dark);
        sheen_sim_panel_close(sim);
    }
}

/* A bus that remembers only what was sent last. */
struct tail {
    uint8_t command, data[4];
    size_t count;
};

static int tail_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct tail *tail = ctx;

    if (commands)
        tail->command = command[0];
    tail->count = count;
    if (count)
        memcpy(tail->data, data, count < 4 ? count : 4);
    return 0;
}

static int tail_delay(void *ctx, uint32_t us)
{
    (void)ctx;
    (void)us;
    return 0;
}

static void tearing_is_switched_on_by_init(void **state)
{
    struct tail tail = {0};
    const struct sheen_bus bus = {.ctx = &tail, .send = tail_send, .delay = tail_delay};
    struct sheen_panel panel;

    (void)state;
    assert_int_equal(sheen_panel_open(&panel, sheen_panel_find("st7789-240x240"), &bus, 0), 0);
    assert_int_equal(sheen_panel_init(&panel), 0);
    assert_int_equal(tail.command, 0x29); /* without TE, display on is the last command */
    assert_int_equal(sheen_panel_tearing(&panel), 0);
    assert_int_equal(sheen_panel_init(&panel), 0);
    assert_int_equal(tail.command, 0x35);
    assert_int_equal(tail.count, 1);
    assert_int_equal(tail.data[0], 0);

    assert_int_equal(sheen_panel_open(&panel, sheen_panel_find("ssd1306-128x64"), &bus, 0), 0);
    assert_int_equal(sheen_panel_tearing(&panel), SHEEN_ERR_UNSUPPORTED);
}

/* A panel that is lit is made dark, though the next push is to initialise it again. */
static void off_after_tearing(void **state)
{
    struct tail tail = {0};
    const struct sheen_bus bus = {.ctx = &tail, .send = tail_send, .delay = tail_delay};
    struct sheen_panel panel;

    (void)state;
    assert_int_equal(sheen_panel_open(&panel, sheen_panel_find("st7789-240x240"), &bus, 0), 0);
    assert_int_equal(sheen_panel_off(&panel), 0);
    assert_int_equal(tail.command, 0); /* it was never lit */
    assert_int_equal(sheen_panel_init(&panel), 0);
    assert_int_equal(sheen_panel_tearing(&panel), 0);
    assert_int_equal(sheen_panel_off(&panel), 0);
    assert_int_equal(tail.command, 0x10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(off_is_dark_and_on_again_is_right),
        cmocka_unit_test(tearing_is_switched_on_by_init),
        cmocka_unit_test(off_after_tearing),
    };

    return cmocka_run_group_tests_name("panels off", tests, NULL, NULL);
}
