/*
 * test_demo.c - the firmware's scene takes the capacities that firmware/demo.c gives it, on pictures of any panel's
 * size, and not many fewer.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "demo.h"
#include "memory_target.h"

/* Within firmware/demo.c. */
#define MAX_FRONT 512
#define MAX_USED 380
#define MAX_CARRIED 60

static void capacities(void **state)
{
    static const int sizes[][2] = {{96, 64},   {128, 32},  {128, 64},  {128, 128}, {128, 160}, {240, 240},
                                   {240, 280}, {170, 320}, {240, 320}, {320, 240}, {320, 480}, {480, 320}};
    static uint64_t arena[16384];
    uint32_t front = 0, used = 0, carried = 0;

    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        struct memory_target target;
        struct demo demo;
        size_t size = sizeof arena;

        assert_int_equal(memory_target_init(&target, sizes[i][0], sizes[i][1], SHEEN_RGB565_BE), 0);
        assert_int_equal(demo_open(&demo, &target.target, arena, &size, 1, NULL), SHEEN_OK);
        for (int frame = 0; frame < 60; frame++) {
            struct sheen_stats stats;
            assert_int_equal(demo_frame(&demo, 0), SHEEN_OK);
            sheen_frame_stats(demo.frame, &stats);
            front = stats.drawn > front ? stats.drawn : front;
            used = stats.used > used ? stats.used : used;
            carried = stats.carried > carried ? stats.carried : carried;
        }
        memory_target_free(&target);
    }
    print_message("at most %u listed, %u used, %u carried\n", front, used, carried);
    assert_in_range(front, MAX_FRONT - 8, MAX_FRONT);
    assert_in_range(used, MAX_USED - 40, MAX_USED);
    assert_in_range(carried, MAX_CARRIED - 8, MAX_CARRIED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(capacities)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
