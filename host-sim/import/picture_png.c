/*
 * picture_png.c - reads PNG with libpng, row by row, interlaced or not.
 */
#include <png.h>
#include <string.h>

#include "picture.h"

/* The bytes that are read, and the error. */
struct source {
    const unsigned char *bytes;
    size_t count, at;
    const char *name;
    struct sheen_problem *problem;
    int error;
    uint8_t *row;
};

static void read_bytes(png_structp png, png_bytep to, png_size_t count)
{
    struct source *source = png_get_io_ptr(png);

    if (count > source->count - source->at)
        png_error(png, "it ends too early");
    memcpy(to, source->bytes + source->at, count);
    source->at += count;
}

static void fail(png_structp png, png_const_charp why)
{
    struct source *source = png_get_error_ptr(png);

    source->error = strcmp(why, "Out of memory") == 0 ? SHEEN_ERR_MEMORY : SHEEN_ERR_ARGUMENT;
    sheen_problem(source->problem, source->error, "%s: a broken PNG: %s", source->name, why);
    png_longjmp(png, 1);
}

static void ignore(png_structp png, png_const_charp why)
{
    (void)png, (void)why;
}

/* Makes libpng convert pixels to 3 or 4 bytes each. */
static void set_format(png_structp png)
{
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
}

/* Reads the rows of each of the seven grids of an interlaced picture, or simply the rows. */
static void read_rows(png_structp png, png_infop info, struct sheen_reducing *reducing, struct source *source)
{
    unsigned width = reducing->from[0], height = reducing->from[1], channels = png_get_channels(png, info);
    int passes = png_get_interlace_type(png, info) == PNG_INTERLACE_ADAM7 ? PNG_INTERLACE_ADAM7_PASSES : 0;

    for (int pass = 0; pass < passes; pass++) {
        unsigned columns = PNG_PASS_COLS(width, pass), rows = columns ? PNG_PASS_ROWS(height, pass) : 0;
        for (unsigned row = 0; row < rows; row++) {
            png_read_row(png, source->row, NULL);
            sheen_reducing_row(reducing, PNG_ROW_FROM_PASS_ROW(row, pass), PNG_PASS_START_COL(pass),
                               1u << PNG_PASS_COL_SHIFT(pass), columns, source->row, channels);
        }
    }
    for (unsigned row = 0; passes == 0 && row < height; row++) {
        png_read_row(png, source->row, NULL);
        sheen_reducing_row(reducing, row, 0, 1, width, source->row, channels);
    }
    png_read_end(png, NULL);
}

/* The width (at 16) or height (at 20) of a PNG; 1 if there is no IHDR, because libpng then reports the error. */
static uint32_t side(const struct source *source, size_t at)
{
    return source->count >= 24 && memcmp(source->bytes + 12, "IHDR", 4) == 0 ? png_get_uint_32(source->bytes + at) : 1;
}

int sheen_png_reduce(struct sheen_reducing *reducing, const unsigned char *bytes, size_t count, const unsigned most[2],
                     const char *name, struct sheen_problem *problem)
{
    struct source source = {.bytes = bytes, .count = count, .name = name, .problem = problem};
    int error = sheen_reducing_open(reducing, side(&source, 16), side(&source, 20), most, name, problem);
    png_structp png = error ? NULL : png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, fail, ignore);
    png_infop info = png ? png_create_info_struct(png) : NULL;

    if (!error && !info)
        error = sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", name);
    if (!error && setjmp(png_jmpbuf(png)) == 0) {
        png_set_read_fn(png, &source, read_bytes);
        png_set_user_limits(png, SHEEN_PICTURE_MAX, SHEEN_PICTURE_MAX);
        png_read_info(png, info);
        set_format(png);
        png_read_update_info(png, info);
        source.row = png_malloc(png, png_get_rowbytes(png, info));
        read_rows(png, info, reducing, &source);
    }
    if (png && source.row)
        png_free(png, source.row);
    png_destroy_read_struct(&png, &info, NULL);
    return error ? error : source.error;
}
