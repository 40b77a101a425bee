/*
 * test_gif.c - animated GIFs that sheen writes, read back by giflib and compared with the frames that were written.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>
#include <gif_lib.h>

#include "gif_file.h"

enum {
    WIDTH = 61,
    HEIGHT = 40,
    FRAMES = 3,
    BYTES = WIDTH * HEIGHT * 3,
    DELAY = 7
};

static uint8_t frames[FRAMES][BYTES];

/* Frame f as giflib decodes it. */
static void decoded(const GifFileType *file, int f, uint8_t *rgb)
{
    const SavedImage *image = &file->SavedImages[f];

    assert_non_null(image->ImageDesc.ColorMap);
    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        const GifColorType *color = &image->ImageDesc.ColorMap->Colors[image->RasterBits[i]];
        rgb[3 * i] = color->Red;
        rgb[3 * i + 1] = color->Green;
        rgb[3 * i + 2] = color->Blue;
    }
}

/* Writes the frames and reads them back; the file is removed. */
static GifFileType *there_and_back(void)
{
    char path[] = "/tmp/sheen_gif_XXXXXX";
    struct sheen_problem problem;
    struct sheen_gif *gif;
    int error;

    close(mkstemp(path));
    assert_int_equal(sheen_gif_open(&gif, WIDTH, HEIGHT, DELAY), 0);
    for (int f = 0; f < FRAMES; f++)
        assert_int_equal(sheen_gif_add(gif, frames[f]), 0);
    if (sheen_gif_write(gif, path, &problem) != 0)
        fail_msg("%s", problem.text);
    sheen_gif_close(gif);

    GifFileType *file = DGifOpenFileName(path, &error);
    assert_non_null(file);
    assert_int_equal(DGifSlurp(file), GIF_OK);
    unlink(path);
    assert_int_equal(file->ImageCount, FRAMES);
    assert_int_equal(file->SWidth, WIDTH);
    assert_int_equal(file->SHeight, HEIGHT);
    return file;
}

static void few_colors_are_exact(void **state)
{
    uint8_t rgb[BYTES];

    (void)state;
    for (int f = 0; f < FRAMES; f++) { /* 256, 255 and 1 colours */
        for (int i = 0; i < BYTES; i++)
            frames[f][i] = f == 2 ? 9 : (uint8_t)(i / 3 % (256 - f) * (i % 3 + 1) + f);
    }
    GifFileType *file = there_and_back();
    for (int f = 0; f < FRAMES; f++) {
        GraphicsControlBlock control;
        decoded(file, f, rgb);
        assert_memory_equal(rgb, frames[f], BYTES);
        assert_int_equal(DGifSavedExtensionToGCB(file, f, &control), GIF_OK);
        assert_int_equal(control.DelayTime, DELAY);
        assert_int_equal(control.TransparentColor, NO_TRANSPARENT_COLOR);
    }
    const ExtensionBlock *first = &file->SavedImages[0].ExtensionBlocks[0];
    assert_int_equal(first->Function, APPLICATION_EXT_FUNC_CODE);
    assert_memory_equal(first->Bytes, "NETSCAPE2.0", 11);
    assert_int_equal(DGifCloseFile(file, NULL), GIF_OK);
}

static void many_colors_are_near(void **state)
{
    uint8_t rgb[BYTES];
    int worst = 0;
    double sum = 0;

    (void)state;
    for (int f = 0; f < FRAMES; f++) { /* a smooth square of 2440 colours */
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            frames[f][3 * i] = (uint8_t)(i % WIDTH * 4);
            frames[f][3 * i + 1] = (uint8_t)(i / WIDTH * 6);
            frames[f][3 * i + 2] = (uint8_t)(80 * f);
        }
    }
    GifFileType *file = there_and_back();
    for (int f = 0; f < FRAMES; f++) {
        decoded(file, f, rgb);
        for (int i = 0; i < BYTES; i++) {
            int off = abs(rgb[i] - frames[f][i]);
            worst = off > worst ? off : worst;
            sum += off;
        }
    }
    printf("2440 colours in 256: at most %d of 255 off, %.1f in the mean\n", worst, sum / FRAMES / BYTES);
    assert_true(worst > 0 && worst <= 24 && sum / FRAMES / BYTES < 5);
    assert_int_equal(DGifCloseFile(file, NULL), GIF_OK);
}

/* Frames of a lit object on a background that fills most of the picture, in more colours than a palette holds. */
static void the_background_stays(void **state)
{
    static const uint8_t background[3] = {66, 97, 132};
    uint8_t rgb[BYTES];
    int worst = 0;

    (void)state;
    for (int f = 0; f < FRAMES; f++) {
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            int x = i % WIDTH - 10 - f, y = i / WIDTH, on = x >= 0 && x < 32 && y < 32;
            uint8_t lit[3] = {(uint8_t)(8 * x), (uint8_t)(8 * y), (uint8_t)(4 * (x > y ? x - y : y - x))};
            memcpy(frames[f] + 3 * i, on ? lit : background, 3);
        }
    }
    GifFileType *file = there_and_back();
    for (int f = 0; f < FRAMES; f++) {
        decoded(file, f, rgb);
        assert_memory_equal(rgb, background, 3);
        for (int i = 0; i < BYTES; i++)
            worst = abs(rgb[i] - frames[f][i]) > worst ? abs(rgb[i] - frames[f][i]) : worst;
    }
    printf("an object of 1024 colours before a background: at most %d of 255 off\n", worst);
    assert_true(worst <= 32);
    assert_int_equal(DGifCloseFile(file, NULL), GIF_OK);
}

static void what_cannot_be_written(void **state)
{
    struct sheen_problem problem;
    struct sheen_gif *gif;

    (void)state;
    assert_int_equal(sheen_gif_open(&gif, WIDTH, HEIGHT, DELAY), 0);
    assert_int_equal(sheen_gif_add(gif, frames[0]), 0);
    assert_true(sheen_gif_write(gif, "/nowhere/a.gif", &problem) < 0);
    assert_string_equal(problem.text, "/nowhere/a.gif: No such file or directory");
    sheen_gif_close(gif);
    assert_int_equal(sheen_gif_open(&gif, WIDTH, HEIGHT, DELAY), 0); /* and one that is closed without being written */
    assert_int_equal(sheen_gif_add(gif, frames[0]), 0);
    sheen_gif_close(gif);
    sheen_gif_close(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_colors_are_exact),
        cmocka_unit_test(many_colors_are_near),
        cmocka_unit_test(the_background_stays),
        cmocka_unit_test(what_cannot_be_written),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
