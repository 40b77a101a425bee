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

void sheen_spans_back(struct setup *s, int32_t row)
{
    const int32_t end = s->row;
    int32_t top = end;

    for (int k = 0; k < 3; k++) {
        struct edge *e = &s->edge[k];
        for (int32_t rows = min32(e->end, end) - max32(e->first, row); rows > 0; rows--) {
            e->at -= e->step;
            OPAQUE(rows); /* else gcc multiplies */
        }
        top = min32(top, e->first);
    }
    s->row = (int16_t)max32(row, top);
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
