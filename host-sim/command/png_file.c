/*
 * png_file.c - pictures to PNG files and back, with libpng's simplified interface.
 */
#include "png_file.h"

#include <png.h>
#include <stdlib.h>

#include "out_file.h"

static int failed(png_image *image, const char *path, struct sheen_problem *problem)
{
    int error = sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path, image->message);

    png_image_free(image);
    return error;
}

static int write(const char *path, const uint8_t *pixels, unsigned width, unsigned height, unsigned format,
                 struct sheen_problem *problem)
{
    png_image image = {.version = PNG_IMAGE_VERSION, .width = width, .height = height, .format = format};
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image); /* enough for any content */
    void *bytes = malloc(size);
    int error;

    if (!bytes)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", path);
    if (png_image_write_to_memory(&image, bytes, &size, 0, pixels, 0, NULL))
        error = sheen_out_file(path, bytes, size, problem);
    else
        error = failed(&image, path, problem);
    free(bytes);
    return error;
}

int sheen_png_write(const char *path, const uint8_t *rgb, unsigned width, unsigned height,
                    struct sheen_problem *problem)
{
    return write(path, rgb, width, height, PNG_FORMAT_RGB, problem);
}

int sheen_png_write_rgba(const char *path, const uint8_t *rgba, unsigned width, unsigned height,
                         struct sheen_problem *problem)
{
    return write(path, rgba, width, height, PNG_FORMAT_RGBA, problem);
}

int sheen_png_read(const char *path, uint8_t **rgb, unsigned *width, unsigned *height, struct sheen_problem *problem)
{
    png_image image = {.version = PNG_IMAGE_VERSION};

    *rgb = NULL;
    if (!png_image_begin_read_from_file(&image, path))
        return failed(&image, path, problem);
    image.format = PNG_FORMAT_RGB;
    uint8_t *pixels = malloc(PNG_IMAGE_SIZE(image));
    if (!pixels) {
        png_image_free(&image);
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", path);
    }
    if (!png_image_finish_read(&image, NULL, pixels, 0, NULL)) {
        free(pixels);
        return failed(&image, path, problem);
    }
    *rgb = pixels;
    *width = image.width;
    *height = image.height;
    return SHEEN_OK;
}
