/*
 * memory.c - pixels in memory as a target.
 */
#include <string.h>

#include "../sheen_target.h"

static int push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    const struct sheen_memory *m = ctx;
    enum sheen_pixel pixel = (enum sheen_pixel)m->pixel;
    unsigned bytes = sheen_row_bytes(pixel, (unsigned)(rect.x1 - rect.x0));
    uint8_t *to = (uint8_t *)m->pixels + (size_t)rect.y0 * m->stride + sheen_row_bytes(pixel, (unsigned)rect.x0);
    const uint8_t *from = pixels;

    for (int32_t y = rect.y0; y < rect.y1; y++, to += m->stride, from += bytes)
        memcpy(to, from, bytes);
    return SHEEN_OK;
}

int sheen_memory_target(struct sheen_target *target, struct sheen_memory *memory, uint16_t width, uint16_t height,
                        enum sheen_pixel pixel)
{
    const struct sheen_target t = {.ctx = memory,
                                   .push = push,
                                   .width = width,
                                   .height = height,
                                   .pixel = (uint8_t)pixel,
                                   .align_x = (uint8_t)(pixel == SHEEN_GREY2    ? 8
                                                        : pixel == SHEEN_GREY16 ? 2
                                                                                : 1)};

    if (memory->pixels == NULL || pixel > SHEEN_GREY256 || memory->stride < sheen_row_bytes(pixel, width) ||
        (pixel <= SHEEN_RGB565_LE && (memory->stride & 1u) != 0))
        return SHEEN_ERR_ARGUMENT;
    memory->pixel = (uint8_t)pixel;
    *target = t;
    return SHEEN_OK;
}
