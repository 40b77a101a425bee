/*
 * test_core_bin.c - which triangles each band draws, and a roll-back that leaves no trace.
 *
 * All exact: against the boxes of the listed triangles' corners, one at a time.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "frame/frame.h"
#include "frame_stage.h"

#define WIDTH 160
#define HEIGHT 120
#define TRIANGLES 60

struct bin_case {
    struct memory_target target;
    struct core_frame frame;
    struct sheen_view view;
    struct sheen_material material;
    struct sheen_mesh mesh[3];
    int16_t position[3][9 * TRIANGLES];
    uint16_t index[3 * TRIANGLES];
};

static void case_make(struct bin_case *c, int band_rows, int align, int max_triangles)
{
    memset(c, 0, sizeof *c);
    assert_int_equal(memory_target_init(&c->target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    c->target.target.align_x = c->target.target.align_y = (uint8_t)align;
    const struct sheen_config config = {.target = &c->target.target,
                                        .band_rows = (uint16_t)band_rows,
                                        .max_vertices = 9 * TRIANGLES,
                                        .max_triangles = (uint16_t)max_triangles,
                                        .max_clipped = TRIANGLES,
                                        .clipper = &sheen_clipper};
    assert_int_equal(core_frame_make(&c->frame, &config), SHEEN_OK);
    for (int i = 0; i < 3 * TRIANGLES; i++)
        c->index[i] = (uint16_t)i;
}

static void case_free(struct bin_case *c)
{
    core_frame_free(&c->frame);
    memory_target_free(&c->target);
}

/* A mesh of triangles of all sizes, some beyond the picture and some beyond the near plane. */
static void random_mesh(struct bin_case *c, int which, uint32_t *state)
{
    for (int t = 0; t < TRIANGLES; t++) {
        double size = exp(stage_uniform(state, log(100), log(15000))), at[3];
        for (int k = 0; k < 3; k++)
            at[k] = stage_uniform(state, -17000, 17000);
        for (int i = 0; i < 9; i++)
            c->position[which][9 * t + i] = (int16_t)(at[i % 3] + stage_uniform(state, -size, size));
    }
    c->mesh[which] = (struct sheen_mesh){.positions = c->position[which],
                                         .indices = c->index,
                                         .index_bytes = 2,
                                         .vertices = 3 * TRIANGLES,
                                         .triangles = TRIANGLES,
                                         .scale = SHEEN_Q24(5)};
}

static int draw_mesh(struct bin_case *c, int which)
{
    struct sheen_object draw = {
        .mesh = &c->mesh[which], .material = &c->material, .shader = &sheen_flat, .two_sided = 1};

    sheen_pose_orbit(&draw.pose, 0, 0, 0, SHEEN_Q24(4));
    return sheen_draw(c->frame.frame, &draw);
}

/* ---- lists against boxes ---- */

/* Rows and columns of pixels whose centres lie in the box of an entry's corners, within the viewport. */
static struct sheen_rect box_of(const struct sheen_frame *f, uint32_t e)
{
    struct corners c;
    unsigned d = 0;
    int32_t low[2] = {INT32_MAX, INT32_MAX}, high[2] = {INT32_MIN, INT32_MIN};

    while (e >= f->draw[d].end_entry)
        d++;
    sheen_entry_corners(f, &f->draw[d], e, &c);
    for (int k = 0; k < 3; k++) {
        const int32_t at[2] = {c.v[k]->x + 32 * (f->viewport.x0 + f->viewport.x1),
                               c.v[k]->y + 32 * (f->viewport.y0 + f->viewport.y1)};
        for (int i = 0; i < 2; i++) {
            low[i] = min32(low[i], at[i]);
            high[i] = max32(high[i], at[i]);
        }
    }
    struct sheen_rect r = {INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN};
    for (int y = f->viewport.y0; y < f->viewport.y1; y++)
        for (int x = f->viewport.x0; x < f->viewport.x1; x++)
            if (64 * x + 32 >= low[0] && 64 * x + 32 < high[0] && 64 * y + 32 >= low[1] && 64 * y + 32 < high[1]) {
                r.x0 = (int16_t)min32(r.x0, x);
                r.y0 = (int16_t)min32(r.y0, y);
                r.x1 = (int16_t)max32(r.x1, x + 1);
                r.y1 = (int16_t)max32(r.y1, y + 1);
            }
    return r;
}

