/*
 * test_panel_picture.c - what a panel shows is what the core drew.
 *
 * One view of each size on every RGB565 panel of that size, against the plain memory that the accuracy test judges.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "accuracy.h"
#include "sim_panel.h"

static struct accuracy_mesh torus;

static int make_torus(void **state)
{
    (void)state;
    return accuracy_mesh_make(&torus, 1, false);
}

static int free_torus(void **state)
{
    (void)state;
    accuracy_mesh_free(&torus);
    return 0;
}

/* Draws the same scene to memory and to the panel; returns how many values differ. */
static int differing(const char *name, int width, int height)
{
    static uint16_t values[640 * 480];
    struct sheen_sim_choice choice;
    struct sheen_sim_panel *panel;
    struct memory_target memory;
    struct ref_scene scene;
    char why[200];
    int count = 0;

    if (sheen_sim_choose(&choice, name, -1, (unsigned)width, (unsigned)height, why, sizeof why) != SHEEN_OK)
        fail_msg("%s", why);
    assert_int_equal(sheen_sim_panel_open(&panel, &choice), SHEEN_OK);
    assert_int_equal(sheen_sim_panel_levels(panel), 0);
    assert_int_equal(memory_target_init(&memory, width, height, SHEEN_RGB565_BE), 0);
    accuracy_view(&scene, &torus.reference, 1);
    scene.width = width;
    scene.height = height;
    assert_int_equal(core_draw_scene(&memory.target, &scene, torus.mesh, 16), SHEEN_OK);
    assert_int_equal(core_draw_scene(sheen_sim_panel_target(panel), &scene, torus.mesh, 16), SHEEN_OK);
    assert_int_equal(sheen_sim_panel_picture(panel, values), SHEEN_OK);
    if (sheen_sim_panel_complaints(panel) > 0)
        fail_msg("%s: %s", name, sheen_sim_panel_complaint(panel));
    for (int i = 0; i < width * height; i++)
        count += values[i] != memory_target_pixel(&memory, i % width, i / width);
    sheen_sim_panel_close(panel);
    memory_target_free(&memory);
    return count;
}

static void panels_show_what_was_drawn(void **state)
{
    (void)state;
    assert_int_equal(differing("ideal", 320, 240), 0);
    assert_int_equal(differing("ideal", 240, 240), 0);
    assert_int_equal(differing("ideal", 131, 97), 0);
    assert_int_equal(differing("ili9341", 320, 240), 0);
    assert_int_equal(differing("ili9341", 240, 320), 0);
    assert_int_equal(differing("st7789-240x240", 240, 240), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(panels_show_what_was_drawn)};

    return cmocka_run_group_tests_name("panel_picture", tests, make_torus, free_torus);
}
