/*
 * picture.c - reduces a picture to a texture by summing pixels over each texel's area.
 */
#include "picture.h"

#include <stdlib.h>
#include <string.h>

enum {
    ALPHA = 0,
    WEIGHED = 1, /* sums of r, g, b times alpha */
    PLAIN = 4,   /* sums of r, g, b */
    SUMS = 7
};

static unsigned texels(uint32_t length, unsigned most)
{
    while (most > length)
        most /= 2;
    return most;
}

int sheen_reducing_open(struct sheen_reducing *reducing, uint32_t width, uint32_t height, const unsigned most[2],
                        const char *name, struct sheen_problem *problem)
{
    if (width == 0 || height == 0)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: a picture without pixels", name);
    if (width > SHEEN_PICTURE_MAX || height > SHEEN_PICTURE_MAX)
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: a picture of %lux%lu, at most %dx%d can be read", name,
                             (unsigned long)width, (unsigned long)height, SHEEN_PICTURE_MAX, SHEEN_PICTURE_MAX);
    *reducing =
        (struct sheen_reducing){.from = {width, height}, .to = {texels(width, most[0]), texels(height, most[1])}};
    reducing->sums = calloc((size_t)reducing->to[0] * reducing->to[1] * SUMS, sizeof *reducing->sums);
    return reducing->sums ? SHEEN_OK : sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", name);
}

/*
 * In units in which a pixel is `to` long and a texel `from`, pixel `at` overlaps at most two texels: *first by part[0]
 * units and the next one by part[1].
 */
static void find_texels(uint32_t at, unsigned from, unsigned to, unsigned *first, unsigned part[2])
{
    unsigned begin = at * to, end; /* below 2^22 */

    *first = begin / from;
    end = (*first + 1) * from;
    part[0] = end - begin < to ? end - begin : to;
    part[1] = to - part[0];
}

static void add(uint64_t *sums, const uint8_t *pixel, unsigned alpha, uint64_t area)
{
    sums[ALPHA] += alpha * area;
    for (int k = 0; k < 3; k++) {
        sums[WEIGHED + k] += pixel[k] * alpha * area;
        sums[PLAIN + k] += pixel[k] * area;
    }
}

void sheen_reducing_row(struct sheen_reducing *reducing, uint32_t y, uint32_t first, uint32_t step, uint32_t count,
                        const uint8_t *pixels, unsigned channels)
{
    unsigned row, down[2], column, across[2];

    find_texels(y, reducing->from[1], reducing->to[1], &row, down);
    for (uint32_t i = 0; i < count; i++, pixels += channels) {
        unsigned alpha = channels == 4 ? pixels[3] : 255;
        find_texels(first + i * step, reducing->from[0], reducing->to[0], &column, across);
        for (unsigned part = 0; part < 4; part++) {
            unsigned area = across[part & 1] * down[part >> 1];
            size_t texel = (size_t)(row + (part >> 1)) * reducing->to[0] + column + (part & 1);
            if (area)
                add(reducing->sums + texel * SUMS, pixels, alpha, area);
        }
    }
}

static uint8_t mean(uint64_t sum, uint64_t weight)
{
    return (uint8_t)((sum + weight / 2) / weight);
}

static int finish(const struct sheen_reducing *reducing, struct sheen_image *image)
{
    size_t count = (size_t)reducing->to[0] * reducing->to[1];
    uint64_t area = (uint64_t)reducing->from[0] * reducing->from[1];

    image->rgba = malloc(4 * count);
    if (!image->rgba)
        return SHEEN_ERR_MEMORY;
    for (size_t i = 0; i < count; i++) {
        const uint64_t *sums = reducing->sums + i * SUMS;
        uint8_t *texel = image->rgba + 4 * i;
        for (int k = 0; k < 3; k++)
            texel[k] = sums[ALPHA] ? mean(sums[WEIGHED + k], sums[ALPHA]) : mean(sums[PLAIN + k], area);
        texel[3] = mean(sums[ALPHA], area);
    }
    for (int k = 0; k < 2; k++) {
        image->size[k] = (uint16_t)reducing->to[k];
        image->from[k] = (uint16_t)reducing->from[k];
    }
    return SHEEN_OK;
}

int sheen_image_read(struct sheen_image *image, const unsigned char *bytes, size_t count, const unsigned most[2],
                     const char *name, struct sheen_problem *problem)
{
    struct sheen_reducing reducing = {.sums = NULL};
    int error;

    *image = (struct sheen_image){.rgba = NULL};
    if (count >= 8 && memcmp(bytes, "\x89PNG\r\n\x1a\n", 8) == 0)
        error = sheen_png_reduce(&reducing, bytes, count, most, name, problem);
    else if (count >= 3 && memcmp(bytes, "\xff\xd8\xff", 3) == 0)
        error = sheen_jpeg_reduce(&reducing, bytes, count, most, name, problem);
    else
        error = sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: neither a PNG nor a JPEG", name);
    if (!error && finish(&reducing, image) != SHEEN_OK)
        error = sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", name);
    free(reducing.sums);
    return error;
}
