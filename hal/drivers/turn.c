/*
 * turn.c - finds the picture's pixels in the glass's order, for controllers that cannot turn by themselves.
 *
 * In all eight orientations, one pixel right or down on the glass is a constant
 * number of pixels further in the rectangle that the core pushed. So a start and two
 * steps are all that driver_grey.c and driver_mono.c need to rearrange pixels.
 */
#include "driver.h"

/*
 * Begins with orientation 0 or 4 and adds one quarter turn at a time. In each, up becomes
 * right, right becomes down, and the pixel that was at the bottom left comes first.
 */
void sheen_turn_of(const struct sheen_panel *panel, const struct sheen_rect *rect, struct sheen_turn *turn)
{
    int16_t w = (int16_t)(rect->x1 - rect->x0), h = (int16_t)(rect->y1 - rect->y0);
    uint16_t width, height, swap;
    struct sheen_turn now = {.right = 1, .down = w, .x = rect->x0, .y = rect->y0, .w = w, .h = h};

    sheen_panel_size(panel->record, panel->orientation, &width, &height);
    if (panel->orientation & 4) { /* mirrored: the picture's x counts from the right end */
        now.start = w - 1;
        now.right = -1;
        now.x = (int16_t)(width - rect->x1);
    }
    for (unsigned turns = panel->orientation & 3; turns; turns--) {
        *turn = now;
        now.start += (turn->h - 1) * turn->down;
        now.right = -turn->down;
        now.down = turn->right;
        now.x = (int16_t)(height - turn->y - turn->h);
        now.y = turn->x;
        now.w = turn->h;
        now.h = turn->w;
        swap = width, width = height, height = swap;
    }
    *turn = now;
}
