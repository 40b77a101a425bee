/*
 * smooth.c - contours smoothed: each pixel that a contour crosses is marked with its neighbour across the contour, and
 * with that neighbour's share.
 */
#include "lines.h"

static void draw_smooth(const struct line_tile *t, const struct line *line, const struct line *end, uint16_t pixel)
{
    const int32_t y0 = t->y0, y1 = t->y1;
    struct steps s;

    (void)pixel;
    for (; line != end; line++)
        if (line->row <= y1 && (int32_t)(line->end & LINE_END) >= y0 && sheen_line_begin(&s, t, line))
            sheen_smooth_rows(t, &s);
}

const struct line_kind sheen_smooth_lines = {.draw = draw_smooth, .finish = sheen_smooth_finish};
