/*
 * spans.c - the next rows of a triangle that began in a band above.
 */
#include "triangle.h"

void sheen_clip_spans(struct span *spans, unsigned rows, struct sheen_rect rect)
{
    for (unsigned row = 0; row < rows; row++) {
        spans[row].x0 = (int16_t)max32(spans[row].x0, rect.x0);
        spans[row].x1 = (int16_t)min32(spans[row].x1, rect.x1);
    }
}

unsigned sheen_spans(struct setup *s, struct sheen_rect rect, struct span *spans)
{
    const struct edge_rows to = {s->row, min32(s->end_row, rect.y1), 0};

    if (to.row >= to.end)
        return 0;
    for (int k = 0; k < 3; k++)
        sheen_edge_go_on(&s->edge[k], &to, s->right >> k & 1 ? &spans->x1 : &spans->x0);
    s->row = (int16_t)to.end;
    if (s->beyond)
        sheen_clip_spans(spans, (unsigned)(to.end - to.row), rect);
    return (unsigned)(to.end - to.row);
}
