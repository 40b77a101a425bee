/*
 * phong_cells.c - Phong over large triangles: cells of 8, 16 or 32 px square on the target, L.N and 1 - R.V exact
 * at 3 x 3 nodes of each and quadratic between. A cell's values depend on the triangle alone, so pixels are the same in
 * whichever band they are drawn.
 */
#include "../math/inverse.h"
#include "phong.h"

/* ---- nodes ---- */

/* f: L.N, Q1.30, plus half a step of UQ1.15, below 1.0; u: half of the power table's argument. */
struct node {
    int32_t f, u;
};

#define MOST_NODE 0x70000000 /* of u: 3.5 times the power table's range; cells with a highlight stay far below */

/*
 * N.N, UQ2.30, of N in Q1.30, off by a few steps. Range: cells reach so little beyond the triangle that |N| stays below
 * 1.3.
 */
static uint32_t node_square(const struct plane normal[3], int32_t x, int32_t y)
{
    uint32_t sum = 0;

    for (int i = 0; i < 3; i++) {
        const int32_t n = (int32_t)plane_at(&normal[i], x, y), high = asr32(n, 16), low = n & 0xffff;
        sum +=
            (uint32_t)(high * high) * 4u + (uint32_t)asr32(high * low, 13) + (uint32_t)((low >> 8) * (low >> 8) >> 14);
    }
    return sum;
}

/*
 * Computed to 2^-26, not to the 2^-15 of a pixel: in a magnified triangle thousands of pixels share a node's error, and
 * a highlight multiplies it by n.
 */
HOT static struct node node_at(const struct phong_cells_setup *p, int32_t x, int32_t y)
{
    const int32_t most = 32767 * 32768;
    const struct draw *d = p->of.s.draw;
    const unsigned power_up = d->power.up;
    struct node node = {0, MOST_NODE};

    SHEEN_TAP(NODE, 1);
    const uint32_t square = node_square(p->of.normal, x, y);
    if (square < 1u << 8)
        return node;
    const unsigned up = clz32(square) / 2; /* N.N / 4 * 4^up lies in [1/4, 1) */
    const struct inverse length = inverse_root(square << 2 * up, up);
    const int32_t ln = (int32_t)((uint32_t)over(length, (int32_t)plane_at(&p->light, x, y)) << (up + 1));
    const int32_t nv = (int32_t)((uint32_t)over(length, (int32_t)plane_at(&p->view, x, y)) << (up + 1));
    node.f = min32(max32(ln, -most), most) + (1 << 14);
    /* halves of both terms, so that nothing overflows */
    const int32_t u = asr32(d->light.lv1[0], 1) - 2 * PRODUCT_FORM(high)(ln, nv);
    node.u = min32(max32(u, 0), MOST_NODE >> power_up) * (1 << power_up) + (int32_t)(POWER_GUARD / 2);
    return node;
}

/* ---- between nodes ---- */

/* The quadratic through three nodes half a cell apart: value, step per pixel, and bend, the change of that step. */
static void through(int32_t f0, int32_t f1, int32_t f2, unsigned shift, int32_t out[3])
{
    int32_t half = 1 << (shift - 1), bend = asr32(f0, 1) - f1 + asr32(f2, 1);

    out[0] = f0;
    out[2] = asr32(bend, 2 * shift - 3);
    out[1] = asr32(f1, shift - 1) - asr32(f0, shift - 1) - asr32(out[2] * (half - 1), 1);
}

/* Value, step and bend (v, s, b) along a row of the cell, and how these change from row to row. */
struct patch {
    uint32_t v, vy, vyy, s, sy, syy, b, by;
};

