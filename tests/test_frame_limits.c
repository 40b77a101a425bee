/*
 * test_frame_limits.c - memory and capacities: the size needed suffices, and one less is an error that changes nothing.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frame_test.h"

#define WIDTH 160
#define HEIGHT 120

/* ---- the arena ---- */

/* Every size below the one needed gives the same error, reports the size needed and writes nothing. */
static void every_arena_too_small(void **state)
{
    struct memory_target target;
    struct sheen_config config;

    (void)state;
    assert_int_equal(memory_target_init(&target, 32, 16, SHEEN_RGB565_BE), 0);
    config = (struct sheen_config){.target = &target.target,
                                   .band_rows = 4,
                                   .max_vertices = 20,
                                   .max_triangles = 30,
                                   .max_clipped = 4,
                                   .clipper = &sheen_clipper};
    size_t need = sheen_arena_size(&config);
    assert_true(need > 0);
    uint8_t *arena = malloc(need + 16);
    assert_non_null(arena);
    for (size_t size = 0; size < need; size++) {
        struct sheen_frame *frame = NULL;
        size_t told = size;
        memset(arena, 0xa5, need + 16);
        assert_int_equal(sheen_init(&frame, arena, &told, &config), SHEEN_ERR_MEMORY);
        assert_int_equal(told, need);
        assert_null(frame);
        for (size_t i = 0; i < need + 16; i++)
            assert_int_equal(arena[i], 0xa5);
    }
    free(arena);
    memory_target_free(&target);
}

/* The size needed suffices: nothing is written behind the arena, whatever is drawn. */
static void arena_is_kept_to(void **state)
{
    (void)state;
    for (int k = 0; k < 16; k++) {
        struct memory_target target;
        struct sheen_config config;
        struct sheen_frame *frame;
        struct sheen_view view;
        struct actor actors[2] = {{STAGE_TORUS, 0, (enum sheen_shading)(k % 4), 0, 0, 3, 2, 30, 40},
                                  {STAGE_BALL, 1, SHEEN_PHONG, 0, 0, 1.2, 0.6, 0, 20}};

        assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
        stage_config(&config, &target, 2);
        config.band_rows = (uint16_t)(1 + 13 * (k % 5));
        config.buffers = (uint8_t)(1 + k % 2);
        config.workers = (uint8_t)(1 + k / 4);
        config.max_carried = (uint16_t)(1 + k);
        config.max_clipped = 300;
        size_t need = sheen_arena_size(&config), size = need;
        uint8_t *arena = malloc(need); /* of exactly the size needed, so that the address sanitizer watches its ends */
        assert_int_equal(sheen_init(&frame, arena, &size, &config), SHEEN_OK);
        stage_view(&view);
        for (int i = 0; i < 3; i++)
            assert_int_equal(stage_frame(frame, &view, &stage, actors, 2), SHEEN_OK);
        struct sheen_stats stats;
        sheen_frame_stats(frame, &stats);
        assert_int_equal(stats.ram_arena, need);
        assert_true(stats.ram_vertices + stats.ram_lists + stats.ram_bands <= need);
        free(arena);
        memory_target_free(&target);
    }
}

static void bad_configurations(void **state)
{
    struct memory_target target;
    struct sheen_config good, bad;
    uint64_t arena[8192];
    struct sheen_frame *frame;

    (void)state;
    assert_int_equal(memory_target_init(&target, 64, 32, SHEEN_RGB565_BE), 0);
    good = (struct sheen_config){.target = &target.target, .max_vertices = 10, .max_triangles = 10};
    assert_true(sheen_arena_size(&good) > 0 && sheen_arena_size(&good) <= sizeof arena);
    for (int k = 0; k < 10; k++) {
        struct sheen_target other = target.target;
        size_t size = sizeof arena;
        bad = good;
        bad.target = k == 0 ? NULL : &other;
        bad.max_vertices = k == 1 ? 0 : bad.max_vertices;
        bad.max_triangles = k == 2 ? 0 : bad.max_triangles;
        bad.buffers = k == 3 ? 3 : 0;
        bad.workers = k == 4 ? 5 : 0;
        bad.max_carried = k == 5 ? 255 : 0;
        bad.max_clipped = k == 9;
        other.push = k == 6 ? NULL : other.push;
        other.width = k == 7 ? 641 : other.width;
        other.height = k == 8 ? 481 : other.height;
        if (sheen_arena_size(&bad) != 0 || sheen_init(&frame, arena, &size, &bad) != SHEEN_ERR_ARGUMENT)
            fail_msg("bad configuration %d was taken", k);
    }
    bad.target = &target.target;
    assert_int_equal(sheen_config_about(&bad), SHEEN_ABOUT_CLIPPER);
    bad.clipper = &sheen_clipper;
    assert_int_equal(sheen_config_about(&bad), SHEEN_ABOUT_NOTHING);
    memory_target_free(&target);
}

