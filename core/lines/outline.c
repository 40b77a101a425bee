/*
 * outline.c - edges as lines of one colour: contours and sharp edges, or all except inner ones.
 */
#include "lines.h"

/* Draw a line in runs of one colour each, fogged according to the line's own depth. */
static void fogged_line(const struct line_tile *t, struct steps *s, uint16_t pixel, int contour)
{
    const int32_t end = s->end;

    while (s->first < end) {
        uint16_t fogged = pixel;
        const int32_t steps =
            t->fog->mixer->line_run(t->fog, t->tile->format, s->z, s->z_step, end - s->first, &fogged);
        s->end = s->first + steps;
        sheen_line_rows(t, s, fogged, contour);
        s->first = s->end;
        s->across += s->across_step * steps;
        s->z += s->z_step * steps;
    }
}

HOT static void draw_lines(const struct line_tile *t, const struct line *line, const struct line *end, uint16_t pixel)
{
    const int32_t y0 = t->y0, y1 = t->y1;
    struct steps s;

    for (; line != end; line++) {
        const int contour = (line->end & LINE_CONTOUR) != 0;
        if (line->row >= y1 || (int32_t)(line->end & LINE_END) <= y0 || !sheen_line_begin(&s, t, line))
            continue;
        if (t->fog != NULL)
            fogged_line(t, &s, pixel, contour);
        else
            sheen_line_rows(t, &s, pixel, contour);
    }
}

const struct line_kind sheen_outline_lines = {.draw = draw_lines, .sharp = 1};
const struct line_kind sheen_wire_lines = {.draw = draw_lines, .all = 1};
