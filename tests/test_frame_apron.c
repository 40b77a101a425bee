/*
 * test_frame_apron.c - tiles with an apron, which a frame with lines of edges has, where the rectangles of two bands do
 * not meet: an object ends near the border of the bands, another one begins near it or far below, and lines are
 * somewhere else. What was carried for the apron alone MUST NOT be drawn in the next tile, which has no such rows.
 *
 * A row drawn above a tile lands in the other buffer, which is being sent then, so that the target complains; or in
 * the set-ups and depths before the buffers, so that the picture differs from that of one band.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "core_picture.h"

#define WIDTH 64 /* px */
#define HEIGHT 64
#define BAND 16 /* rows */
#define DEPTH 2 /* units, of everything */

/* A rectangle of px as a mesh of two triangles, for the view below. */
struct block {
    int16_t positions[3 * 4];
    struct sheen_mesh mesh;
};

static const uint8_t indices[6] = {0, 1, 2, 0, 2, 3};
static const uint16_t polygons[2] = {0, 0};
static const struct sheen_triangle_edges edges[2] = {{{SHEEN_NO_TRIANGLE, SHEEN_NO_TRIANGLE, 1}, 3, 4},
                                                     {{0, SHEEN_NO_TRIANGLE, SHEEN_NO_TRIANGLE}, 6, 1}};

static void block_make(struct block *b, int x0, int y0, int x1, int y1)
{
    const int x[4] = {x0, x1, x1, x0}, y[4] = {y1, y1, y0, y0};

    for (int k = 0; k < 4; k++) { /* 2 units are HEIGHT px and 32768 */
        b->positions[3 * k] = (int16_t)((2 * x[k] - WIDTH) * 16384 / HEIGHT);
        b->positions[3 * k + 1] = (int16_t)((HEIGHT - 2 * y[k]) * 16384 / HEIGHT);
        b->positions[3 * k + 2] = 0;
    }
    b->mesh = (struct sheen_mesh){.positions = b->positions,
                                  .polygons = polygons,
                                  .indices = indices,
                                  .index_bytes = 1,
                                  .vertices = 4,
                                  .triangles = 2,
                                  .scale = SHEEN_Q24(2),
                                  .edges = edges};
}

static const struct sheen_view view = {.fov = SHEEN_DEGREES(90),
                                       .z_near = SHEEN_Q24(1),
                                       .z_far = SHEEN_Q24(3),
                                       .orthographic = SHEEN_Q24(1),
                                       .background = {0, 0, 80}};
static const struct sheen_material material = {
    .base = {250, 200, 20}, .ambient = SHEEN_Q16(1), .line = {255, 255, 255}};

/* The first two blocks without lines, the third one with them. */
static void draw(struct sheen_frame *frame, const struct block block[3])
{
    assert_int_equal(sheen_begin(frame, &view), SHEEN_OK);
    for (int i = 0; i < 3; i++) {
        struct sheen_object o = {.mesh = &block[i].mesh, .material = &material, .shader = &sheen_flat};
        o.pose.translation[2] = -SHEEN_Q24(DEPTH);
        o.edges = i == 2 ? &sheen_edges_outline : NULL;
        assert_int_equal(sheen_draw(frame, &o), SHEEN_OK);
    }
    assert_int_equal(sheen_end(frame), SHEEN_OK);
    assert_int_equal(sheen_wait(frame), SHEEN_OK);
}

/* Two frames, the second of which sends what the blocks touch alone. */
static void draw_twice(struct memory_target *t, const struct block block[3], int band_rows, uint8_t buffers)
{
    const struct sheen_config config = {.target = &t->target,
                                        .band_rows = (uint16_t)band_rows,
                                        .buffers = buffers,
                                        .max_vertices = 64,
                                        .max_triangles = 16,
                                        .max_draws = 3,
                                        .max_carried = 1,
                                        .max_edges = 32};
    struct core_frame f;

    assert_int_equal(memory_target_init(t, WIDTH, HEIGHT, SHEEN_GREY256), 0);
    t->delayed = true;
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    draw(f.frame, block);
    draw(f.frame, block);
    core_frame_free(&f);
}

static void check(int end, int begin, int lines, int width)
{
    struct memory_target banded, whole;
    struct block block[3];

    block_make(&block[0], 0, end - 3, width * 3 / 8, end);
    block_make(&block[1], 0, begin, width, begin + 4);
    block_make(&block[2], 0, lines, width, lines + 5);
    draw_twice(&banded, block, BAND, 2);
    draw_twice(&whole, block, HEIGHT, 1);
    if (banded.breaches > 0 || memcmp(banded.memory, whole.memory, banded.row_bytes * HEIGHT) != 0)
        fail_msg("a block ends at row %d, one begins at %d, lines from row %d on: %s", end, begin, lines,
                 banded.breaches > 0 ? banded.first_breach : "bands differ from the whole");
    memory_target_free(&banded);
    memory_target_free(&whole);
}

static void bands_that_do_not_meet(void **state)
{
    (void)state;
    for (int end = BAND - 12; end <= BAND + 3; end++)
        for (int begin = BAND - 3; begin < 2 * BAND; begin++)
            for (int width = 8; width <= WIDTH; width += 8) {
                check(end, begin, 2 * BAND + 4, width);
                check(end, begin, 1, width);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bands_that_do_not_meet)};

    return cmocka_run_group_tests_name("frame_apron", tests, NULL, NULL);
}
