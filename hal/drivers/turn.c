/*
 * turn.c - from the picture's pixels to the glass's, for controllers that cannot turn by themselves.
 *
 * In all eight orientations, going one pixel right or down on the glass moves by
 * a constant number of pixels in the rectangle that the core handed over: the
 * packers of driver_grey.c and driver_mono.c need a start and two steps.
 */
#include "driver.h"

void sheen_turn_of(const struct sheen_panel *panel, struct sheen_rect rect, struct sheen_turn *turn)
{
    int32_t w = rect.x1 - rect.x0, h = rect.y1 - rect.y0;
    uint16_t width, height;
    int16_t x0 = rect.x0;

    sheen_panel_size(panel->record, panel->orientation, &width, &height);
    int16_t below = (int16_t)(height - rect.y1); /* px under the rectangle */
    int16_t beside = (int16_t)(width - rect.x1); /* px right of it */
    int32_t right = 1, first = 0;                /* the picture's x axis, in the rectangle */
    if (panel->orientation & 4) {
        /* Mirrored: the axis runs from the rectangle's right end. */
        right = -1;
        first = w - 1;
        x0 = beside;
        beside = rect.x0;
    }

    switch (panel->orientation & 3) {
    case 0: /* glass right = picture right, glass down = picture down */
        *turn = (struct sheen_turn){first, right, w, x0, rect.y0, (int16_t)w, (int16_t)h};
        break;
    case 1: /* glass right = picture up, glass down = picture right */
        *turn = (struct sheen_turn){first + (h - 1) * w, -w, right, below, x0, (int16_t)h, (int16_t)w};
        break;
    case 2: /* glass right = picture left, glass down = picture up */
        *turn = (struct sheen_turn){
            first + (w - 1) * right + (h - 1) * w, -right, -w, beside, below, (int16_t)w, (int16_t)h};
        break;
    default: /* glass right = picture down, glass down = picture left */
        *turn = (struct sheen_turn){first + (w - 1) * right, w, -right, rect.y0, beside, (int16_t)h, (int16_t)w};
        break;
    }
}