/* ---- capacities of a frame ---- */

static const struct actor first = {STAGE_BALL, 0, SHEEN_GOURAUD, -0.8, 0, 4, 1, 30, 20};
static const struct actor second = {STAGE_TORUS, 1, SHEEN_PHONG, 0.9, 0.1, 4, 1, 60, 50};
static const struct actor cut = {STAGE_BALL, 2, SHEEN_PHONG, 0.2, 0.1, 1.3, 0.6, 0, 40};

/* Draws the first actor, then the other; returns the latter's result. `target` gets what is sent, *stats counters. */
static int draw_two(struct memory_target *target, const struct sheen_config *config, const struct actor *other,
                    struct sheen_stats *stats)
{
    struct core_frame f;
    struct sheen_view view;
    struct sheen_object draw;

    memory_target_begin(target);
    assert_int_equal(core_frame_make(&f, config), SHEEN_OK);
    stage_view(&view);
    for (int frame = 0; frame < 2; frame++) { /* the second frame sends only what the draws cover */
        memory_target_begin(target);
        assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
        stage_draw(&stage, &first, &draw);
        assert_int_equal(sheen_draw(f.frame, &draw), SHEEN_OK);
        int status = SHEEN_OK;
        if (other) {
            stage_draw(&stage, other, &draw);
            status = sheen_draw(f.frame, &draw);
        }
        sheen_frame_stats(f.frame, stats);
        assert_int_equal(sheen_end(f.frame), SHEEN_OK);
        if (frame == 1) {
            core_frame_free(&f);
            return status;
        }
    }
    return SHEEN_ERR_STATE; /* not reached */
}

/* Sets the capacity under test to `room`. */
static void set_room(struct sheen_config *config, int which, uint32_t room)
{
    uint16_t *field[] = {&config->max_vertices, &config->max_triangles, &config->max_draws, &config->max_clipped};

    *field[which] = (uint16_t)room;
}

/* The smallest capacity of this kind that both draws fit in; with less, a draw must fail with SHEEN_ERR_CAPACITY. */
static uint32_t smallest_room(const struct sheen_config *config, int which, const struct actor *other)
{
    uint32_t low = 0, high = 2000;

    while (high - low > 1) {
        uint32_t room = (low + high) / 2;
        struct sheen_config tried = *config;
        struct sheen_object draw;
        struct core_frame f;
        struct sheen_view view;

        set_room(&tried, which, room);
        assert_int_equal(core_frame_make(&f, &tried), SHEEN_OK);
        stage_view(&view);
        assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
        stage_draw(&stage, &first, &draw);
        int status = sheen_draw(f.frame, &draw);
        stage_draw(&stage, other, &draw);
        if (status == SHEEN_OK)
            status = sheen_draw(f.frame, &draw);
        assert_true(status == SHEEN_OK || status == SHEEN_ERR_CAPACITY);
        *(status == SHEEN_OK ? &high : &low) = room;
        core_frame_free(&f);
    }
    return high;
}

