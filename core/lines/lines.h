/*
 * lines.h - private: what a frame knows of a mesh's edges, and how they are drawn over its triangles.
 *
 * Lines get a draw's mesh and vertices when they are listed, and a tile when they are drawn; they never see the frame.
 */
#ifndef SHEEN_LINES_H
#define SHEEN_LINES_H

#include "../triangle/fog.h"

/* Rows that a tile has above and below its band, for the neighbours of the pixels that lines cross. */
#define LINE_APRON 1

/* An edge that is to be drawn. */
struct line {
    uint16_t from, to; /* its vertices' indices in `vertex`; a contour's visible triangle is on its left */
    int16_t row;       /* the first row that it crosses, on the target */
    uint16_t end;      /* one past its last row; LINE_CONTOUR: only one of its triangles is seen */
};

#define LINE_CONTOUR 0x8000u
#define LINE_END 0x7fffu

/* What a draw's lines are made from, and where they go. */
struct line_list {
    const struct sheen_mesh *mesh;
    const struct draw *draw;
    uint32_t *front;       /* a bit per triangle: it faces the eye, or has no area; all clear at first */
    const uint16_t *place; /* the indices in `vertex` of the mesh's vertices; from max_used on: none */
    struct vertex *vertex; /* the used ones; cut lines add their ends */
    uint32_t used, max_used;
    const struct projection *projection;
    const struct transform *transform;
    const struct screen *screen;
    struct line *line;
    uint32_t lines, max_lines; /* lines found, and room for them; those without room are counted too */
    uint8_t two_sided;
};

/* What a marked pixel becomes. */
struct mixed {
    uint16_t x; /* column in the tile */
    uint16_t pixel;
};

/* What drawing the lines of a band takes. They are drawn on the rows [y0, y1); the tile has an apron around these. */
struct line_tile {
    const struct tile *tile;
    const struct vertex *vertex;
    int32_t y0, y1;
    int32_t depth_bias;          /* the draw's */
    const struct fog_terms *fog; /* the view's; NULL: none */
    uint32_t whole_bits;  /* shares are whole if 2^whole_bits steps of z16 or more lie between inside and beyond */
    int32_t apron;        /* y0 - tile->rect.y0 */
    uint32_t rows;        /* y1 - y0 */
    struct span *touched; /* per row: the first and the last column of a mark, in the tile */
    uint8_t *marks;       /* a byte per pixel, MARK_PITCH per row; clear before and after */
    struct mixed *mixed;  /* room for two rows */
};

/* Bytes per row of marks, a multiple of 8; and how many such rows `mixed` takes up. */
#define MARK_PITCH(width) (((width) + 7u) & ~7u)
#define MARK_ROWS 8

/*
 * A kind of lines that edges can be drawn as.
 * draw: draws lines [line, end) in a band; pixel: their colour as stored in a tile.
 * finish: NULL, or called once per band, after the lines of all draws that have it: turns marks into pixels. Lines
 *   without it are drawn later.
 */
struct line_kind {
    void (*draw)(const struct line_tile *t, const struct line *line, const struct line *end, uint16_t pixel);
    void (*finish)(const struct line_tile *t);
    uint8_t sharp; /* sharp edges are listed */
    uint8_t all;   /* all edges except inner ones are listed */
};

extern const struct line_kind sheen_smooth_lines, sheen_outline_lines, sheen_wire_lines;

void sheen_list_edges(struct line_list *list, const struct line_kind *kind);

/*
 * A line ready to be stepped along its longer side: one step per row if it is steep, else one per column, at the
 * pixels' centres. `across` is the other coordinate.
 */
struct steps {
    int32_t first, end;          /* rows or columns on the target */
    int32_t across, across_step; /* Q15.16 px */
    int32_t z, z_step;           /* Q16.8 of z16 */
    uint8_t steep;               /* 1: steps are rows */
    uint8_t low_inside;          /* 1: a contour's visible side is towards lower columns or rows */
};

/* The steps of a line, on rows [y0, y1) if it is steep, on all columns of the tile otherwise; 0: there are none. */
int sheen_line_begin(struct steps *s, const struct line_tile *t, const struct line *line);
void sheen_line_rows(const struct line_tile *t, const struct steps *s, uint16_t pixel, int contour);
void sheen_smooth_rows(const struct line_tile *t, const struct steps *s);
void sheen_smooth_finish(const struct line_tile *t);

#endif
