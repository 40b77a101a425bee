/*
 * test_view_keys.c - frames, bands and keys of the viewer, and its window with SDL's driver that needs no screen.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <SDL.h>
#include <cmocka.h>

#include "png_file.h"
#include "view.h"

static struct sheen_problem problem;

#define GOOD(call)                                                                                                     \
    do {                                                                                                               \
        if ((call) != 0)                                                                                               \
            fail_msg("%s: %s", #call, problem.text);                                                                   \
    } while (0)

static void open_viewer(struct sheen_viewer *viewer, const char *words)
{
    static const struct sheen_command view = {"view", "MESH", "", SHEEN_VIEW, NULL};
    char text[200], *argv[32] = {"view", "builtin:torus"};
    int argc = 2;
    struct sheen_options options;
    struct sheen_sim_choice choice;

    snprintf(text, sizeof text, "%s", words);
    for (char *word = strtok(text, " "); word; word = strtok(NULL, " "))
        argv[argc++] = word;
    assert_int_equal(sheen_options_parse(&options, &view, argc, argv, &problem), 1);
    GOOD(sheen_sim_choose(&choice, options.panel, options.orientation, options.size[0], options.size[1], problem.text,
                          sizeof problem.text));
    GOOD(sheen_viewer_open(viewer, &options, &choice, &problem));
}

static void close_viewer(struct sheen_viewer *viewer)
{
    GOOD(sheen_viewer_close(viewer, &problem));
}

static size_t picture_bytes(const struct sheen_viewer *viewer)
{
    return (size_t)viewer->table.choice.width * viewer->table.choice.height * 3;
}

/* Compares the viewer with one that was opened with these words. */
static void expect_as_opened_with(const struct sheen_viewer *viewer, const char *words)
{
    struct sheen_viewer other;

    open_viewer(&other, words);
    assert_int_equal(viewer->table.choice.width, other.table.choice.width);
    assert_int_equal(viewer->table.choice.height, other.table.choice.height);
    assert_memory_equal(viewer->table.rgb, other.table.rgb, picture_bytes(viewer));
    close_viewer(&other);
}

/* Band by band the new frame replaces the old one from the top down; in the end it equals the frame drawn at once. */
static void test_bands(void **state)
{
    struct sheen_viewer viewer;
    static uint8_t before[320 * 240 * 3], after[320 * 240 * 3];
    int first, end, sent = 0;

    (void)state;
    open_viewer(&viewer, "--band 20 --yaw-step 25");
    memcpy(before, viewer.table.rgb, sizeof before);
    GOOD(sheen_viewer_next(&viewer, &problem));
    memcpy(after, viewer.table.rgb, sizeof after);
    assert_memory_not_equal(before, after, sizeof before);
    close_viewer(&viewer);

    open_viewer(&viewer, "--band 20 --yaw-step 25");
    for (int band = 0; band < 12; band++) {
        GOOD(sheen_viewer_key(&viewer, 'b', &problem));
        assert_false(viewer.playing);
        assert_int_equal(viewer.shown_band, band);
        sheen_viewer_rows(&viewer, &first, &end);
        assert_int_equal(first, 20 * band);
        assert_int_equal(end, 20 * band + 20);
        assert_true(viewer.sent.x0 >= viewer.sent.x1 || (viewer.sent.y0 >= first && viewer.sent.y1 <= end));
        sent += viewer.sent.x0 < viewer.sent.x1;
        assert_memory_equal(viewer.table.rgb, after, (size_t)end * 320 * 3);
        assert_memory_equal(viewer.table.rgb + end * 320 * 3, before + end * 320 * 3, (size_t)(240 - end) * 320 * 3);
    }
    assert_true(sent > 3);
    assert_int_equal(viewer.band, -1);
    assert_int_equal(viewer.number, 1);
    close_viewer(&viewer);
}

/* Whatever comes next finishes a frame under way: the next frame, another shading, another panel. */
static void test_bands_left(void **state)
{
    struct sheen_viewer viewer;

    (void)state;
    open_viewer(&viewer, "--yaw 0 --yaw-step 25 --buffers 2");
    for (int i = 0; i < 8; i++)
        GOOD(sheen_viewer_key(&viewer, 'b', &problem));
    GOOD(sheen_viewer_key(&viewer, 'n', &problem));
    assert_int_equal(viewer.shown_band, -1);
    expect_as_opened_with(&viewer, "--yaw 25");
    GOOD(sheen_viewer_key(&viewer, 'b', &problem));
    GOOD(sheen_viewer_key(&viewer, 's', &problem));
    expect_as_opened_with(&viewer, "--yaw 50 --shade slerp");
    GOOD(sheen_viewer_key(&viewer, 'b', &problem));
    GOOD(sheen_viewer_key(&viewer, 'p', &problem));
    expect_as_opened_with(&viewer, "--yaw 75 --shade slerp --panel st7789-240x320");
    close_viewer(&viewer);
}

