/*
 * clip.c - triangles that leave the view volume are cut in eye space, once, in
 * sheen_draw(): near and far plane, then the guard band's four sides.
 *
 * A corner's flags say which side of a plane it lies on. A corner inside is never
 * moved, because an uncut neighbour has the same corner. An edge is always cut
 * from its inner end, so two triangles that share it get the same point. The sides
 * cut at 510.5 px, so that the point lies inside the guard band of 511 px; if raw
 * steps are coarser than half a px it is held at that band's limits.
 *
 * Attributes are linear in space, so that a cut does not change them. In an affine
 * view they are linear on the screen: there a cut point's shares follow from where it
 * lies on the projected edge. Points on the near plane are an exception, because the
 * other end of their edge has no place on the screen; they count like the triangle's
 * own corners.
 *
 * A polygon of exact corners crosses a plane at most twice. One of rounded corners
 * may wind about the plane; then only one run of its corners is kept, so that a plane
 * that adds two corners removes at least one: MAX_CLIP_CORNERS = 3 + CLIP_PLANES.
 */
#include "vertex.h"

#define CUT_SIDE (511 * 2 - 1) /* half px */

/* Distance inside a plane (0..5: the order of enum vertex_flag): a Q.24 length, for a side in some scale of the job. */
static APART int64_t inside(const struct clip_job *job, const struct clip_corner *corner, unsigned plane)
{
    const struct projection *p = job->projection;
    const struct point *point = &corner->point;
    int exponent = p->focal.exponent - (int)job->transform->fine;
    int64_t m = point->m;

    if (plane == 0)
        return m - p->near;
    if (plane == 1)
        return p->far - m;
    /* |x| focal <= side m; orthographic, with a fixed m. Range: 2^31 * 2^16, 2^31 * 2^24 */
    int64_t across = (int64_t)(plane < 4 ? point->x : point->y) * (1 << 16);
    int64_t side = (p->orthographic != 0 ? p->orthographic : m) * CUT_SIDE << 14;
    if (exponent >= 0)
        side = asr64(side, (unsigned)exponent);
    else
        across = asr64(across, (unsigned)-exponent);
    return (plane & 1u) == 0 ? side + across : side - across;
}

static APART int32_t between(int32_t a, int32_t b, int32_t t)
{
    return (int32_t)(a + round_shift64(((int64_t)b - a) * t, 30));
}

/* part / whole, Q1.30. 0 <= part <= whole, whole > 0. */
static int32_t fraction_of(int64_t part, int64_t whole)
{
    unsigned bits = 64 - clz64((uint64_t)whole), drop = bits > 32 ? bits - 32 : 0;

    return (int32_t)(sheen_ratio((uint32_t)(part >> drop), (uint32_t)(whole >> drop)) >> 2);
}

/* How far along the projected edge a point t of the way in space lies: t mb / ((1 - t) ma + t mb), both m > 0. */
static int32_t on_screen(int32_t t, int64_t ma, int64_t mb)
{
    int64_t part = t * mb; /* < 2^61 */

    return fraction_of(part, part + ((1 << 30) - t) * ma);
}

/* The point of the edge from a (inside) to b (outside) that lies on the plane. */
static void cut_edge(const struct clip_job *job, const struct clip_corner *a, const struct clip_corner *b,
                     unsigned plane, struct clip_corner *out)
{
    const struct projection *p = job->projection;
    int64_t da = inside(job, a, plane), db = inside(job, b, plane);
    /* a corner may lie on another side of the cut than its flags say: then the cut is at that corner */
    int32_t t = da > 0 ? fraction_of(da, db < 0 ? da - db : da) : 0;
    int32_t share = job->on_screen ? on_screen(t, a->point.m, b->point.m) : t;

    for (int k = 0; k < 3; k++)
        out->share[k] = between(a->share[k], b->share[k], share);
    out->point.x = between(a->point.x, b->point.x, t);
    out->point.y = between(a->point.y, b->point.y, t);
    out->point.m = plane == 0 ? p->near : plane == 1 ? p->far : between(a->point.m, b->point.m, t);
    sheen_project(p, job->transform->screen_shift, &out->point, &out->v);
}

