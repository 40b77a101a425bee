/*
 * test_pin_watcher.c - the watcher that decodes pin edges in other tests, itself tested with edges as literals, against
 * what a panel would understand and the violations that it has to report.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "pin_watcher.h"
#include "sheen_target.h"

/* A controller that writes down what it gets: "C2a D01 R0 R1 ". */
struct scribe {
    struct sheen_bus bus;
    char text[256];
    int refuse; /* the code that send returns */
};

static int scribe_send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    struct scribe *scribe = ctx;
    size_t used = strlen(scribe->text);

    for (size_t i = 0; i < commands + count; i++)
        used += (size_t)snprintf(scribe->text + used, sizeof scribe->text - used, "%c%02x ", i < commands ? 'C' : 'D',
                                 i < commands ? command[i] : ((const uint8_t *)data)[i - commands]);
    return scribe->refuse;
}

static int scribe_reset(void *ctx, int level)
{
    struct scribe *scribe = ctx;
    size_t used = strlen(scribe->text);

    snprintf(scribe->text + used, sizeof scribe->text - used, "R%d ", level);
    return 0;
}

static struct scribe scribe;
static struct sheen_pin_watcher watcher;

/* Starts with CS and RESET high, and the clock at its mode's idle level. */
static void start(unsigned mode)
{
    const uint8_t idle[SHEEN_WIRE_COUNT] = {(uint8_t)(mode >> 1), 0, 1, 0, 1};

    memset(&scribe, 0, sizeof scribe);
    scribe.bus.ctx = &scribe;
    scribe.bus.send = scribe_send;
    scribe.bus.reset = scribe_reset;
    sheen_pin_watcher_init(&watcher, &scribe.bus, mode, idle);
}

/*
 * Plays edges. A lower-case letter drives a wire low, upper case high: k clock, m MOSI, s chip select, d D/C, r RESET;
 * blanks are only for readability. Returns the first negative code.
 */
static int play(const char *edges)
{
    static const char names[] = "kmsdr";
    int first = 0;

    for (; *edges; edges++) {
        const char *low = strchr(names, *edges | 0x20);
        int code;

        if (*edges == ' ')
            continue;
        assert_non_null(low);
        code = sheen_pin_watcher_edge(&watcher, (enum sheen_wire)(low - names), !(*edges & 0x20));
        if (code < 0 && first == 0)
            first = code;
    }
    return first;
}

static void high_bit_comes_first(void **state)
{
    (void)state;
    start(0);
    /* 0x2a = 0010 1010 with D/C low, then 0x81 with D/C high, in one selection. */
    assert_int_equal(play("s d mKk mKk MKk mKk MKk mKk MKk mKk"), 0);
    assert_int_equal(play("D MKk mKk mKk mKk mKk mKk mKk MKk S"), 0);
    assert_int_equal(sheen_pin_watcher_finish(&watcher), 0);
    assert_string_equal(scribe.text, "C2a D81 ");
    assert_int_equal(watcher.selections, 1);
    assert_int_equal(watcher.bytes[SHEEN_SIM_COMMAND], 1);
    assert_int_equal(watcher.bytes[SHEEN_SIM_DATA], 1);
}

static void unchanged_levels_are_no_edges(void **state)
{
    (void)state;
    start(0);
    assert_int_equal(play("ss d MMKKkk mmKKkk mKKKk mKk mKk mKk mKk MKk rR"), 0);
    /* rR is a real reset; repeated levels are no edges. */
    assert_string_equal(scribe.text, "C81 R0 R1 ");
    assert_int_equal(watcher.resets, 1);
}

static void each_mode_samples_on_its_edge(void **state)
{
    (void)state;
    /* MOSI holds the bit only around the sampling edge; at the other edge it holds the inverse. */
    start(0); /* idle low, sampled rising */
    assert_int_equal(play("s MKmk MKmk mKMk mKMk MKmk MKmk mKMk mKMk S"), 0);
    assert_string_equal(scribe.text, "Ccc ");
    start(1); /* idle low, sampled falling */
    assert_int_equal(play("s mKMk mKMk MKmk MKmk mKMk mKMk MKmk MKmk S"), 0);
    assert_string_equal(scribe.text, "Ccc ");
    start(2); /* idle high, sampled falling */
    assert_int_equal(play("s MkmK MkmK mkMK mkMK MkmK MkmK mkMK mkMK S"), 0);
    assert_string_equal(scribe.text, "Ccc ");
    start(3); /* idle high, sampled rising */
    assert_int_equal(play("s mkMK mkMK MkmK MkmK mkMK mkMK MkmK MkmK S"), 0);
    assert_string_equal(scribe.text, "Ccc ");
}

