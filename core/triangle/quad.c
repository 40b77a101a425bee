/*
 * quad.c - whether the intensities at a plane quad's corners, of which a set-up reads only three, are one function.
 */
#include "triangle.h"

/*
 * How far corner 3's intensity is off the plane through the others on the screen, UQ1.15. Range: area[0] is cut to 13
 * bits, and thereby the others to at most 14, so that the products' sum stays below 2^31.
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
 * On the lit side L.N is linear in space, because N is. So any way is right for a quad without a highlight on that
 * side, provided that corner 3 is off the plane of the others by at most 1/8 of a 64th of 1.0; ways that are linear on
 * the screen need that. What they make of corner 3 has to stay between low and high, too.
 */
int sheen_lit_linearly(const struct draw *d, const struct quad *q)
{
    const struct colour_terms *t = &d->colour;
    const uint32_t dark = faint_highlight(t->faint_specular, d->dither), low = t->low > 0 ? t->low : 1;

    for (int k = 0; k < 4; k++) {
        const uint16_t *kept = q->v[k]->kept;
        if (kept[0] < low || kept[0] > t->high || kept[1] > dark)
            return 0;
    }
    const uint32_t off = bent(q), last = q->v[3]->kept[0];
    return off <= t->diffuse_tolerance && last >= low + off && last + off <= t->high;
}
