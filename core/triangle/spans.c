/*
 * spans.c - the rows of a triangle: edges stepped exactly, one span a row.
 */
#include "triangle.h"

/* To the next row: floor division with remainder, carried on. */
static inline void edge_step(struct edge *e)
{
    e->column += e->step;
    e->error += (int32_t)e->carry; /* in (-size, size), size < 2^23 */
    if (e->error > 0) {
        e->column++;
        e->error -= (int32_t)e->size;
    }
}

unsigned sheen_spans(const struct screen *screen, struct setup *s, struct sheen_rect rect, struct span *spans,
                     int16_t *first_row)
{
    int32_t end = min32(s->end_row, rect.y1);
    unsigned rows = 0;

    *first_row = s->row;
    while (s->row < end) {
        spans[rows].x0 = (int16_t)max32(s->left.column, rect.x0);
        spans[rows].x1 = (int16_t)min32(s->right.column, rect.x1);
        rows++;
        s->row++;
        edge_step(&s->left);
        edge_step(&s->right);
        if (s->row == s->middle_row && s->row < s->end_row)
            sheen_triangle_lower_edge(screen, s);
    }
    return rows;
}