static void an_unselected_panel_hears_nothing(void **state)
{
    (void)state;
    start(0);
    assert_int_equal(play("MKkKkKkKkKkKkKkKk s mKkKkKkKk mKkKkKk MKk S KkKk"), 0);
    assert_string_equal(scribe.text, "C01 ");
    assert_int_equal(sheen_pin_watcher_finish(&watcher), 0);
}

static void a_wire_that_is_not_there_stays(void **state)
{
    const uint8_t idle[SHEEN_WIRE_COUNT] = {0, 0, 0, 0, 1};

    (void)state;
    start(0);
    sheen_pin_watcher_init(&watcher, &scribe.bus, 0, idle); /* CS tied low */
    assert_int_equal(play("D MKkKkKkKk mKkKkKkKk"), 0);
    assert_string_equal(scribe.text, "Df0 ");
}

static void select_must_not_cut_a_byte(void **state)
{
    (void)state;
    start(0);
    assert_int_equal(play("s KkKkKk S"), SHEEN_ERR_BUS);
    assert_string_equal(watcher.complaint, "CS rose inside a byte");
    /* What follows counts as a new byte. */
    assert_int_equal(play("s MKkKkKkKkKkKkKkKk"), 0);
    assert_string_equal(scribe.text, "Cff ");
    assert_int_equal(sheen_pin_watcher_finish(&watcher), SHEEN_ERR_BUS); /* the complaint stays */
}

static void dc_must_hold_for_a_byte(void **state)
{
    (void)state;
    start(0);
    assert_int_equal(play("s d KkKkKk D KkKkKkKkKk"), SHEEN_ERR_BUS);
    assert_string_equal(watcher.complaint, "D/C changed inside a byte");
    /* Between bytes it may change, selected or not. */
    start(0);
    assert_int_equal(play("s d KkKkKkKkKkKkKkKDk KkKkKkKkKkKkKkKk S d s S"), 0);
    assert_string_equal(scribe.text, "C00 D00 ");
}

static void reset_must_not_cut_a_byte_nor_hide_one(void **state)
{
    (void)state;
    start(0);
    assert_int_equal(play("s KkKk r"), SHEEN_ERR_BUS);
    assert_string_equal(watcher.complaint, "RESET fell inside a byte");
    start(0);
    assert_int_equal(play("r s Kk"), SHEEN_ERR_BUS);
    assert_string_equal(watcher.complaint, "bits clocked while RESET is low");
}

static void the_end_is_checked(void **state)
{
    (void)state;
    start(0);
    assert_int_equal(play("s S"), 0);
    assert_int_equal(sheen_pin_watcher_finish(&watcher), SHEEN_ERR_BUS);
    assert_string_equal(watcher.complaint, "no byte was sent");
    start(0);
    assert_int_equal(play("s KkKkKkKkKkKkKkKk Kk"), 0);
    assert_int_equal(sheen_pin_watcher_finish(&watcher), SHEEN_ERR_BUS);
    assert_string_equal(watcher.complaint, "the trace ends inside a byte");
}

static void the_controllers_error_travels(void **state)
{
    (void)state;
    start(0);
    scribe.refuse = SHEEN_ERR_UNSUPPORTED;
    assert_int_equal(play("s KkKkKkKkKkKkKkKk S"), SHEEN_ERR_UNSUPPORTED);
    assert_null(watcher.complaint);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(high_bit_comes_first),
        cmocka_unit_test(unchanged_levels_are_no_edges),
        cmocka_unit_test(each_mode_samples_on_its_edge),
        cmocka_unit_test(an_unselected_panel_hears_nothing),
        cmocka_unit_test(a_wire_that_is_not_there_stays),
        cmocka_unit_test(select_must_not_cut_a_byte),
        cmocka_unit_test(dc_must_hold_for_a_byte),
        cmocka_unit_test(reset_must_not_cut_a_byte_nor_hide_one),
        cmocka_unit_test(the_end_is_checked),
        cmocka_unit_test(the_controllers_error_travels),
    };

    return cmocka_run_group_tests_name("pin watcher", tests, NULL, NULL);
}