/* The patch through nodes f, from row `row` of the cell on. */
HOT static APART void patch_of(struct patch *p, int32_t f[3][3], unsigned shift, int32_t row)
{
    int32_t x[3][3], along[3];
    const uint32_t n = (uint32_t)row, pair = pairs(row);

    for (int j = 0; j < 3; j++)
        through(f[j][0], f[j][1], f[j][2], shift, x[j]);
    through(x[0][0], x[1][0], x[2][0], shift, along);
    p->v = (uint32_t)along[0] + n * (uint32_t)along[1] + pair * (uint32_t)along[2];
    p->vy = (uint32_t)along[1] + n * (uint32_t)along[2];
    p->vyy = (uint32_t)along[2];
    through(x[0][1], x[1][1], x[2][1], shift, along);
    p->s = (uint32_t)along[0] + n * (uint32_t)along[1] + pair * (uint32_t)along[2];
    p->sy = (uint32_t)along[1] + n * (uint32_t)along[2];
    p->syy = (uint32_t)along[2];
    p->by = (uint32_t)asr32(x[2][2] - x[0][2], shift);
    p->b = (uint32_t)x[0][2] + n * p->by;
}

/* Moves n rows down, n = 1 or 4. */
SPECIALISED void patch_down(struct patch *p, uint32_t n)
{
    p->v += n * p->vy + n * (n - 1) / 2 * p->vyy;
    p->vy += n * p->vyy;
    p->s += n * p->sy + n * (n - 1) / 2 * p->syy;
    p->sy += n * p->syy;
    p->b += n * p->by;
}

/* The cell that is drawn, and those of its rows that are in the tile. */
struct cell {
    const struct phong_cells_setup *p;
    int32_t x, y, end;       /* first column, first row, one past the last */
    int32_t left, right;     /* columns that the triangle spans in this row of cells */
    const struct span *span; /* of row y */
    enum second second;
    int squares;       /* 1: drawn in squares of 4 px */
    struct patch f, u; /* at row y; with squares at their row of corners at or above y */
};

/* ---- pixels ---- */

HOT static APART void cell_rows(const struct tile *t, struct cell *c)
{
    const struct setup *s = &c->p->of.s;
    const int32_t size = 1 << CELL_SHIFT(s);
    const struct span *span = c->span;
    struct patch *f = &c->f, *u = &c->u;

    for (int32_t y = c->y; y < c->end; y++, span++) {
        int32_t x = max32(span->x0, c->x), x1 = min32(span->x1, c->x + size);
        OPAQUE(f); /* what is stepped once per row stays in memory */
        if (x < x1) {
            SHEEN_TAP(CELL_DULL, c->second == SECOND_NONE ? x1 - x : 0);
            SHEEN_TAP(CELL_POWER, c->second == SECOND_POWER ? x1 - x : 0);
            const uint32_t n = (uint32_t)(x - c->x), pair = pairs((int32_t)n);
            struct shaded_run run;
            run.z = plane_at(&s->depth, x, y);
            run.dz = s->depth.dx;
            run.f = f->v + n * f->s + pair * f->b;
            run.df = f->s + n * f->b;
            run.ddf = f->b;
            if (c->second == SECOND_POWER) {
                run.u = 2 * (u->v + n * u->s + pair * u->b);
                run.du = 2 * (u->s + n * u->b);
                run.ddu = 2 * u->b;
            }
            sheen_shaded_run(t, s->draw, x, x1, y, &run, c->second);
        }
        patch_down(f, 1);
        if (c->second == SECOND_POWER)
            patch_down(u, 1);
    }
}

/* ---- pixels in squares of 4 px, channels exact at the corners and linear between ---- */

/*
 * The channels of a corner. Words are multiples of 4 and red is a multiple of 16, so that steps of a quarter, down and
 * then along, are whole numbers and red's do not reach blue.
 */
static struct packed corner_of(const struct draw *d, uint32_t f, uint32_t u)
{
    const struct loop_terms *q = &d->loop;
    OPAQUE(q); /* the terms stay in memory: there are not enough registers for all */
    const uint32_t half = d->dither ? 0 : 1u << (LOOP_FRACTION - 1); /* of the one rounding */
    const uint32_t most_red = (31u << LOOP_FRACTION) + half, most_green = (63u << LOOP_FRACTION) + half;
    const uint32_t lit = not_negative(f) >> 15, specular = u < q->power_end ? power_entry(q->power, u) : 0;
    uint32_t r = q->ab[0] + q->ab[1] * lit + q->c[0] * specular, g = q->ab[2] + q->ab[3] * lit + q->c[1] * specular;
    uint32_t b = q->ab[4] + q->ab[5] * lit + q->c[2] * specular;

