/*
 * test_root_fault.c - the test of the accuracy test: a single wrong table entry must make it fail.
 *
 * The core it is linked with reads its root table from this program (core_tables in reference.cmake), so that an entry
 * can be changed by 1/64 of its value. Each entry is changed in turn to find the one that a view of the sphere uses
 * most; with that one changed the sphere must fail. The way with a root per pixel is forced, because the sphere's small
 * triangles would take another.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "accuracy.h"

#define ENTRIES 387
extern const uint16_t shipped_root_table[ENTRIES];
uint16_t sheen_root_table[ENTRIES]; /* what the core in this program reads */

static struct accuracy_mesh sphere;
static struct accuracy_shot shot;
static uint16_t good[ACCURACY_PIXELS];

static void mend(void)
{
    memcpy(sheen_root_table, shipped_root_table, sizeof sheen_root_table);
}

static void spoil(int entry)
{
    mend();
    sheen_root_table[entry] = (uint16_t)(sheen_root_table[entry] + sheen_root_table[entry] / 64);
}

static int make_sphere(void **state)
{
    (void)state;
    mend();
    return accuracy_mesh_make(&sphere, 0, false);
}

static int free_sphere(void **state)
{
    (void)state;
    accuracy_mesh_free(&sphere);
    return 0;
}

/* Draws the sphere with a root per pixel, except triangles that are too flat for gradients. */
static void shoot(const struct ref_scene *scene)
{
    struct ref_picture picture;

    assert_int_equal(ref_render(&picture, scene), 0);
    assert_int_equal(accuracy_shoot(&shot, scene, &picture, sphere.mesh, 1 + SHEEN_WAY_PHONG_ROOT), SHEEN_OK);
    ref_picture_free(&picture);
    assert_true(shot.stats.by_way[SHEEN_WAY_PHONG_ROOT] > 500);
    assert_int_equal(shot.stats.by_way[SHEEN_WAY_PHONG_ROOT] + shot.stats.by_way[SHEEN_WAY_PHONG_LIGHTS] +
                         shot.stats.by_way[SHEEN_WAY_FLAT],
                     shot.stats.frame.setups);
}

/* How many of the sphere's pictures (3 views, shininess 8, 32, 128) miss their limits; prints the worst shares. */
static int missed(void)
{
    static const double shininess[3] = {8, 32, 128};
    double equal = 1, within_one = 1;
    int count = 0, worst = 0;

    for (int i = 0; i < 3 * ACCURACY_VIEWS; i++) {
        struct ref_scene scene;
        const struct ref_score *score = &shot.score;
        accuracy_view(&scene, &sphere.reference, i / 3);
        scene.shininess = shininess[i % 3];
        shoot(&scene);
        count += !accuracy_kept(score, REF_PHONG, ACCURACY_COMPARED);
        double share = (double)score->equal / (double)score->compared;
        equal = share < equal ? share : equal;
        share = (double)score->within_one / (double)score->compared;
        within_one = share < within_one ? share : within_one;
        worst = score->worst > worst ? score->worst : worst;
    }
    print_message("    %d of 9 pictures miss the table: down to %.2f %% equal, %.3f %% within one step, worst %d\n",
                  count, 100 * equal, 100 * within_one, worst);
    return count;
}

/* The entry that changes most pixels of a view if it is wrong. */
static int most_used_entry(int view, long *changed)
{
    struct ref_scene scene;
    int most = -1;

    accuracy_view(&scene, &sphere.reference, view);
    mend();
    shoot(&scene);
    memcpy(good, shot.values, sizeof good);
    *changed = 0;
    for (int entry = 0; entry < ENTRIES; entry++) {
        long differing = 0;
        spoil(entry);
        struct core_stats stats;
        struct memory_target target;
        assert_int_equal(memory_target_init(&target, scene.width, scene.height, SHEEN_RGB565_BE), 0);
        assert_int_equal(
            core_draw_scene_way(&target.target, &scene, sphere.mesh, 240, 1 + SHEEN_WAY_PHONG_ROOT, &stats), SHEEN_OK);
        for (int i = 0; i < scene.width * scene.height; i++)
            differing += memory_target_pixel(&target, i % scene.width, i / scene.width) != good[i];
        memory_target_free(&target);
        if (differing > *changed) {
            *changed = differing;
            most = entry;
        }
    }
    return most;
}

static void one_wrong_entry_fails(void **state)
{
    (void)state;
    print_message("  as shipped:\n");
    mend();
    assert_int_equal(missed(), 0);
    for (int view = 0; view < ACCURACY_VIEWS; view++) {
        long changed;
        int entry = most_used_entry(view, &changed);
        assert_true(entry >= 0);
        print_message("  entry %d off by 1/64 changes %ld pixels of view %d:\n", entry, changed, view);
        spoil(entry);
        assert_true(missed() > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_wrong_entry_fails)};

    return cmocka_run_group_tests_name("root_fault", tests, make_sphere, free_sphere);
}
