/*
 * matcap_blocks.c - rows of matcaps in blocks: between a block's ends texel coordinates are linear.
 */
#include "matcap.h"

/* Columns of a row that are left to draw. */
struct row_left {
    struct texel_run run; /* from the next pixel on */
    int32_t left;
    struct texel_at at, step;
};

static void rows_begin(struct row_left *r, const struct tile *t, const struct setup *s)
{
    sheen_textured_begin(&r->run, t, s);
    r->at = (struct texel_at){.light = (uint32_t)texel_light(&s->draw->texel, 0)};
    r->step = (struct texel_at){.z = s->depth.dx};
}

/* 0: the row is empty. */
HOT static int row_begin(struct row_left *r, const struct tile *t, const struct setup *s, unsigned row)
{
    const int32_t x = t->spans[row].x0, y = t->first_row + (int32_t)row;

    r->left = t->spans[row].x1 - x;
    r->run.x = x;
    r->run.y = y;
    r->run.depth = t->depth + tile_offset(t, x, y);
    r->at.z = plane_at(&s->depth, x, y);
    return r->left > 0;
}

static void put_block(struct row_left *r, int32_t count)
{
    r->run.count = count;
    sheen_textured_step(&r->run, &r->step);
    sheen_textured_run(&r->run, &r->at);
    r->left -= count;
    r->run.x += count;
    r->run.depth += count;
    r->at.z += (uint32_t)count * r->step.z;
}

/* ---- quadratic ---- */

/* A texel coordinate along a row: its value at a pixel, its step per pixel and the change of that step (bend). */
struct curve {
    uint32_t value, step, bend;
};

/* Moves past a block of `count` px and returns the mean step per pixel in it. */
static uint32_t curve_on(struct curve *c, uint32_t count)
{
    const uint32_t step = c->step + (uint32_t)asr32((int32_t)((count - 1) * c->bend), 1);

    c->value += count * c->step + count * (count - 1) / 2 * c->bend;
    c->step += count * c->bend;
    return step;
}

HOT void sheen_matcap_quadric_rows(const struct tile *t, const struct setup *s)
{
    const struct matcap_setup *m = (const struct matcap_setup *)s;
    const struct sheen_texture *texture = s->draw->texel.texture;
    const unsigned down_u = 15u - texture->width_log2, down_v = 15u - texture->height_log2;
    const int32_t size = s->detail;
    struct quadric qu, qv;
    struct row_left r;
    struct curve u, v;

    rows_begin(&r, t, s);
    sheen_quadric_from(&qu, &m->quadric[0], -m->x, t->first_row - m->y);
    sheen_quadric_from(&qv, &m->quadric[1], -m->x, t->first_row - m->y);
    for (unsigned row = 0; row < t->rows; row++, quadric_down(&qu), quadric_down(&qv)) {
        if (!row_begin(&r, t, s, row))
            continue;
        quadric_run(&qu, r.run.x, &u.value, &u.step, &u.bend);
        quadric_run(&qv, r.run.x, &v.value, &v.step, &v.bend);
        while (r.left > 0) {
            const int32_t count = min32(r.left, size);
            SHEEN_TAP(CURVED_BLOCK, 1);
            r.at.u = u.value >> down_u;
            r.at.v = v.value >> down_v;
            r.step.u = (uint32_t)asr32((int32_t)curve_on(&u, (uint32_t)count), down_u);
            r.step.v = (uint32_t)asr32((int32_t)curve_on(&v, (uint32_t)count), down_v);
            put_block(&r, count);
        }
    }
}

/* ---- normals ---- */

/* The end of a block: the normal there and its texel. */
struct block_end {
    uint32_t n[3];
    uint32_t u, v;
};

/* Finds the texel of e->n, a normal of any length; the picture's middle if it is too short to have a direction. */
HOT static APART void texel_of_normal(struct block_end *e, const struct sheen_texture *t)
{
    int32_t x, y;

    cosines_of(e->n, &x, &y);
    e->u = (uint32_t)texel_at_cosine(x, t->width_log2, texel_edge(t));
    e->v = (uint32_t)texel_at_cosine(-y, t->height_log2, texel_edge(t));
}

/* 2^16 / count. */
static const uint16_t shares[LARGEST_BLOCK + 1] = {
    0,    0,    32768, 21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554, 5958, 5461, 5041, 4681, 4369, 4096,
    3855, 3641, 3449,  3277,  3121,  2979,  2849,  2731, 2621, 2521, 2427, 2341, 2260, 2185, 2114, 2048};

static uint32_t share_to(uint32_t from, uint32_t to, int32_t count)
{
    const int32_t difference = (int32_t)(to - from);

    return (uint32_t)(count == 1 ? difference : mul_16_32(shares[count], difference));
}

/* The row's last block ends at its last pixel, because beyond the triangle there may be no normal. */
static void normal_row(const struct matcap_setup *m, struct row_left *r)
{
    const struct sheen_texture *t = m->s.draw->texel.texture;
    const int32_t size = m->s.detail;
    struct block_end e;

    for (int i = 0; i < 3; i++)
        e.n[i] = plane_at(&m->normal[i], r->run.x, r->run.y);
    texel_of_normal(&e, t);
    while (r->left > 0) {
        const int32_t to = min32(r->left - 1, size);
        SHEEN_TAP(TURNED_BLOCK, 1);
        r->at.u = e.u;
        r->at.v = e.v;
        if (to > 0) {
            for (int i = 0; i < 3; i++)
                e.n[i] += (uint32_t)to * m->normal[i].dx;
            texel_of_normal(&e, t);
            r->step.u = share_to(r->at.u, e.u, to);
            r->step.v = share_to(r->at.v, e.v, to);
        }
        put_block(r, min32(r->left, size));
    }
}

HOT void sheen_matcap_normal_rows(const struct tile *t, const struct setup *s)
{
    const struct matcap_setup *m = (const struct matcap_setup *)s;
    struct row_left r;

    rows_begin(&r, t, s);
    for (unsigned row = 0; row < t->rows; row++)
        if (row_begin(&r, t, s, row))
            normal_row(m, &r);
}
