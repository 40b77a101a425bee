/*
 * canvas_rows.c - the loops over a canvas's pixels.
 */
#include "canvas.h"

void sheen_canvas_entries(const struct sheen_canvas *canvas, int wide, struct sheen_rect rect, uint16_t entry)
{
    struct sheen_rect r = canvas_clip(rect, canvas->rect);

    for (int32_t y = r.y0; y < r.y1 && r.x0 < r.x1; y++) {
        size_t at = (size_t)(y - canvas->rect.y0) * canvas->pitch + (size_t)(r.x0 - canvas->rect.x0);
        uint16_t *words = (uint16_t *)canvas->pixels + (wide ? at : 0);
        uint8_t *bytes = (uint8_t *)canvas->pixels + at;

        if (wide)
            for (int32_t i = 0; i < r.x1 - r.x0; i++)
                words[i] = entry;
        else
            for (int32_t i = 0; i < r.x1 - r.x0; i++)
                bytes[i] = (uint8_t)entry;
    }
}
