/*
 * quad.c - whether intensities at the corners of a plane quad, of which a set-up knows three, are one function of it.
 */
#include "triangle.h"

/*
 * What corner 3 has beyond what is linear on the screen, UQ1.15. Range: areas are cut to 13 bits and the others to 14,
 * so that all products stay below 2^31 in all.
 */
static uint32_t bent(const struct quad *q)
{
    const int32_t d1 = q->v[1]->kept[0] - q->v[0]->kept[0], d2 = q->v[2]->kept[0] - q->v[0]->kept[0],
                  d3 = q->v[3]->kept[0] - q->v[0]->kept[0];
    unsigned down = 0;

    while (q->area[0] >> down >= 1 << 13)
        down++;
    const int32_t area = asr32(q->area[0], down);
    const int32_t more = d3 * area - d1 * asr32(q->area[1], down) - d2 * asr32(q->area[2], down);
    return QUOTIENT(magnitude32(more), (uint32_t)area);
}

/*
 * On the lit side L.N is linear in space as N is. So any way will do for a quad that has no highlight there and, for
 * ways that are linear on the screen, is so within 1/8 of a 64th of 1.0. What they make of corner 3 stays inside too.
 */
int sheen_lit_linearly(const struct draw *d, const struct quad *q)
{
    const struct colour_terms *t = &d->colour;
    const uint32_t dark = faint_highlight(t->dim, d->dither), low = t->low > 0 ? t->low : 1;

    for (int k = 0; k < 4; k++) {
        const uint16_t *kept = q->v[k]->kept;
        if (kept[0] < low || kept[0] > t->high || kept[1] > dark)
            return 0;
    }
    const uint32_t off = bent(q), last = q->v[3]->kept[0];
    return off <= t->eighth && last >= low + off && last + off <= t->high;
}
