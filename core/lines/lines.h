/*
 * lines.h - private: what a mesh's edges are to a frame, and how they are drawn over its triangles.
 *
 * Lines get a draw's mesh and vertices when they are listed, and a tile when they are drawn; they never see the frame.
 */
#ifndef SHEEN_LINES_H
#define SHEEN_LINES_H

#include "../triangle/fog.h"

/* Rows of a tile beyond its band, above and below: the neighbours of what a line crosses. */
#define LINE_APRON 1

/* An edge that is to be drawn. */
struct line {
    uint16_t from, to; /* places of its vertices; a contour has the triangle that is seen on its left */
    int16_t row;       /* the first row that it crosses, on the target */
    uint16_t end;      /* one past the last; LINE_CONTOUR: one of its triangles is not seen */
};

#define LINE_CONTOUR 0x8000u
#define LINE_END 0x7fffu

/* What a draw's lines are made from, and where they go. */
struct line_list {
    const struct sheen_mesh *mesh;
    const struct draw *draw;
    uint32_t *front;       /* a bit a triangle, all clear: it faces the eye, or has no area */
    const uint16_t *place; /* of the mesh's vertices in `vertex`; max_used and more: none */
    struct vertex *vertex; /* used ones; ends of lines that are cut take more */
    uint32_t used, max_used;
    const struct projection *projection;
    const struct transform *transform;
    const struct screen *screen;
    struct line *line;
    uint32_t lines, max_lines; /* found, room for: what finds no room is counted */
    uint8_t two_sided;
};

/* What a marked pixel becomes. */
struct mixed {
    uint16_t x; /* from the tile's corner */
    uint16_t pixel;
};

/* A band's lines: those of a draw that reach it are drawn on its rows [y0, y1), which the tile has an apron around. */
struct line_tile {
    const struct tile *tile;
    const struct vertex *vertex;
    int32_t y0, y1;
    int32_t depth_bias;          /* of the draw, as in struct draw, */
    const struct fog_terms *fog; /* likewise; NULL: none */
    uint32_t whole_bits;         /* shares are whole where 2^whole_bits steps of z16 lie between inside and beyond */
    int32_t apron;               /* y0 - tile->rect.y0 */
    uint32_t rows;               /* y1 - y0 */
    struct span *touched;        /* a row: the first and the last column of a mark, from the tile's corner */
    uint8_t *marks;              /* a byte a pixel, MARK_PITCH a row; clear before and after */
    struct mixed *mixed;         /* two rows */
};

/* Bytes of a row of marks, a multiple of 8; and how many such rows `mixed` takes the room of. */
#define MARK_PITCH(width) (((width) + 7u) & ~7u)
#define MARK_ROWS 8

/*
 * What is drawn of edges.
 * draw: lines [line, end) in a band; pixel: as it stands in a tile.
 * finish: NULL, or once a band, after all draws' lines with it: marks become pixels. Those come before lines without.
 */
struct line_kind {
    void (*draw)(const struct line_tile *t, const struct line *line, const struct line *end, uint16_t pixel);
    void (*finish)(const struct line_tile *t);
    uint8_t sharp; /* sharp edges are listed */
    uint8_t all;   /* all but inner ones are */
};

extern const struct line_kind sheen_smooth_lines, sheen_outline_lines, sheen_wire_lines;

void sheen_list_edges(struct line_list *list, const struct line_kind *kind);

/*
 * A line ready to be stepped along its longer side: a step a row where it is steep, a column where it is not, at the
 * centre. `across` is the other coordinate.
 */
struct steps {
    int32_t first, end;          /* rows or columns on the target */
    int32_t across, across_step; /* Q15.16 px */
    int32_t z, z_step;           /* Q16.8 of z16 */
    uint8_t steep;               /* steps are rows */
    uint8_t low_inside;          /* what is seen of a contour lies towards lower columns or rows */
};

/* The steps of a line at rows [y0, y1) if it is steep, at all columns of the tile otherwise; 0: none. */
int sheen_line_begin(struct steps *s, const struct line_tile *t, const struct line *line);
void sheen_line_rows(const struct line_tile *t, const struct steps *s, uint16_t pixel, int contour);
void sheen_smooth_rows(const struct line_tile *t, const struct steps *s);
void sheen_smooth_finish(const struct line_tile *t);

#endif