static void check_band(const struct sheen_frame *f, unsigned b, const struct sheen_rect *box)
{
    int top = f->viewport.y0 + (int)(b * f->config.band_rows), bottom = top + f->config.band_rows;
    unsigned listed = 0, expected = 0, back = 0;
    struct sheen_rect cover = {INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN};

    for (uint32_t e = 0; e < f->entries; e++) {
        expected += box[e].y0 >= top && box[e].y0 < bottom;
        if (box[e].y0 >= bottom || box[e].y1 <= top)
            continue;
        unsigned first = (unsigned)(box[e].y0 - f->viewport.y0) / f->config.band_rows;
        back = b - first > back ? b - first : back;
        cover.x0 = (int16_t)min32(cover.x0, box[e].x0);
        cover.y0 = (int16_t)min32(cover.y0, box[e].y0);
        cover.x1 = (int16_t)max32(cover.x1, box[e].x1);
        cover.y1 = (int16_t)max32(cover.y1, box[e].y1);
    }
    for (uint32_t e = f->band[b].first; e != NONE; e = f->entry[e].next) {
        assert_true(e < f->entries && box[e].y0 >= top && box[e].y0 < bottom);
        assert_true(f->entry[e].next == NONE || f->entry[e].next < e);
        listed++;
    }
    assert_int_equal(listed, expected);
    assert_int_equal(f->band[b].back, back);
    if (cover.x0 > cover.x1)
        assert_true(rect_empty(f->band[b].cover));
    else
        assert_memory_equal(&f->band[b].cover, &cover, sizeof cover);
}

static void check_lists(const struct sheen_frame *f)
{
    static struct sheen_rect box[2 * TRIANGLES * 4];

    assert_true(f->entries <= sizeof box / sizeof box[0]);
    for (uint32_t e = 0; e < f->entries; e++) {
        box[e] = box_of(f, e);
        assert_true(box[e].x0 < box[e].x1); /* what covers no centre is not listed */
    }
    for (unsigned b = 0; b < f->bands; b++)
        check_band(f, b, box);
}

static void test_lists(void **unused)
{
    static const int rows[] = {1, 7, 16, 40, 120};
    static struct bin_case c;
    uint32_t state = 1, entries = 0, pieces = 0;

    (void)unused;
    for (int i = 0; i < 20; i++) {
        case_make(&c, rows[i % 5], i % 2 != 0 ? 1 : 8, 4 * TRIANGLES);
        const struct sheen_frame *f = c.frame.frame;
        c.view = (struct sheen_view){.fov = SHEEN_DEGREES(60), .z_near = SHEEN_Q24(2.5), .z_far = SHEEN_Q24(5.5)};
        if (i % 4 >= 2)
            c.view.viewport = (struct sheen_rect){16, 8, 104, 112};
        assert_int_equal(sheen_begin(c.frame.frame, &c.view), SHEEN_OK);
        assert_int_equal(f->bands,
                         (unsigned)((i % 4 >= 2 ? 104 : HEIGHT) + f->config.band_rows - 1) / f->config.band_rows);
        for (int d = 0; d < 2; d++) {
            random_mesh(&c, d, &state);
            assert_int_equal(draw_mesh(&c, d), SHEEN_OK);
            check_lists(f);
        }
        entries += f->entries;
        pieces += f->pieces;
        assert_int_equal(sheen_end(c.frame.frame), SHEEN_OK);
        case_free(&c);
    }
    print_message("           %u listed, %u pieces\n", entries, pieces);
    assert_true(entries > 500 && pieces > 50);
}

/* ---- roll-back ---- */

/* All that a draw may change; of each array only the entries that are counted. */
struct trace {
    struct band band[HEIGHT];
    struct entry entry[4 * TRIANGLES];
    uint32_t cut[(4 * TRIANGLES + 31) / 32];
    struct piece piece[TRIANGLES];
    struct vertex vertex[9 * TRIANGLES];
    struct sheen_stats stats;
    uint16_t place[9 * TRIANGLES];
    uint32_t entries, pieces, vertices, used, draws;
};

