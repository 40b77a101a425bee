/*
 * test_sender.c - the sending thread: order, errors, and buffers that are the caller's again after a wait.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "sheen_sender.h"
#include "sheen_target.h"

/* A slow bus that remembers what it was given and fails at one of its calls. */
struct slow {
    struct sheen_bus bus;
    uint8_t seen[100000];
    size_t count;
    unsigned calls, fail_at; /* the call that fails, 1 is the first; 0: none */
    int wait_error;
    pthread_t last; /* the thread of the last call */
    int levels;
};

static struct slow slow;
static struct sheen_sender sender;

static int slow_send(void *ctx, const uint8_t *command, size_t commands, const void *bytes, size_t count)
{
    const struct timespec while_sending = {.tv_nsec = 200000};

    (void)ctx;
    slow.last = pthread_self();
    if (++slow.calls == slow.fail_at)
        return SHEEN_ERR_TIMEOUT;
    for (size_t i = 0; i < commands; i++)
        slow.seen[slow.count++] = command[i];
    for (size_t half = 0; half < 2 && count; half++) {
        size_t from = half ? count / 2 : 0, to = half ? count : count / 2;

        memcpy(slow.seen + slow.count, (const uint8_t *)bytes + from, to - from);
        slow.count += to - from;
        nanosleep(&while_sending, NULL);
    }
    return 0;
}

static int slow_wait(void *ctx)
{
    (void)ctx;
    return slow.wait_error;
}

static int slow_reset(void *ctx, int level)
{
    (void)ctx;
    slow.levels = slow.levels << 1 | level;
    return 0;
}

static int slow_delay(void *ctx, uint32_t us)
{
    (void)ctx;
    return us == 7 ? SHEEN_ERR_BUS : 0;
}

static int set_up(void **state)
{
    (void)state;
    memset(&slow, 0, sizeof slow);
    slow.bus = (struct sheen_bus){.send = slow_send, .reset = slow_reset, .delay = slow_delay};
    return sheen_sender_open(&sender, &slow.bus);
}

static int tear_down(void **state)
{
    (void)state;
    sheen_sender_close(&sender);
    return 0;
}

static int put(const void *bytes, size_t count)
{
    return sender.layer.bus.send(sender.layer.bus.ctx, NULL, 0, bytes, count);
}

static int put_command(uint8_t command, const void *bytes, size_t count)
{
    return sender.layer.bus.send(sender.layer.bus.ctx, &command, 1, bytes, count);
}

static int collect(void)
{
    return sender.layer.bus.wait(sender.layer.bus.ctx);
}

/* 200 bands through two buffers, each filled while the other may be under way. */
static void bytes_arrive_in_order(void **state)
{
    static uint8_t buffer[2][300], expected[100000];
    size_t total = 0;

    (void)state;
    for (unsigned band = 0; band < 200; band++) {
        uint8_t *bytes = buffer[band % 2];
        uint8_t command = (uint8_t)band;

        for (size_t i = 0; i < sizeof buffer[0]; i++)
            bytes[i] = (uint8_t)(band * 7 + i * 13);
        assert_int_equal(collect(), 0);
        if (band % 2)
            assert_int_equal(put_command(command, NULL, 0), 0);
        assert_int_equal(collect(), 0);
        assert_int_equal(band % 2 ? put(bytes, sizeof buffer[0]) : put_command(command, bytes, sizeof buffer[0]), 0);
        expected[total++] = command;
        memcpy(expected + total, bytes, sizeof buffer[0]);
        total += sizeof buffer[0];
    }
    assert_int_equal(collect(), 0);
    assert_int_equal(slow.count, total);
    assert_memory_equal(slow.seen, expected, total);
    assert_true(sheen_sender_busy_ns(&sender) > 200 * 200000u);
    assert_true(sheen_sender_busy_ns(&sender) == 0);
}

static void long_data_leaves_on_the_other_thread(void **state)
{
    static const uint8_t bytes[1000];

    (void)state;
    assert_int_equal(put(bytes, 2), 0);
    assert_true(pthread_equal(slow.last, pthread_self()));
    assert_int_equal(put(bytes, sizeof bytes), 0);
    assert_int_equal(collect(), 0);
    assert_false(pthread_equal(slow.last, pthread_self()));
    assert_int_equal(put_command(0x2A, bytes, 4), 0);
    assert_true(pthread_equal(slow.last, pthread_self()));
}

static void an_error_comes_once_and_unchanged(void **state)
{
    static const uint8_t bytes[1000];

    (void)state;
    slow.fail_at = 2;
    assert_int_equal(put(bytes, sizeof bytes), 0);
    assert_int_equal(collect(), 0);
    assert_int_equal(put(bytes, sizeof bytes), 0); /* fails while under way */
    assert_int_equal(collect(), SHEEN_ERR_TIMEOUT);
    assert_int_equal(collect(), 0);
    slow.fail_at = 3;
    assert_int_equal(put_command(0, NULL, 0), SHEEN_ERR_TIMEOUT); /* fails at once */
    assert_int_equal(collect(), 0);
    slow.fail_at = 4;
    assert_int_equal(put(bytes, sizeof bytes), 0);
    assert_int_equal(put_command(0, NULL, 0), SHEEN_ERR_TIMEOUT); /* no error is lost if the caller forgets to wait */
    assert_int_equal(put_command(0, NULL, 0), 0);
}

static void the_inner_wait_counts(void **state)
{
    static const uint8_t bytes[1000];

    (void)state;
    slow.bus.wait = slow_wait;
    slow.wait_error = SHEEN_ERR_BUS;
    assert_int_equal(put(bytes, sizeof bytes), 0);
    assert_int_equal(collect(), SHEEN_ERR_BUS);
}

static void reset_and_delay_pass(void **state)
{
    (void)state;
    assert_int_equal(sender.layer.bus.reset(sender.layer.bus.ctx, 1), 0);
    assert_int_equal(sender.layer.bus.reset(sender.layer.bus.ctx, 0), 0);
    assert_int_equal(slow.levels, 2);
    assert_int_equal(sender.layer.bus.delay(sender.layer.bus.ctx, 7), SHEEN_ERR_BUS);
    slow.bus.reset = NULL;
    sheen_sender_close(&sender);
    assert_int_equal(sheen_sender_open(&sender, &slow.bus), 0);
    assert_null(sender.layer.bus.reset);
}

static void closing_waits_for_the_last_call(void **state)
{
    static const uint8_t bytes[1000];

    (void)state;
    assert_int_equal(put(bytes, sizeof bytes), 0);
    sheen_sender_close(&sender);
    assert_int_equal(slow.count, sizeof bytes);
    assert_int_equal(sheen_sender_open(&sender, &slow.bus), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(bytes_arrive_in_order, set_up, tear_down),
        cmocka_unit_test_setup_teardown(long_data_leaves_on_the_other_thread, set_up, tear_down),
        cmocka_unit_test_setup_teardown(an_error_comes_once_and_unchanged, set_up, tear_down),
        cmocka_unit_test_setup_teardown(the_inner_wait_counts, set_up, tear_down),
        cmocka_unit_test_setup_teardown(reset_and_delay_pass, set_up, tear_down),
        cmocka_unit_test_setup_teardown(closing_waits_for_the_last_call, set_up, tear_down),
    };

    return cmocka_run_group_tests_name("sender", tests, NULL, NULL);
}
