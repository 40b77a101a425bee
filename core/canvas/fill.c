/*
 * fill.c - areas of one colour, and gradients.
 */
#include "../pixel/pixel.h"
#include "canvas.h"

uint16_t sheen_canvas_colour(enum sheen_pixel pixel, const uint8_t rgb[3])
{
    const struct sheen_target target = {.pixel = (uint8_t)pixel};
    struct pixel_format format;

    sheen_format_begin(&format, &target);
    return sheen_colour_pixel(&format, rgb);
}

void sheen_canvas_fill(const struct sheen_canvas *canvas, enum sheen_pixel pixel, struct sheen_rect rect,
                       const uint8_t rgb[3])
{
    sheen_canvas_entries(canvas, canvas_is_wide(pixel), rect, sheen_canvas_colour(pixel, rgb));
}

/* Linear from `from` at 0 to `to` at `most`, rounded. most: 1..65534. */
static uint8_t mixed(uint8_t from, uint8_t to, int32_t at, int32_t most)
{
    int32_t twice = 2 * (from * (most - at) + to * at) + most; /* up to 2 * 255 * 65534 + 65534 < 2^26 */

    return (uint8_t)(twice / (2 * most));
}

void sheen_canvas_gradient(const struct sheen_canvas *canvas, enum sheen_pixel pixel,
                           const struct sheen_gradient *gradient)
{
    struct sheen_rect rows = canvas_clip(gradient->rect, canvas->rect);
    int32_t most = gradient->rect.y1 - gradient->rect.y0 > 1 ? gradient->rect.y1 - gradient->rect.y0 - 1 : 1;

    for (int32_t y = rows.y0; y < rows.y1; y++) {
        struct sheen_rect row = {rows.x0, (int16_t)y, rows.x1, (int16_t)(y + 1)};
        uint8_t rgb[3];

        for (int k = 0; k < 3; k++)
            rgb[k] = mixed(gradient->first[k], gradient->last[k], y - gradient->rect.y0, most);
        sheen_canvas_fill(canvas, pixel, row, rgb);
    }
}
