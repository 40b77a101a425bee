/*
 * phong_cells.c - Phong over large triangles: cells of 8, 16 or 32 px square on the target, L.N and 1 - R.V exact
 * at 3 x 3 nodes of each and quadratic between. What a cell is made of depends on the triangle alone, so any band
 * gives the same pixels.
 */
#include "phong.h"

/* ---- nodes ---- */

/* L.N, Q1.30 and half a step of UQ1.15, below 1.0; and half of the power table's argument. */
struct node {
    int32_t f, u;
};

#define MOST_NODE 0x70000000 /* of u: 3.5 ranges of the power table, no cell with a highlight comes near */

/*
 * N in Q1.30 times itself, UQ2.30, and times a unit vector in Q1.30; 14 bits and 16 of N each. Off by a few steps.
 * Range: cells reach so little beyond the triangle that |N| stays below 1.2.
 */
static uint32_t node_square(const int32_t n[3])
{
    uint32_t sum = 0;

    for (int i = 0; i < 3; i++) {
        int32_t high = asr32(n[i], 16), low = n[i] & 0xffff;
        sum +=
            (uint32_t)(high * high) * 4u + (uint32_t)asr32(high * low, 13) + (uint32_t)((low >> 8) * (low >> 8) >> 14);
    }
    return sum;
}

static int32_t node_dot(const int32_t n[3], const int32_t v[3])
{
    int32_t sum = 0;

    for (int i = 0; i < 3; i++)
        sum += mul_16_32(asr32(n[i], 16), v[i]) * 4 + asr32((n[i] >> 1 & 0x7fff) * asr32(v[i], 15), 14);
    return sum;
}

/* v.N over |N|, held at +-1.0. 1 / |N| = root 2^(up - 1), so the product is below 2^62. */
static int32_t unit_dot(const int32_t n[3], const int32_t v[3], uint32_t root, unsigned up)
{
    int32_t dot = min32(max32(node_dot(n, v), -(INT32_MAX >> up)), INT32_MAX >> up) * (1 << up);
    int32_t half = mul_round(dot, (int32_t)(root >> 1), 32);

    return 2 * min32(max32(half, -(1 << 29)), 1 << 29);
}

/*
 * To 2^-26 and not to a pixel's 2^-15: where a triangle is magnified, what a node is off by is that of thousands of
 * pixels, and of it a highlight makes n times as much.
 */
static struct node node_at(const struct phong_normals_setup *p, int32_t x, int32_t y)
{
    const int32_t most = 32767 * 32768;
    const struct lighting *light = &p->s.draw->light;
    const unsigned power_up = p->s.draw->power.up;
    struct node node = {0, MOST_NODE};
    int32_t n[3];

    SHEEN_TAP(NODE, 1);
    for (int i = 0; i < 3; i++)
        n[i] = (int32_t)plane_at(&p->normal[i], x, y);
    uint32_t square = node_square(n);
    if (square < 1u << 8)
        return node;
    unsigned up = clz32(square) / 2; /* N.N / 4 * 4^up lies in [1/4, 1) */
    uint32_t root = sheen_root_step(square << 2 * up, root_seed(square << 2 * up >> 1) << 16);
    int32_t ln = unit_dot(n, light->to[0], root, up), nv = unit_dot(n, light->view, root, up);
    node.f = min32(max32(ln, -most), most) + (1 << 14);
    /* halves on the way, so that nothing overflows */
    int32_t u = asr32(light->lv1[0], 1) - asr32(mul_round(ln, nv, 30), 1);
    node.u = min32(max32(u, 0), MOST_NODE >> power_up) * (1 << power_up) + (int32_t)(POWER_GUARD / 2);
    return node;
}

/* ---- between nodes ---- */

/* Through three nodes, half a cell apart: value, step and bend. */
static void through(int32_t f0, int32_t f1, int32_t f2, unsigned shift, int32_t out[3])
{
    int32_t half = 1 << (shift - 1), bend = asr32(f0, 1) - f1 + asr32(f2, 1);

    out[0] = f0;
    out[2] = asr32(bend, 2 * shift - 3);
    out[1] = asr32(f1, shift - 1) - asr32(f0, shift - 1) - asr32(out[2] * (half - 1), 1);
}

/* Value, step and bend along a row of the cell, and what they have more in the next row. */
struct patch {
    uint32_t v, vy, vyy, s, sy, syy, b, by;
};

/* From row `row` of the cell on. */
static APART void patch_of(struct patch *p, int32_t f[3][3], unsigned shift, int32_t row)
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