static void trace_of(const struct sheen_frame *f, struct trace *t)
{
    memset(t, 0, sizeof *t);
    memcpy(t->band, f->band, f->bands * sizeof *f->band);
    memcpy(t->entry, f->entry, f->entries * sizeof *f->entry);
    memcpy(t->piece, f->piece, f->pieces * sizeof *f->piece);
    memcpy(t->vertex, f->vertex, f->used * sizeof *f->vertex);
    memcpy(t->place, f->place, f->vertices * sizeof *f->place);
    for (uint32_t e = 0; e < f->entries; e++)
        t->cut[e / 32] |= f->cut[e / 32] & 1u << e % 32;
    sheen_frame_stats(f, &t->stats);
    t->entries = f->entries;
    t->pieces = f->pieces;
    t->vertices = f->vertices;
    t->used = f->used;
    t->draws = f->draws;
}

/* For every capacity of triangles too small for the second mesh: the draw fails, and is as if it had never been. */
static void test_roll_back(void **unused)
{
    static struct bin_case c;
    static struct trace before, after;
    uint32_t state = 5, failed = 0;

    (void)unused;
    for (int room = 4 * TRIANGLES; room > 0; room -= 3) {
        case_make(&c, 16, 1, room);
        c.view = (struct sheen_view){.fov = SHEEN_DEGREES(60), .z_near = SHEEN_Q24(2.5), .z_far = SHEEN_Q24(5.5)};
        assert_int_equal(sheen_begin(c.frame.frame, &c.view), SHEEN_OK);
        random_mesh(&c, 0, &state);
        random_mesh(&c, 1, &state);
        c.mesh[0].triangles = (uint16_t)(1 + stage_random(&state) % 20);
        if (draw_mesh(&c, 0) == SHEEN_OK) {
            trace_of(c.frame.frame, &before);
            int error = draw_mesh(&c, 1);
            if (error < 0) {
                failed++;
                assert_int_equal(error, SHEEN_ERR_CAPACITY);
                trace_of(c.frame.frame, &after);
                assert_memory_equal(&before, &after, sizeof before);
                check_lists(c.frame.frame);
                c.mesh[1].triangles = 1; /* and the frame goes on */
                assert_in_range(draw_mesh(&c, 1) + 8, 8 + SHEEN_ERR_CAPACITY, 8);
                check_lists(c.frame.frame);
            }
        }
        assert_int_equal(sheen_end(c.frame.frame), SHEEN_OK);
        case_free(&c);
    }
    assert_true(failed > 10);
}

/* ---- rectangles ---- */

static int holds(struct sheen_rect r, int x, int y)
{
    return x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1;
}

static void test_rectangles(void **unused)
{
    (void)unused;
    for (int i = 0; i < 6 * 6 * 6 * 6; i++)
        for (int j = 0; j < 6 * 6 * 6 * 6; j += 7) {
            const struct sheen_rect a = {(int16_t)(i % 6), (int16_t)(i / 6 % 6), (int16_t)(i / 36 % 6),
                                         (int16_t)(i / 216)};
            const struct sheen_rect b = {(int16_t)(j % 6), (int16_t)(j / 6 % 6), (int16_t)(j / 36 % 6),
                                         (int16_t)(j / 216)};
            struct sheen_rect both = a, any = a;
            int meet = 0;
            sheen_rect_cut(&both, &b);
            sheen_rect_unite(&any, &b);
            for (int k = 0; k < 36; k++) {
                int in_a = holds(a, k % 6, k / 6), in_b = holds(b, k % 6, k / 6);
                meet |= in_a && in_b;
                assert_int_equal(holds(both, k % 6, k / 6), in_a && in_b);
                assert_true(holds(any, k % 6, k / 6) || !(in_a || in_b));
            }
            assert_true(meet || rect_empty(both));
            if (!rect_empty(a) && !rect_empty(b)) /* no larger than it has to be */
                assert_true(any.x0 == min32(a.x0, b.x0) && any.y0 == min32(a.y0, b.y0) && any.x1 == max32(a.x1, b.x1) &&
                            any.y1 == max32(a.y1, b.y1));
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lists),
        cmocka_unit_test(test_roll_back),
        cmocka_unit_test(test_rectangles),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
