/*
 * image.c - images into a canvas, a copy a row.
 */
#include <string.h>

#include "canvas.h"

void sheen_canvas_image(const struct sheen_canvas *canvas, enum sheen_pixel pixel, const struct sheen_image *image)
{
    size_t bytes = canvas_is_wide(pixel) ? 2 : 1, pitch = image->pitch ? image->pitch : image->width;
    struct sheen_rect all = {image->x, image->y, canvas_edge(image->x + image->width),
                             canvas_edge(image->y + image->height)};
    struct sheen_rect r = canvas_clip(all, canvas->rect);

    for (int32_t y = r.y0; y < r.y1 && r.x0 < r.x1; y++) {
        size_t to = (size_t)(y - canvas->rect.y0) * canvas->pitch + (size_t)(r.x0 - canvas->rect.x0);
        size_t from = (size_t)(y - image->y) * pitch + (size_t)(r.x0 - image->x);

        memcpy((uint8_t *)canvas->pixels + to * bytes, (const uint8_t *)image->pixels + from * bytes,
               (size_t)(r.x1 - r.x0) * bytes);
    }
}