/* n rows on, n 1 or 4. */
SPECIALISED void patch_down(struct patch *p, uint32_t n)
{
    p->v += n * p->vy + n * (n - 1) / 2 * p->vyy;
    p->vy += n * p->vyy;
    p->s += n * p->sy + n * (n - 1) / 2 * p->syy;
    p->sy += n * p->syy;
    p->b += n * p->by;
}

/* The cell that is drawn, and the rows of it that are in the tile. */
struct cell {
    const struct phong_normals_setup *p;
    int32_t x, y, end;       /* first column, first row, one past the last */
    int32_t left, right;     /* columns that the triangle has in this row of cells */
    const struct span *span; /* of row y */
    enum second second;
    int squares;       /* by squares of 4 px */
    struct patch f, u; /* at row y; squares: at that of their corners at or above it */
};

/* ---- pixels ---- */

static APART void cell_rows(const struct tile *t, struct cell *c)
{
    const struct setup *s = &c->p->s;
    const int32_t size = 1 << CELL_SHIFT(s);

    for (int32_t y = c->y; y < c->end; y++) {
        const struct span *span = c->span + (y - c->y);
        int32_t x = max32(span->x0, c->x), x1 = min32(span->x1, c->x + size);
        if (x < x1) {
            SHEEN_TAP(CELL_DULL, c->second == SECOND_NONE ? x1 - x : 0);
            SHEEN_TAP(CELL_POWER, c->second == SECOND_POWER ? x1 - x : 0);
            const uint32_t n = (uint32_t)(x - c->x), pair = pairs((int32_t)n);
            struct shaded_run run = {plane_at(&s->depth, x, y), s->depth.dx, c->f.v + n * c->f.s + pair * c->f.b,
                                     c->f.s + n * c->f.b,       c->f.b,      2 * (c->u.v + n * c->u.s + pair * c->u.b),
                                     2 * (c->u.s + n * c->u.b), 2 * c->u.b};
            sheen_shaded_run(t, s->draw, x, x1, y, &run, c->second);
        }
        patch_down(&c->f, 1);
        patch_down(&c->u, 1);
    }
}

/* ---- pixels by squares of 4 px, channels exact at their corners and linear between ---- */

static struct corner corner_of(const struct draw *d, uint32_t f, uint32_t u)
{
    const struct loop_terms *q = &d->loop;
    const uint32_t half = d->dither ? 0 : 1u << (LOOP_FRACTION - 1); /* of the one rounding */
    const uint32_t most_red = (31u << LOOP_FRACTION) + half, most_green = (63u << LOOP_FRACTION) + half;
    const uint32_t lit = not_negative(f) >> 15, specular = u < q->power_end ? power_entry(q->power, u) : 0;
    uint32_t r = q->ab[0] + q->ab[1] * lit + q->c[0] * specular, g = q->ab[2] + q->ab[3] * lit + q->c[1] * specular;
    uint32_t b = q->ab[4] + q->ab[5] * lit + q->c[2] * specular;

    r = clamped(r, most_red) >> (LOOP_FRACTION - 11) & ~15u;
    struct corner c = {(r << 16) + (clamped(b, most_red) >> (LOOP_FRACTION - 11)), clamped(g, most_green) << 2};
    return c;
}

/* Corners `from` to `to` of a row of squares, at the patches' row. */
static APART void corner_row(const struct cell *c, struct corner *at, int32_t from, int32_t to)
{
    const struct draw *draw = c->p->s.draw;
    const struct patch *f = &c->f, *u = &c->u;
    const uint32_t n = 4u * (uint32_t)from, pair = pairs((int32_t)n), ddf = 16 * f->b, ddu = 32 * u->b;
    uint32_t vf = f->v + n * f->s + pair * f->b, df = 4 * (f->s + n * f->b) + 6 * f->b;
    uint32_t vu = 2 * (u->v + n * u->s + pair * u->b), du = 8 * (u->s + n * u->b) + 12 * u->b;

    SHEEN_TAP(SQUARE_CORNER, (uint32_t)(to - from + 1));
    for (; from <= to; from++) {
        *at++ = corner_of(draw, vf, vu);
        vf += df;
        df += ddf;
        vu += du;
        du += ddu;
    }
}

/* `count` squares from column x on, the rows y to before `end` of them. */
struct square_line {
    const struct plane *depth;
    int32_t x, y, end, count;
    const struct span *span; /* of row y */
    const struct corner *top, *bottom;
};