/* Each key must do what its option does. */
static void test_keys(void **state)
{
    static const struct {
        int key, times;
        const char *words;
    } cases[] = {{'s', 1, "--shade slerp"},
                 {'s', 2, "--shade matcap"},
                 {'s', 3, "--shade matcap-vertex"},
                 {'s', 4, "--shade flat"},
                 {'s', 5, "--shade gouraud"},
                 {'s', 6, ""},
                 {'d', 1, "--dither off"},
                 {'d', 2, ""},
                 {'e', 0, "--edges smooth"},
                 {'e', 1, "--edges outline"},
                 {'e', 2, "--edges wire"},
                 {'e', 3, "--edges none"},
                 {'e', 4, ""},
                 {'a', 1, "--perspective affine"},
                 {'o', 1, "--ortho"},
                 {'l', 12, ""},
                 {'l', 6, "--light 0.4,-0.6,0.8"},
                 {'n', 2, "--yaw 42"},
                 {SHEEN_KEY_LEFT, 3, "--yaw 0"},
                 {SHEEN_KEY_RIGHT, 1, "--yaw 40"},
                 {SHEEN_KEY_UP, 2, "--pitch 0"},
                 {SHEEN_KEY_DOWN, 1, "--pitch 30"},
                 {'r', 1, "--orientation 2"},
                 {'r', 8, ""},
                 {'P', 1, "--panel ideal"},
                 {'P', 2, "--panel sh1106"},
                 {'?', 1, ""},
                 {0, 1, ""}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct sheen_viewer viewer;
        open_viewer(&viewer, "");
        for (int k = 0; k < cases[i].times; k++)
            GOOD(sheen_viewer_key(&viewer, cases[i].key, &problem));
        expect_as_opened_with(&viewer, cases[i].words);
        close_viewer(&viewer);
    }
}

/* All panels in all orientations, with a band too high for most: no complaint, and in the end all is as before. */
static void test_panels(void **state)
{
    struct sheen_viewer viewer;
    int panels = 0;

    (void)state;
    open_viewer(&viewer, "--band 240");
    do {
        GOOD(sheen_viewer_key(&viewer, 'p', &problem));
        for (int k = 0; k < 8; k++)
            GOOD(sheen_viewer_key(&viewer, 'r', &problem));
        panels++;
    } while (strcmp(sheen_turntable_panel_name(&viewer.table), "ili9341-240x320") != 0 && panels < 100);
    size_t known = 0;
    while (sheen_panel_at(known))
        known++;
    assert_int_equal(panels, known + 1);
    close_viewer(&viewer);
}

static void test_look(void **state)
{
    struct sheen_viewer viewer;

    (void)state;
    open_viewer(&viewer, "");
    viewer.room[0] = 960, viewer.room[1] = 700;
    sheen_viewer_look(&viewer);
    assert_int_equal(viewer.look.scale, 2); /* 240 rows times 3 are more than 700 */
    assert_int_equal(viewer.look.theme, SHEEN_THEME_LCD);
    for (unsigned scale = 3; scale <= 18; scale++) {
        GOOD(sheen_viewer_key(&viewer, '+', &problem));
        assert_int_equal(viewer.look.scale, scale < 16 ? scale : 16);
        assert_int_equal(viewer.look.gap, scale >= 4);
    }
    GOOD(sheen_viewer_key(&viewer, 'x', &problem));
    assert_int_equal(viewer.look.gap, 2);
    for (int k = 0; k < 20; k++) /* a gap as wide as the pixel would leave nothing of it */
        GOOD(sheen_viewer_key(&viewer, '-', &problem));
    assert_int_equal(viewer.look.scale, 1);
    assert_int_equal(viewer.look.gap, 0);
    GOOD(sheen_viewer_key(&viewer, 'x', &problem));
    assert_int_equal(viewer.look.gap, 0);
    for (int k = 0; k < SHEEN_THEMES; k++) {
        GOOD(sheen_viewer_key(&viewer, 't', &problem));
        assert_int_not_equal(viewer.look.theme, SHEEN_THEME_AUTO);
    }
    close_viewer(&viewer);
    open_viewer(&viewer, "--panel ssd1327");
    assert_int_equal(viewer.look.theme, SHEEN_THEME_OLED);
    close_viewer(&viewer);
}