/* Masks of corners: among those not in `out`, the run around the one that lies deepest inside the plane. */
static unsigned deepest_run(const struct clip_job *job, unsigned plane, unsigned out)
{
    const unsigned count = job->count;
    unsigned run = 0;
    int64_t depth = INT64_MIN;

    for (unsigned i = 0; i < count; i++) {
        int64_t here = inside(job, &job->polygon[i], plane);
        if ((out >> i & 1u) == 0 && here > depth) {
            depth = here;
            run = 1u << i;
        }
    }
    for (unsigned i = 0; i < count; i++) /* adds a neighbour on either side; bits beyond the corners are masked off */
        run = (run | run << 1 | run >> 1 | run << (count - 1) | run >> (count - 1)) & ~out & ((1u << count) - 1);
    return run;
}

/* The corners outside a plane, a bit each: none, or one run, which may wrap around, so that the rest is one run too. */
static unsigned corners_outside(const struct clip_job *job, unsigned plane)
{
    unsigned out = 0, count = job->count, all = (1u << count) - 1;

    for (unsigned i = 0; i < count; i++)
        out |= (unsigned)(job->polygon[i].v.flags >> plane & 1) << i;
    unsigned ends = out & ~(out >> 1 | out << (count - 1)); /* each run's last corner; after the last comes the first */
    return (ends & (ends - 1)) == 0 ? out : all & ~deepest_run(job, plane, out);
}

/*
 * Sutherland and Hodgman's step: cuts the polygon by a plane. Returns the number of corners: at most one more than
 * before, because one run of at least one corner is replaced by the two points where the edges enter and leave it.
 */
static unsigned cut_polygon(const struct clip_job *job, unsigned plane)
{
    const struct clip_corner *in = job->polygon;
    unsigned outside = corners_outside(job, plane), kept = 0;

    for (unsigned i = 0; i < job->count; i++) {
        unsigned next = i + 1 < job->count ? i + 1 : 0;
        const struct clip_corner *a = &in[i], *b = &in[next];
        int a_out = (outside >> i & 1u) != 0, b_out = (outside >> next & 1u) != 0;
        if (!a_out)
            job->next[kept++] = *a;
        if (a_out && !b_out)
            cut_edge(job, b, a, plane, &job->next[kept++]);
        else if (!a_out && b_out)
            cut_edge(job, a, b, plane, &job->next[kept++]);
    }
    return kept;
}

void sheen_clip(struct clip_job *job, unsigned first, unsigned end)
{
    for (unsigned plane = first; plane < end && job->count >= 3; plane++) {
        struct clip_corner *swapped = job->polygon;
        job->count = cut_polygon(job, plane);
        job->polygon = job->next;
        job->next = swapped;
    }
}

int64_t sheen_twice_area(const struct vertex *a, const struct vertex *b, const struct vertex *c)
{
    int32_t x1 = b->x - a->x, y1 = b->y - a->y, x2 = c->x - a->x, y2 = c->y - a->y;

    if ((((uint32_t)(x1 + 32768) | (uint32_t)(y1 + 32768) | (uint32_t)(x2 + 32768) | (uint32_t)(y2 + 32768)) >> 16) ==
        0)
        return x1 * y2 - y1 * x2; /* spans under 512 px: products < 2^30 */
    return (int64_t)x1 * y2 - (int64_t)y1 * x2;
}

COLD int sheen_clip_line(const struct clip_job *job, struct clip_corner end[2])
{
    for (unsigned plane = 0; plane < CLIP_PLANES; plane++) {
        const unsigned first = (unsigned)end[0].v.flags >> plane & 1u, second = (unsigned)end[1].v.flags >> plane & 1u;
        struct clip_corner cut;
        if (first && second)
            return 0;
        if (first == second)
            continue;
        cut_edge(job, &end[first], &end[second], plane, &cut);
        end[second] = cut;
    }
    return 1;
}
