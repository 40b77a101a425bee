/*
 * slerp_rows.c - normals on great arcs along edges and rows: two multiplications
 * a light and pixel, no root.
 */
#include "slerp.h"

/* The next pixel of x'' = -e x: x (Q1.30 or Q2.29) cut to 17 bits times 15 of e, over 2^(15 + shift). */
SPECIALISED void recur(int32_t *x, int32_t *step, uint32_t law, unsigned shift)
{
    *x += *step;
    *step -= asr32(asr32(*x, 15) * (int32_t)law, shift);
}

/* Sum over the lights, each with its weight; the states move to the next pixel. */
SPECIALISED void light_step(const struct slerp_setup *s, const struct slerp_row *row, struct arc_block *block,
                            int wanted, struct lit *lit)
{
    const struct lighting *l = &s->s.draw->light;
    uint32_t diffuse = 0, specular = 0; /* UQ2.30: weights sum to 1.0 */

    for (unsigned i = 0; i < l->count; i++) {
        struct arc_state *at = &block->state[i];
        if (wanted && at->light > 0) {
            uint32_t ln = (uint32_t)min32((at->light + (1 << 14)) >> 15, 32768);
            diffuse += l->diffuse_weight[i] * ln;
            /* 1 - R.V, Q2.29 */
            int32_t u = (int32_t)((1u << 29) - (uint32_t)row->light[i].mean - (uint32_t)at->reflected);
            specular += l->specular_weight[i] * highlight_at(s->s.draw->power, u, ln);
        }
        recur(&at->light, &at->light_step, block->light_law, block->light_law_shift);
        recur(&at->reflected, &at->reflected_step, block->reflected_law, block->reflected_law_shift);
    }
    lit->diffuse = (diffuse + (1u << 14)) >> 15;
    lit->specular = (specular + (1u << 14)) >> 15;
}

/* length pixels of row y from x on. */
void sheen_slerp_block(const struct tile *t, const struct slerp_setup *s, const struct slerp_row *row,
                       struct arc_block *block, int32_t x, int32_t y, unsigned length)
{
    const struct colour_terms *terms = &s->s.draw->colour;
    struct rounding rounding = rounding_of(t, terms, y);
    uint32_t at = tile_offset(t, x, y), z = plane_at(&s->s.depth, x, y);

    for (unsigned i = 0; i < length; i++, x++, at++, z += s->s.depth.dx) {
        struct lit lit;
        int seen = nearer(t, t->depth + at, z);
        light_step(s, row, block, seen, &lit);
        if (seen)
            put_general(t, terms, rounding, at, x, colour_channel(terms, 0, &lit), colour_channel(terms, 1, &lit),
                        colour_channel(terms, 2, &lit));
    }
}
