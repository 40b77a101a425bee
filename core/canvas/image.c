/*
 * image.c - images copied into a canvas, row by row, or pixel by pixel if one of their colours is transparent.
 */
#include <string.h>

#include "canvas.h"

/* Copy the pixels that are not the key. */
static void put_keyed(uint8_t *to, const uint8_t *from, size_t bytes, int32_t count, uint16_t key)
{
    for (; count > 0; count--, to += bytes, from += bytes)
        if ((bytes == 1 ? *from : *(const uint16_t *)(const void *)from) != key)
            memcpy(to, from, bytes);
}

void sheen_canvas_image(const struct sheen_canvas *canvas, enum sheen_pixel pixel, const struct sheen_image *image)
{
    size_t bytes = canvas_is_wide(pixel) ? 2 : 1, pitch = image->pitch ? image->pitch : image->width;
    struct sheen_rect all = {image->x, image->y, canvas_edge(image->x + image->width),
                             canvas_edge(image->y + image->height)};
    struct sheen_rect r = canvas_clip(all, canvas->rect);

    for (int32_t y = r.y0; y < r.y1 && r.x0 < r.x1; y++) {
        size_t at = (size_t)(y - canvas->rect.y0) * canvas->pitch + (size_t)(r.x0 - canvas->rect.x0);
        size_t of = (size_t)(y - image->y) * pitch + (size_t)(r.x0 - image->x);
        uint8_t *to = (uint8_t *)canvas->pixels + at * bytes;
        const uint8_t *from = (const uint8_t *)image->pixels + of * bytes;

        if (image->keyed)
            put_keyed(to, from, bytes, r.x1 - r.x0, image->key);
        else
            memcpy(to, from, (size_t)(r.x1 - r.x0) * bytes);
    }
}
