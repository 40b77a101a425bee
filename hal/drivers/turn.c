/*
 * turn.c - from the picture's pixels to the glass's, for controllers that cannot turn by themselves.
 *
 * In all eight orientations, going one pixel right or down on the glass moves by
 * a constant number of pixels in the rectangle that the core handed over: the
 * packers of driver_grey.c and driver_mono.c need a start and two steps.
 */
#include "driver.h"

/*
 * As in orientation 0 or 4, then a quarter turn at a time: what was up is then right,
 * what was right is down, and the bottom left corner comes first.
 */
void sheen_turn_of(const struct sheen_panel *panel, const struct sheen_rect *rect, struct sheen_turn *turn)
{
    int16_t w = (int16_t)(rect->x1 - rect->x0), h = (int16_t)(rect->y1 - rect->y0);
    uint16_t width, height, swap;
    struct sheen_turn now = {.right = 1, .down = w, .x = rect->x0, .y = rect->y0, .w = w, .h = h};

    sheen_panel_size(panel->record, panel->orientation, &width, &height);
    if (panel->orientation & 4) { /* mirrored: along the picture's x from the right end */
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
