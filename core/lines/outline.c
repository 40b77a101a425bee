/*
 * outline.c - edges as lines of one colour: contours and sharp ones, or all.
 */
#include "lines.h"

static void draw_lines(const struct line_tile *t, const struct line *line, const struct line *end, uint16_t pixel)
{
    const int32_t y0 = t->y0, y1 = t->y1;
    struct steps s;

    for (; line != end; line++)
        if (line->row < y1 && (int32_t)(line->end & LINE_END) > y0 && sheen_line_begin(&s, t, line))
            sheen_line_rows(t, &s, pixel, (line->end & LINE_CONTOUR) != 0);
}

const struct line_kind sheen_outline_lines = {.draw = draw_lines, .sharp = 1};
const struct line_kind sheen_wire_lines = {.draw = draw_lines, .all = 1};