/* A capacity of n suffices; n - 1 gives an error that leaves the frame as the first draw left it. */
static void check_capacity(int which, const struct actor *other, const char *what)
{
    struct memory_target target, one;
    struct sheen_config config;
    struct sheen_stats stats, stats_one;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    assert_int_equal(memory_target_init(&one, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &one, 2);
    config.max_clipped = 500;
    assert_int_equal(draw_two(&one, &config, NULL, &stats_one), SHEEN_OK);
    config.target = &target.target;
    assert_int_equal(draw_two(&target, &config, other, &stats), SHEEN_OK);

    uint32_t high = smallest_room(&config, which, other);
    if (which == 0)
        assert_int_equal(high, stage.mesh[first.mesh].mesh.vertices + stage.mesh[other->mesh].mesh.vertices);
    if (which == 1)
        assert_int_equal(high, stats.drawn);
    if (which == 2)
        assert_int_equal(high, 2);
    if (which == 3) { /* a cut triangle leaves nothing or some pieces */
        assert_true(high > 1 && stats.clipped > 1);
        assert_int_equal(high, stats.pieces);
    }

    set_room(&config, which, high);
    assert_int_equal(draw_two(&target, &config, other, &stats), SHEEN_OK);
    assert_memory_not_equal(target.memory, one.memory, HEIGHT * one.row_bytes);
    set_room(&config, which, high - 1);
    memset(target.memory, 0, HEIGHT * target.row_bytes);
    assert_int_equal(draw_two(&target, &config, other, &stats), SHEEN_ERR_CAPACITY);
    assert_memory_equal(target.memory, one.memory, HEIGHT * one.row_bytes);
    assert_int_equal(target.area, one.area); /* the failed draw does not even enlarge the rectangles */
    assert_int_equal(stats.drawn, stats_one.drawn);
    assert_int_equal(stats.pieces, stats_one.pieces);
    print_message("  %s: %u are enough, %u are an error\n", what, high, high - 1);
    memory_target_free(&target);
    memory_target_free(&one);
}

static void capacities(void **state)
{
    (void)state;
    check_capacity(0, &second, "vertices");
    check_capacity(1, &second, "triangles");
    check_capacity(2, &second, "draws");
    check_capacity(3, &cut, "pieces");
}

/* Without room for pieces, a triangle across the guard band is refused if it is seen; without a clipper, always. */
static void across_the_guard_band(const struct sheen_clipper *clipper)
{
    static const int16_t position[9] = {-32767, -32767, 0, 32767, -32767, 0, 0, 32767, 0};
    static const uint8_t front[3] = {0, 1, 2}, back[3] = {0, 2, 1};
    struct sheen_mesh mesh = {
        .positions = position, .index_bytes = 1, .vertices = 3, .triangles = 1, .scale = SHEEN_Q24(20)};
    struct sheen_object draw = {.mesh = &mesh, .material = &stage.material[0], .shader = &sheen_flat};
    struct memory_target target;
    struct sheen_config config;
    struct sheen_view view;
    struct core_frame f;
    const int unseen = clipper != NULL ? SHEEN_OK : SHEEN_ERR_CAPACITY;

    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 3);
    config.clipper = clipper;
    assert_int_equal(core_frame_make(&f, &config), SHEEN_OK);
    stage_view(&view);
    sheen_pose_orbit(&draw.pose, 0, 0, 0, SHEEN_Q24(3));
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    mesh.indices = back;
    assert_int_equal(sheen_draw(f.frame, &draw), unseen);
    mesh.indices = front;
    assert_int_equal(sheen_draw(f.frame, &draw), SHEEN_ERR_CAPACITY);
    draw.pose.translation[0] = SHEEN_Q24(23); /* still across the guard band, but outside the picture */
    draw.pose.translation[1] = SHEEN_Q24(23);
    assert_int_equal(sheen_draw(f.frame, &draw), unseen);
    assert_int_equal(sheen_end(f.frame), SHEEN_OK);
    core_frame_free(&f);
    memory_target_free(&target);
}

static void what_is_not_listed_needs_no_piece(void **state)
{
    (void)state;
    across_the_guard_band(&sheen_clipper);
    across_the_guard_band(NULL);
}

/* The number of pieces that the frame's only draw reports as needed; 0 if it succeeds. */
static uint32_t pieces_said(const struct sheen_config *config, const struct actor *actor)
{
    struct core_frame f;
    struct sheen_view view;
    struct sheen_object draw;
    struct sheen_stats stats;
    uint32_t needed = 0;

    assert_int_equal(core_frame_make(&f, config), SHEEN_OK);
    stage_view(&view);
    assert_int_equal(sheen_begin(f.frame, &view), SHEEN_OK);
    stage_draw(&stage, actor, &draw);
    if (sheen_draw(f.frame, &draw) != SHEEN_OK) {
        assert_int_equal(sheen_frame_about(f.frame, &needed), SHEEN_ABOUT_MAX_CLIPPED);
        assert_true(needed > 0);
    }
    sheen_frame_stats(f.frame, &stats);
    assert_true((stats.drawn == 0) == (needed > 0));
    assert_int_equal(sheen_end(f.frame), SHEEN_OK);
    core_frame_free(&f);
    return needed;
}

/*
 * Without a clipper, an object that no plane crosses is drawn, one that the near plane crosses is refused, and the
 * number of pieces reported then suffices with a clipper.
 */
static void only_what_is_cut_needs_a_clipper(void **state)
{
    struct memory_target target;
    struct sheen_config config;

    (void)state;
    assert_int_equal(memory_target_init(&target, WIDTH, HEIGHT, SHEEN_RGB565_BE), 0);
    stage_config(&config, &target, 2);
    config.clipper = NULL;
    assert_int_equal(pieces_said(&config, &first), 0);
    const uint32_t said = pieces_said(&config, &cut);
    assert_true(said > 0 && said <= UINT16_MAX);
    config.clipper = &sheen_clipper;
    const uint32_t exact = pieces_said(&config, &cut);
    print_message("  %u pieces, %u are said to do without a clipper\n", exact, said);
    assert_true(exact > 0 && exact <= said);
    config.max_clipped = (uint16_t)said;
    assert_int_equal(pieces_said(&config, &cut), 0);
    memory_target_free(&target);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_arena_too_small),
        cmocka_unit_test(arena_is_kept_to),
        cmocka_unit_test(bad_configurations),
        cmocka_unit_test(capacities),
        cmocka_unit_test(what_is_not_listed_needs_no_piece),
        cmocka_unit_test(only_what_is_cut_needs_a_clipper),
    };

    return cmocka_run_group_tests_name("frame_limits", tests, make_stage, free_stage);
}
