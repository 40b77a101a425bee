/*
 * slerp_parts.c - rows cut into parts, even on the screen, with what lies at their ends by the arcs' series; and the
 * way by normals, which are linear over a part and brought to length 1 a pixel. What a part is hangs on the row and the
 * triangle alone, so any band gives the same pixels.
 */
#include "../triangle/normal.h"
#include "../triangle/reflection.h"
#include "slerp_row.h"

#define WIDEST_NORMALS 159 /* sin^2(p/2), UQ0.15, of the widest parts: 8 degrees */

/* ---- normals ---- */

void sheen_slerp_normal_place(const struct arc_row *r, int32_t t, struct place *p)
{
    p->weight = r->weight[0];
    if (!r->at->even)
        t = in_space(t, r->weight[0], r->weight[1], &p->weight);
    sheen_arc_at(&r->arc, t, p->part);
}

/* Times weights the normals are linear on the screen, as they are in space without. */
void sheen_slerp_normals(const struct arc_row *r, const struct part *p, const struct place *a, const struct place *b,
                         uint32_t n[3], uint32_t dn[3])
{
    const unsigned up = clz32(a->weight | b->weight) - 16;
    const int32_t w0 = (int32_t)(a->weight << up >> 1), w1 = (int32_t)(b->weight << up >> 1), x = p->x - p->first;

    SHEEN_TAP(NORMAL_PART, 1);
    SHEEN_TAP(SKEWED_PART, !r->at->even);
    for (int i = 0; i < 3; i++) {
        const int32_t from = round15(a->part[i]) * w0, more = asr32(round15(b->part[i]) * w1 - from, 8);
        dn[i] = p->length == 0 ? 0 : (uint32_t)asr32(times8(more, (int32_t)r->inverse), 15 - p->up);
        n[i] = (uint32_t)from + (uint32_t)times15(more, p->t) * 256u + (uint32_t)x * dn[i];
    }
}

static void draw_normals(const struct tile *t, struct arc_row *r, const struct part *p, const struct place *a,
                         const struct place *b)
{
    const struct setup *s = r->s;
    struct normal_run run = {.z = plane_at(&s->depth, p->x, r->y), .dz = s->depth.dx};

    sheen_slerp_normals(r, p, a, b, run.n, run.dn);
    draw_normal_run(t, s->draw, p->x, p->x1, r->y, &run);
}

unsigned sheen_slerp_normal_parts(const struct arc_row *r)
{
    unsigned parts = r->arc.parts == 2;

    if (r->arc.parts == 0)
        return 15;
    while (parts < MOST_PARTS + 2 && r->arc.h > WIDEST_NORMALS << 2 * (parts - (r->arc.parts - 1u)))
        parts++;
    return parts;
}

/* ---- rows ---- */

void sheen_slerp_begin_row(const struct tile *t, struct arc_row *r, const struct arc arc[2], unsigned other,
                           int32_t centre)
{
    const unsigned right = r->at->long_right; /* of edge 02 */
    struct crossing at[2];
    int16_t normal[2][3];

    for (unsigned j = 0; j < 2; j++) {
        const unsigned side = j ^ right;
        int32_t n[3];
        sheen_slerp_cross(r->at, j * other, centre, &at[side]);
        r->weight[side] = at[side].weight;
        sheen_arc_at(&arc[j], at[side].t, n);
        for (int i = 0; i < 3; i++)
            normal[side][i] = (int16_t)min32(max32(round15(n[i]), -32767), 32767);
    }
    sheen_arc_begin(&r->arc, normal[0], normal[1]);
    for (int side = 0; r->s->way == SHEEN_WAY_SLERP && side < 2; side++) {
        uint16_t kept[2];
        sheen_keep_cosines(r->s->draw, normal[side], kept);
        r->cosine[side][0] = (int16_t)kept[0];
        r->cosine[side][1] = (int16_t)kept[1];
    }
    r->from = at[0].x + t->centre_x * 1024;
    r->width = max32(at[1].x - at[0].x, 1);
    r->up = clz32((uint32_t)r->width);
    r->inverse = reciprocal_seed((uint32_t)r->width << r->up);
}

static unsigned parts_of(const struct arc_row *r)
{
    return r->s->way == SHEEN_WAY_SLERP ? sheen_slerp_lit_parts(r) : sheen_slerp_normal_parts(r);
}

static void find_place(const struct arc_row *r, int32_t t, struct place *p)
{
    if (r->s->way == SHEEN_WAY_SLERP)
        sheen_slerp_lit_place(r, t, p);
    else
        sheen_slerp_normal_place(r, t, p);
}

static void draw_between(const struct tile *t, struct arc_row *r, const struct part *p, const struct place *a,
                         const struct place *b)
{
    if (r->s->way == SHEEN_WAY_SLERP)
        sheen_slerp_draw_lit(t, r, p, a, b);
    else
        draw_normals(t, r, p, a, b);
}

static const struct arc_way plain_arcs = {parts_of, find_place, draw_between};

static APART void draw_plain_row(const struct tile *t, struct arc_row *r, const struct span *span)
{
    arc_row(t, r, span, plain_arcs);
}

void sheen_slerp_rows(const struct tile *t, const struct setup *s)
{
    struct arc_row r;

    r.s = s;
    r.at = &((const struct slerp_setup *)s)->at;
    arc_rows(t, &r, draw_plain_row);
}
