/*
 * phong_blocks.c - Phong over runs of 8 or 16 px: exact nodes half a block apart,
 * a parabola through three of them in between.
 */
#include "phong.h"

/* To the pixel n further on. */
static void run_next(const struct phong_setup *p, struct normal_run *r, int32_t n)
{
    r->ln += (uint32_t)n * p->light.dx;
    r->nv += (uint32_t)n * p->view.dx;
    r->d += (uint32_t)n * r->d_step + pairs(n) * p->square.dxx;
    r->d_step += (uint32_t)n * p->square.dxx;
}

static struct normal_run run_at(const struct phong_setup *p, const struct quadric_row *square, int32_t x, int32_t y)
{
    struct normal_run r = {plane_at(&p->light, x, y), plane_at(&p->view, x, y), 0, 0};

    quadric_run(square, x, &r.d, &r.d_step);
    return r;
}

/* An exact node: L.N / |N| (just below Q1.30, so that sums of three hold) and 1 - R.V (Q2.29). */
struct node {
    int32_t diffuse, reflected;
};

/* v.N over |N|, Q1.30, held at +-1.0; root: UQ2.30. */
static int32_t unit_dot(int32_t dot, int32_t root)
{
    int32_t half = mul_round(dot, root, 31); /* Q1.29: fits, should a sliver's rounding part the two */

    return 2 * min32(max32(half, -(1 << 29)), 1 << 29);
}

/*
 * 0 where there is no direction. To 2^-28 and not to a pixel's 2^-15: where a triangle is magnified, what a node
 * is off by is that of thousands of pixels, and of it a highlight makes n times as much.
 */
static int node_at(int32_t lv1, const struct normal_run *r, struct node *n)
{
    const int32_t most = 32767 * 32768;
    int32_t ln = (int32_t)r->ln, nv = (int32_t)r->nv;
    uint32_t d = r->d;

    if (d - ROOT_LOWEST >= ROOT_RANGE && !sheen_rescale(&d, &ln, &nv))
        return 0;
    int32_t root = (int32_t)(sheen_reciprocal_root(d < 1u << 31 ? d << 1 : UINT32_MAX) >> 1);
    ln = unit_dot(ln, root);
    n->diffuse = min32(max32(ln, -most), most);
    /* 2.0 at the most, where there is no highlight any more; halved on the way, so that nothing overflows */
    n->reflected = 2 * min32(asr32(lv1, 1) - asr32(mul_round(ln, unit_dot(nv, root), 30), 1), (1 << 29) - 1);
    return 1;
}

/* Through f0, f1 (half a block on) and f2; block of 2^shift px. */
static struct parabola through(int32_t f0, int32_t f1, int32_t f2, unsigned shift)
{
    int32_t half = 1 << (shift - 1), bend = asr32(f0, 1) - f1 + asr32(f2, 1); /* half of f0 - 2 f1 + f2 */
    struct parabola p = {f0, 0, asr32(bend, 2 * shift - 3)};                  /* over half^2 / 2 */

    /* f1 - f0 over half, less (half - 1) / 2 bends */
    p.step = asr32(f1, shift - 1) - asr32(f0, shift - 1) - asr32(p.bend * (half - 1), 1);
    return p;
}

/* Blocks from x on while they fit before x1; returns where the rest begins, *run there. */
static int32_t block_row(const struct tile *t, const struct phong_setup *p, int32_t x, int32_t x1, int32_t y,
                         struct normal_run *run)
{
    const int32_t lv1 = p->s.draw->light.lv1[0], length = 1 << p->s.detail;
    struct node node[3];

    if (x + length > x1 || !node_at(lv1, run, &node[0]))
        return x;
    node[0].diffuse += (int32_t)HALF; /* rounding */
    while (x + length <= x1) {
        struct normal_run next = *run;
        run_next(p, &next, length / 2);
        if (!node_at(lv1, &next, &node[1]))
            return x;
        run_next(p, &next, length / 2);
        if (!node_at(lv1, &next, &node[2]))
            return x;
        node[1].diffuse += (int32_t)HALF;
        node[2].diffuse += (int32_t)HALF;
        sheen_phong_block(t, p, x, y, through(node[0].diffuse, node[1].diffuse, node[2].diffuse, p->s.detail),
                          through(node[0].reflected, node[1].reflected, node[2].reflected, p->s.detail));
        node[0] = node[2];
        *run = next;
        x += length;
    }
    return x;
}

/* The rows of a triangle: blocks where they are wanted and fit, a root a pixel for the rest. */
void sheen_phong_rows(const struct tile *t, const struct setup *s)
{
    const struct phong_setup *p = (const struct phong_setup *)s;
    struct quadric_row square = quadric_row_at(&p->square, t->first_row);

    for (unsigned row = 0; row < t->rows; row++) {
        int32_t x = t->spans[row].x0, x1 = t->spans[row].x1, y = t->first_row + (int32_t)row;
        struct normal_run run = run_at(p, &square, x, y);
        if (s->way == SHEEN_WAY_PHONG_BLOCKS)
            x = block_row(t, p, x, x1, y, &run);
        if (x < x1)
            sheen_phong_root_run(t, p, x, x1, y, run);
        quadric_row_next(&square);
    }
}
