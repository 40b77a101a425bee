/*
 * test_frame_ram.c - the memory for a sphere of 3,968 triangles at 320x240 is less than half of that size's
 * framebuffer.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "../host-sim/command/shadings.h"
#include "scenes.h"

#define LIMIT (60 * 1024) /* B, for arena and material tables, with bands of 16 rows and one buffer */

static void sphere_fits(void **state)
{
    (void)state;
    for (int shading = SHEEN_FLAT; shading <= SHEEN_SLERP; shading++) {
        struct bench bench;
        struct sheen_stats stats;
        bench_config(&bench, &bench_scenes[0], (enum sheen_shading)shading, 16);
        size_t arena_bytes = sheen_arena_size(&bench.config), bytes = arena_bytes + sizeof bench.material;
        assert_true(arena_bytes > 0 && bytes <= LIMIT);
        void *arena = malloc(arena_bytes);
        assert_non_null(arena);
        assert_int_equal(bench_begin(&bench, arena, arena_bytes), SHEEN_OK);
        assert_int_equal(bench_first(&bench), SHEEN_OK);
        assert_int_equal(bench_measured(&bench), SHEEN_OK);
        sheen_frame_stats(bench.frame, &stats);
        assert_int_equal(stats.triangles, 3968);
        assert_in_range(stats.front, 1230, 1260);
        assert_in_range(stats.drawn, 680, 900); /* most of its polygons are drawn as quads */
        print_message("  %u triangles, %u listed, in %zu B: arena %zu, tables %zu\n", stats.front, stats.drawn, bytes,
                      arena_bytes, sizeof bench.material);
        free(arena);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(sphere_fits)};

    return cmocka_run_group_tests_name("frame_ram", tests, NULL, NULL);
}