/* Columns x to before x1 of row y, which the squares have. */
static void squares_row(const struct tile *t, const struct square_line *l, int32_t x, int32_t x1, int32_t y)
{
    const int32_t first = (x - l->x) >> 2;
    uint16_t *depth = t->depth + tile_offset(t, x, y);
    struct square_row r = {.top = l->top + first,
                           .bottom = l->bottom + first,
                           .i = (uint32_t)y & 3u,
                           .depth = depth,
                           .pixel = pixel_at(depth, t->to_pixel),
                           .thresholds = t->dither ? threshold_row(t, 1, y) : NULL,
                           .dz = l->depth->dx};

    SHEEN_TAP(SQUARE_ROW, 1);
    r.at = (struct square_at){plane_at(l->depth, x, y), side_of_square(r.top, r.bottom, r.i)};
    while (x < x1) {
        if (FAST_LOOPS && (x & 3) == 0 && x + 4 <= x1 && t->format->swap) {
            x = sheen_whole_squares(t, &r, x, x1);
        } else {
            const int32_t end = min32((x | 3) + 1, x1);
            SHEEN_TAP(SQUARE_PART, 1);
            sheen_part_of_square(t, &r, x, end);
            x = end;
        }
    }
}

static APART void draw_squares(const struct tile *t, const struct square_line *l)
{
    const struct span *span = l->span;

    for (int32_t y = l->y; y < l->end; y++, span++) {
        const int32_t x = max32(span->x0, l->x), x1 = min32(span->x1, l->x + 4 * l->count);
        if (x < x1)
            squares_row(t, l, x, x1, y);
    }
}

static APART void cell_by_squares(const struct tile *t, struct cell *c)
{
    const int32_t size = 1 << CELL_SHIFT(&c->p->s);
    const int32_t from = max32(c->left - c->x, 0) >> 2, to = (min32(c->right - c->x, size) + 3) >> 2;
    struct corner corner[2][32 / 4 + 1];
    struct square_line line = {.depth = &c->p->s.depth, .x = c->x + 4 * from, .count = to - from};
    unsigned top = 0;

    corner_row(c, corner[top], from, to);
    for (line.end = c->y; line.end < c->end; top ^= 1u) {
        line.y = line.end;
        line.end = min32((line.y | 3) + 1, c->end);
        line.span = c->span + (line.y - c->y);
        line.top = corner[top];
        line.bottom = corner[top ^ 1u];
        patch_down(&c->f, 4);
        patch_down(&c->u, 4);
        corner_row(c, corner[top ^ 1u], from, to);
        draw_squares(t, &line);
    }
}

/* ---- a cell, and the cells of a tile ---- */

/* A column of nodes, half a cell apart from row `top` down. */
static void node_column(const struct phong_normals_setup *p, int32_t x, int32_t top, int column, int32_t f[3][3],
                        int32_t u[3][3])
{
    for (int j = 0; j < 3; j++) {
        struct node n = node_at(p, x, top + j * (1 << (CELL_SHIFT(&p->s) - 1)));
        f[j][column] = n.f;
        u[j][column] = n.u;
    }
}

/* Patches from the nodes, and how the cell is drawn. */
static void cell_begin(struct cell *c, int32_t f[3][3], int32_t u[3][3])
{
    const struct setup *s = &c->p->s;
    const unsigned shift = CELL_SHIFT(s);
    int32_t row = c->y & ((1 << shift) - 1), least = INT32_MAX, darkest = INT32_MAX;

    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++) {
            least = min32(least, u[j][i]);
            darkest = min32(darkest, f[j][i]);
        }
    /* between nodes it lies below them by less than 2^-6 of the table's range */
    c->second = least - (1 << 23) < (int32_t)(s->draw->loop.power_end / 2) ? SECOND_POWER : SECOND_NONE;
    /* no line fits where a highlight begins to fade, 1/8, and where light ends */
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

/* The cell at column x; right: nodes of its left side, then of its right one. Apart: nodes leave the stack. */
static APART void cell_at(struct cell *c, int32_t x, struct node right[3])
{
    const int32_t size = 1 << CELL_SHIFT(&c->p->s), top = c->y & -size;
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

/* The columns that a row of cells spans; 0: none. */
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

void sheen_phong_cell_rows(const struct tile *t, const struct setup *s)
{
    const int32_t size = 1 << CELL_SHIFT(s), last = t->first_row + (int32_t)t->rows;
    struct node right[3];
    struct cell c;

    c.p = (const struct phong_normals_setup *)s;
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