/* The status lines show the values of the counters. */
static void test_status(void **state)
{
    struct sheen_viewer viewer;
    char text[300];

    (void)state;
    open_viewer(&viewer, "--panel ssd1351 --ortho --dither on");
    sheen_viewer_title(&viewer, text, sizeof text);
    assert_string_equal(text, "ssd1351-128x128  frame 0  phong, smooth edges, ortho, dithered  128x128, orientation 0");
    sheen_viewer_counts(&viewer, text, sizeof text);
    assert_non_null(strstr(text, " of 2000 triangles  "));
    assert_non_null(strstr(text, " whole frames/s, "));
    sheen_viewer_title(&viewer, text, 10);
    assert_string_equal(text, "ssd1351-1");
    GOOD(sheen_viewer_key(&viewer, 'b', &problem));
    sheen_viewer_title(&viewer, text, sizeof text);
    assert_non_null(strstr(text, "  frame 1, band 1 of 8: "));
    close_viewer(&viewer);
}

/* ---- the window ---- */

static void press(SDL_Keycode key)
{
    SDL_Event event = {.key = {.type = SDL_KEYDOWN, .keysym = {.sym = key}}};

    assert_int_equal(SDL_PushEvent(&event), 1);
}

/* Keys sent through SDL's queue; w writes the glass as it looks. */
static void test_window(void **state)
{
    static const SDL_Keycode keys[] = {SDLK_b,    SDLK_s,    SDLK_RIGHT,   SDLK_UP, SDLK_DOWN,
                                       SDLK_LEFT, SDLK_PLUS, SDLK_KP_PLUS, SDLK_g,  SDLK_n,
                                       SDLK_g,    SDLK_w,    SDLK_F1,      SDLK_p,  SDLK_q};
    struct sheen_viewer viewer;
    uint8_t *rgb;
    unsigned width, height;

    (void)state;
    open_viewer(&viewer, "--scale 1");
    GOOD(sheen_view_window_room(viewer.room, 1, &problem));
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++)
        press(keys[i]);
    GOOD(sheen_view_window(&viewer, &problem));
    assert_string_equal(viewer.options.panel, "st7789-240x320");
    assert_int_equal(viewer.options.shade, SHEEN_SLERP);
    assert_int_equal(viewer.number, 2);
    close_viewer(&viewer);
    if (sheen_png_read("sheen-001.png", &rgb, &width, &height, &problem) != 0)
        fail_msg("%s", problem.text);
    assert_int_equal(width, 960);
    assert_int_equal(height, 720);
    free(rgb);
    assert_int_equal(access("sheen-001.gif", F_OK), 0);
}

/* Closing the window ends the viewer, and so does the number of frames. */
static void test_window_end(void **state)
{
    SDL_Event quit = {.type = SDL_QUIT};
    struct sheen_viewer viewer;

    (void)state;
    open_viewer(&viewer, "");
    GOOD(sheen_view_window_room(viewer.room, 1, &problem));
    assert_int_equal(SDL_PushEvent(&quit), 1);
    GOOD(sheen_view_window(&viewer, &problem));
    assert_int_equal(viewer.number, 0);
    close_viewer(&viewer);

    open_viewer(&viewer, "--frames 3");
    GOOD(sheen_view_window_room(viewer.room, 1, &problem));
    GOOD(sheen_view_window(&viewer, &problem));
    assert_int_equal(viewer.number, 2);
    close_viewer(&viewer);
}

/* An unwritable file is reported, and the viewer goes on. */
static void test_unwritable(void **state)
{
    struct sheen_viewer viewer;
    char folder[] = "/tmp/sheen_gone_XXXXXX", *back = getcwd(NULL, 0);

    (void)state;
    assert_non_null(back);
    assert_non_null(mkdtemp(folder));
    assert_int_equal(chdir(folder), 0);
    assert_int_equal(rmdir(folder), 0);
    open_viewer(&viewer, "");
    GOOD(sheen_viewer_key(&viewer, 'w', &problem));
    assert_non_null(strstr(viewer.message, "sheen-001.png: "));
    GOOD(sheen_viewer_key(&viewer, 'g', &problem));
    GOOD(sheen_viewer_key(&viewer, 'g', &problem));
    assert_non_null(strstr(viewer.message, "sheen-001.gif: "));
    GOOD(sheen_viewer_key(&viewer, 'n', &problem));
    close_viewer(&viewer);
    assert_int_equal(chdir(back), 0);
    free(back);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bands),  cmocka_unit_test(test_bands_left), cmocka_unit_test(test_keys),
        cmocka_unit_test(test_panels), cmocka_unit_test(test_look),       cmocka_unit_test(test_status),
        cmocka_unit_test(test_window), cmocka_unit_test(test_window_end), cmocka_unit_test(test_unwritable),
    };
    char folder[] = "/tmp/sheen_view_XXXXXX";

    setenv("SDL_VIDEODRIVER", "dummy", 1);
    if (!mkdtemp(folder) || chdir(folder) != 0)
        return 1;
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    remove("sheen-001.png");
    remove("sheen-001.gif");
    return rmdir(folder) != 0 || failed != 0;
}