    r = clamped(r, most_red) >> (LOOP_FRACTION - 11) & ~15u;
    b = clamped(b, most_red) >> (LOOP_FRACTION - 11) & ~3u;
    return (struct packed){(r << 16) + b, clamped(g, most_green) << 2};
}

/* Corners 0 to `last` at the patches' row, from column 4 * `from` of the cell on; on entry, those of the row above. */
HOT static APART void corner_row(const struct cell *c, struct square_corner *corner, int32_t from, int32_t last)
{
    const struct draw *draw = c->p->of.s.draw;
    const struct patch *f = &c->f, *u = &c->u;
    const uint32_t n = 4u * (uint32_t)from, pair = pairs((int32_t)n), ddf = 16 * f->b, ddu = 32 * u->b;
    uint32_t vf = f->v + n * f->s + pair * f->b, df = 4 * (f->s + n * f->b) + 6 * f->b;
    uint32_t vu = 2 * (u->v + n * u->s + pair * u->b), du = 8 * (u->s + n * u->b) + 12 * u->b;

    SHEEN_TAP(SQUARE_CORNER, (uint32_t)(last + 1));
    for (struct square_corner *end = corner + last; corner <= end; corner++) {
        const struct packed at = corner_of(draw, vf, vu);
        corner->down.red_blue = (at.red_blue >> 2) - (corner->at.red_blue >> 2);
        corner->down.green = (at.green >> 2) - (corner->at.green >> 2);
        corner->at = at;
        vf += df;
        df += ddf;
        vu += du;
        du += ddu;
    }
}

static void draw_parts(const struct tile *t, const struct square_line *l, int32_t x, int32_t x1, int32_t y)
{
    while (x < x1) {
        const int32_t end = min32((x | 3) + 1, x1);
        SHEEN_TAP(SQUARE_PART, 1);
        sheen_part_of_square(t, l, x, end, y);
        x = end;
    }
}

/* Whole squares first, then the parts of squares at the spans' ends; without a loop for whole ones, all in parts. */
static APART void draw_squares(const struct tile *t, const struct square_line *l)
{
    const int whole = FAST_LOOPS && t->format->swap;
    const struct span *span = l->span;

#if FAST_LOOPS
    if (whole && sheen_whole_squares(t, l))
        return;
#endif
    for (int32_t y = l->y; y < l->end; y++, span++) {
        const int32_t x = max32(span->x0, l->x), x1 = min32(span->x1, l->x1);
        SHEEN_TAP(SQUARE_ROW, !whole && x < x1);
        const int32_t left = whole ? min32((x + 3) & ~3, x1) : x1;
        draw_parts(t, l, x, left, y);
        draw_parts(t, l, max32(x1 & ~3, left), x1, y);
    }
}

HOT static APART void cell_by_squares(const struct tile *t, struct cell *c)
{
    const int32_t size = 1 << CELL_SHIFT(&c->p->of.s);
    const int32_t from = max32(c->left - c->x, 0) >> 2, last = ((min32(c->right - c->x, size) + 3) >> 2) - from;
    struct square_corner corner[32 / 4 + 1] = {{{0, 0}, {0, 0}}};
    struct square_line line = {.depth = &c->p->of.s.depth, .x = c->x + 4 * from, .corner = corner};

    line.x1 = line.x + 4 * last;
    corner_row(c, corner, from, last);
    for (line.end = c->y; line.end < c->end;) {
        line.y = line.end;
        line.end = min32((line.y | 3) + 1, c->end);
        line.span = c->span + (line.y - c->y);
        patch_down(&c->f, 4);
        patch_down(&c->u, 4);
        corner_row(c, corner, from, last);
        draw_squares(t, &line);
    }
}

/* ---- a cell, and the cells of a tile ---- */

/* A column of nodes, half a cell apart from row `top` down. */
static void node_column(const struct phong_cells_setup *p, int32_t x, int32_t top, int column, int32_t f[3][3],
                        int32_t u[3][3])
{
    for (int j = 0; j < 3; j++) {
        struct node n = node_at(p, x, top + j * (1 << (CELL_SHIFT(&p->of.s) - 1)));
        f[j][column] = n.f;
        u[j][column] = n.u;
    }
}

/* Makes the patches from the nodes, and chooses how the cell is drawn. */
static void cell_begin(struct cell *c, int32_t f[3][3], int32_t u[3][3])
{
    const struct setup *s = &c->p->of.s;
    const unsigned shift = CELL_SHIFT(s);
    int32_t row = c->y & ((1 << shift) - 1), least = INT32_MAX, darkest = INT32_MAX;

    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++) {
            least = min32(least, u[j][i]);
            darkest = min32(darkest, f[j][i]);
        }
    /* between nodes u falls below theirs by less than 2^-5 of the table's range */
    c->second = least - (1 << 24) < (int32_t)(s->draw->loop.power_end / 2) ? SECOND_POWER : SECOND_NONE;
    /* squares need light that is linear: not where a highlight begins to fade (L.N = 1/8) nor where light ends */
    const int32_t bent = c->second == SECOND_POWER ? FADED << 15 : 0;
    c->squares = (c->second == SECOND_POWER || s->draw->dither) && (s->detail & CELLS_IN_SQUARES) != 0 &&
                 darkest > bent + (1 << 25);
    row &= c->squares ? ~3 : ~0;
    patch_of(&c->f, f, shift, row);
    if (c->second == SECOND_POWER)
        patch_of(&c->u, u, shift, row);
    else
        c->u = (struct patch){.v = INT32_MAX}; /* beyond the power table */
}

/* Makes the cell at column x. right: in, nodes of its left side; out, of its right. APART: nodes leave the stack. */
HOT static void cell_at(struct cell *c, int32_t x, struct node right[3])
{
    const int32_t size = 1 << CELL_SHIFT(&c->p->of.s), top = c->y & -size;
    int32_t f[3][3], u[3][3];

    SHEEN_TAP(CELL, 1);
    SHEEN_TAP(CELL_ROW, (uint32_t)(c->end - c->y));
    c->x = x;
    node_column(c->p, x + size / 2, top, 1, f, u);
    node_column(c->p, x + size, top, 2, f, u);
    for (int j = 0; j < 3; j++) {
        f[j][0] = right[j].f;
        u[j][0] = right[j].u;
        right[j].f = f[j][2];
        right[j].u = u[j][2];
    }
    cell_begin(c, f, u);
}

/* Finds the columns that the triangle spans in a row of cells; 0: none. */
static int columns_of(struct cell *c)
{
    c->left = INT32_MAX;
    c->right = INT32_MIN;
    for (int32_t i = 0; i < c->end - c->y; i++)
        if (c->span[i].x0 < c->span[i].x1) {
            c->left = min32(c->left, c->span[i].x0);
            c->right = max32(c->right, c->span[i].x1);
        }
    return c->left < c->right;
}

HOT void sheen_phong_cell_rows(const struct tile *t, const struct setup *s)
{
    const int32_t size = 1 << CELL_SHIFT(s), last = t->first_row + (int32_t)t->rows;
    struct node right[3];
    struct cell c;

    c.p = (const struct phong_cells_setup *)s;
    for (c.y = t->first_row; c.y < last; c.y = c.end) {
        c.span = t->spans + (c.y - t->first_row);
        c.end = min32((c.y | (size - 1)) + 1, last);
        if (!columns_of(&c))
            continue;
        int32_t x = c.left & -size;
        for (int j = 0; j < 3; j++)
            right[j] = node_at(c.p, x, (c.y & -size) + j * size / 2);
        for (; x < c.right; x += size) {
            cell_at(&c, x, right);
            if (c.squares)
                cell_by_squares(t, &c);
            else
                cell_rows(t, &c);
        }
    }
}
