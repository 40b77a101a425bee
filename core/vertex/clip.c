/*
 * clip.c - triangles that leave the view volume are cut in eye space, once, in
 * sheen_draw(): near and far plane, then the guard band's four sides.
 *
 * Which side a corner lies on is what its flags say, and a corner inside is never
 * moved: a neighbour that was not cut has the same corner. An edge is always cut
 * from its inner end, so two triangles that share it get the same point. The
 * sides cut at 510.5 px, so that the point lies inside the guard band of 511.
 *
 * Attributes are linear in space, so that a cut changes none of them. Under affine
 * they are linear on the screen: there a point counts by where it lies on the
 * screen's edge, but for those that the near plane makes, which have no other end
 * there; they are corners like the triangle's own.
 *
 * A polygon of exact corners crosses a plane at most twice. One of rounded corners
 * may wind about the plane; only one run of its corners is then kept, so a plane
 * takes at least one corner away where it adds two: MAX_CLIP_CORNERS = 3 + PLANES.
 */
#include <string.h>

#include "../frame/frame.h"

#define CUT_SIDE (511 * 2 - 1) /* half px */
#define PLANES (MAX_CLIP_CORNERS - 3)

/* A corner of the polygon that is left of a triangle. */
struct clip_corner {
    sheen_q24_t eye[3];
    int32_t share[3]; /* of the triangle's corners in its attributes, Q1.30 */
    struct vertex v;
};

/* What is left of a triangle, and how it is cut. */
struct clip_job {
    const struct projection *projection;
    int on_screen; /* shares are linear on the screen, not in space */
    struct clip_corner *polygon, *next;
    unsigned count; /* of corners; below 3 nothing is left */
};

/* Distance inside plane p (0..5: the order of enum vertex_flag), Q.24 lengths, any common scale for a side. */
static int64_t inside(const struct projection *p, const sheen_q24_t eye[3], unsigned plane)
{
    int64_t m = -(int64_t)eye[2];

    if (plane == 0)
        return m - p->near;
    if (plane == 1)
        return p->far - m;
    /* |x| focal <= side m, m fixed in an orthographic view. Range, with 16 bits of focal: 2^31 * 2^16, 2^31 * 2^24 */
    int64_t coordinate = plane < 4 ? eye[0] : -(int64_t)eye[1];
    int64_t across = coordinate * (int64_t)(p->focal.mantissa >> 16);
    int64_t side = (p->orthographic != 0 ? p->orthographic : m) * CUT_SIDE << 14;
    if (p->focal.exponent >= 0)
        side = asr64(side, (unsigned)p->focal.exponent);
    else
        across = asr64(across, (unsigned)-p->focal.exponent);
    return (plane & 1u) == 0 ? side + across : side - across;
}

static int32_t between(int32_t a, int32_t b, int32_t t)
{
    return (int32_t)(a + round_shift64(((int64_t)b - a) * t, 30));
}

/* part / whole, Q1.30. 0 <= part <= whole, whole > 0. */
static int32_t fraction_of(int64_t part, int64_t whole)
{
    unsigned bits = 64 - clz64((uint64_t)whole), drop = bits > 32 ? bits - 32 : 0;

    return (int32_t)(sheen_ratio((uint32_t)(part >> drop), (uint32_t)(whole >> drop)) >> 2);
}

/* Where on the screen's edge the point lies that is t of the way in space: t mb / ((1 - t) ma + t mb), both m > 0. */
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
    int64_t da = inside(p, a->eye, plane), db = inside(p, b->eye, plane);
    int32_t t =
        da > 0 ? fraction_of(da, da - db) : 0; /* inside by its flags it may lie beyond the cut: then it is it */
    int32_t share = job->on_screen ? on_screen(t, -(int64_t)a->eye[2], -(int64_t)b->eye[2]) : t;

    for (int k = 0; k < 3; k++) {
        out->eye[k] = between(a->eye[k], b->eye[k], t);
        out->share[k] = between(a->share[k], b->share[k], share);
    }
    if (plane < 2)
        out->eye[2] = -(plane == 0 ? p->near : p->far);
    sheen_project(p, out->eye, &out->v);
}

/* Of the corners that `out` does not name, a bit each, the run around the one that lies deepest inside the plane. */
static unsigned deepest_run(const struct projection *p, const struct clip_corner *in, unsigned count, unsigned plane,
                            unsigned out)
{
    unsigned deepest = 0, run;
    int64_t depth = INT64_MIN;

    for (unsigned i = 0; i < count; i++) {
        int64_t here = inside(p, in[i].eye, plane);
        if ((out >> i & 1u) == 0 && here > depth) {
            depth = here;
            deepest = i;
        }
    }
    run = 1u << deepest;
    for (unsigned i = deepest; (out >> (i = i + 1 < count ? i + 1 : 0) & 1u) == 0;)
        run |= 1u << i;
    for (unsigned i = deepest; (out >> (i = i > 0 ? i - 1 : count - 1) & 1u) == 0;)
        run |= 1u << i;
    return run;
}

/* The corners outside a plane, a bit each: none, or one run (round the end too), so that the rest is one as well. */
static unsigned corners_outside(const struct projection *p, const struct clip_corner *in, unsigned count,
                                unsigned plane)
{
    unsigned out = 0, all = (1u << count) - 1;

    for (unsigned i = 0; i < count; i++)
        out |= (unsigned)(in[i].v.flags >> plane & 1) << i;
    unsigned ends = out & ~(out >> 1 | out << (count - 1)); /* each run's last corner; after the last comes the first */
    return (ends & (ends - 1)) == 0 ? out : all & ~deepest_run(p, in, count, plane, out);
}

/*
 * Sutherland and Hodgman's step: what of `in` lies inside a plane. Returns the number of corners: at most one more
 * than before, for one run of at least one corner gives way to the two points where the edges enter and leave it.
 */
static unsigned cut_polygon(const struct clip_job *job, unsigned plane)
{
    const struct clip_corner *in = job->polygon;
    unsigned outside = corners_outside(job->projection, in, job->count, plane), kept = 0;

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

/* The planes from `first` to before `end`. */
static void cut(struct clip_job *job, unsigned first, unsigned end)
{
    for (unsigned plane = first; plane < end && job->count >= 3; plane++) {
        struct clip_corner *swapped = job->polygon;
        job->count = cut_polygon(job, plane);
        job->polygon = job->next;
        job->next = swapped;
    }
}

/* The corners of a mesh's triangle in eye space, and their normals. */
static void triangle_corners(const struct sheen_frame *f, const struct draw_record *d, const struct transform *t,
                             uint16_t triangle, struct clip_corner corner[3], const int16_t *normal[3])
{
    for (uint32_t k = 0; k < 3; k++) {
        uint32_t index = mesh_index(d->as.mesh, 3u * triangle + k);
        sheen_transform_point(t, d->as.mesh->positions + 3 * index, corner[k].eye);
        corner[k].v = f->vertex[d->first_vertex + index];
        for (uint32_t i = 0; i < 3; i++)
            corner[k].share[i] = i == k ? 1 << 30 : 0;
        normal[k] = d->as.mesh->normals != NULL ? d->as.mesh->normals + 3 * index : NULL;
    }
}

/* Intensities of the triangle's corners for the side that is seen; pieces store what lies between. */
static void light_triangle(const struct draw_record *d, const int16_t *const normal[3], int back, uint16_t lit[3][2])
{
    for (int k = 0; k < 3; k++) {
        int16_t seen[3];
        for (int i = 0; i < 3; i++)
            seen[i] = (int16_t)(back ? -max32(normal[k][i], -32767) : normal[k][i]);
        d->as.shader->light(&d->as, seen, lit[k]);
    }
}

static int32_t shared(const int32_t share[3], int32_t a, int32_t b, int32_t c)
{
    return (int32_t)round_shift64((int64_t)share[0] * a + (int64_t)share[1] * b + (int64_t)share[2] * c, 30);
}

/* A corner as pieces store it; unit: slerp goes from unit vector to unit vector. */
static void piece_corner(const struct clip_corner *from, const int16_t *const normal[3], uint16_t lit[3][2], int unit,
                         struct vertex *v, int16_t out[3])
{
    *v = from->v;
    v->flags = LIT | LIT_AS_SEEN;
    if (normal[0] == NULL)
        return;
    int32_t n[3];
    for (int i = 0; i < 3; i++)
        n[i] = out[i] = (int16_t)shared(from->share, normal[0][i], normal[1][i], normal[2][i]);
    if (unit && sheen_normalize(n, n) == SHEEN_OK)
        for (int i = 0; i < 3; i++)
            out[i] = (int16_t)min32(asr32(n[i] + (1 << 14), 15), 32767);
    for (int i = 0; i < 2; i++)
        v->kept[i] = (uint16_t)max32(0, shared(from->share, lit[0][i], lit[1][i], lit[2][i]));
}

/* Twice the area of what is left, as twice_area; 0 where nothing is. */
static int64_t area_left(const struct clip_job *job)
{
    int64_t area = 0;

    for (unsigned i = 1; i + 1 < job->count; i++)
        area += twice_area(&job->polygon[0].v, &job->polygon[i].v, &job->polygon[i + 1].v);
    return area;
}

/*
 * List the fan of what is left. whole: area of all that is left of the triangle; its side decides, a sliver of the
 * fan that snapping turned over is left out. Returns 0 or SHEEN_ERR_CAPACITY.
 */
static int list_pieces(struct sheen_frame *f, const struct draw_record *d, uint16_t triangle,
                       const struct clip_job *job, int64_t whole, const int16_t *const normal[3])
{
    uint16_t lit[3][2] = {{0, 0}, {0, 0}, {0, 0}};

    if (d->as.shader->light != NULL)
        light_triangle(d, normal, whole > 0, lit);
    for (unsigned i = 1; i + 1 < job->count; i++) {
        const struct clip_corner *fan[3] = {&job->polygon[0], &job->polygon[i], &job->polygon[i + 1]};
        const struct vertex *const v[3] = {&fan[0]->v, &fan[1]->v, &fan[2]->v};
        int64_t area = twice_area(v[0], v[1], v[2]);
        if (area == 0 || (area > 0) != (whole > 0))
            continue;
        int listed = f->pieces == f->config.max_clipped ? sheen_bin_would_list(f, v) ? SHEEN_ERR_CAPACITY : 0
                                                        : sheen_bin_triangle(f, v, f->pieces, 1);
        if (listed < 0)
            return listed;
        if (listed == 0)
            continue;
        struct piece *piece = &f->piece[f->pieces++];
        piece->triangle = triangle;
        for (int k = 0; k < 3; k++)
            piece_corner(fan[k], normal, lit, d->as.shader->unit_normals, &piece->corner[k], piece->normal[k]);
    }
    return SHEEN_OK;
}

/* 1 where the side that is seen is drawn; whole: area of all that is left. */
static int is_drawn(struct sheen_frame *f, const struct draw_record *d, int64_t whole)
{
    if (whole == 0 || (whole > 0 && !d->as.two_sided))
        return 0;
    f->stats.front++;
    return 1;
}

/*
 * On the screen the four corners that the near plane may leave are two triangles, each linear by itself. Two rounds:
 * the side is that of both together.
 */
static int clip_halves(struct sheen_frame *f, const struct draw_record *d, uint16_t triangle, struct clip_job *job,
                       const int16_t *const normal[3])
{
    struct clip_corner quad[4];
    int64_t whole = 0;
    int status = SHEEN_OK;

    memcpy(quad, job->polygon, sizeof quad);
    for (unsigned round = 0; round < 4 && status == SHEEN_OK; round++) {
        job->polygon[0] = quad[0];
        job->polygon[1] = quad[1 + round % 2];
        job->polygon[2] = quad[2 + round % 2];
        job->count = 3;
        cut(job, 1, PLANES);
        if (round < 2)
            whole += area_left(job);
        else if (round > 2 || is_drawn(f, d, whole))
            status = list_pieces(f, d, triangle, job, whole, normal);
        else
            break;
    }
    return status;
}

int sheen_clip(struct sheen_frame *f, const struct draw_record *d, const struct transform *t, uint16_t triangle)
{
    struct clip_corner *scratch = f->scratch;
    struct clip_job job = {&f->projection, 0, scratch, scratch + MAX_CLIP_CORNERS, 3};
    const int16_t *normal[3];

    triangle_corners(f, d, t, triangle, job.polygon, normal);
    f->stats.clipped++;
    cut(&job, 0, 1);
    /* slerp has its corners' normals linear in space, and without perspective there is no difference */
    job.on_screen = f->view.affine && !d->as.shader->unit_normals && f->projection.orthographic == 0;
    if (job.on_screen && job.count == 4)
        return clip_halves(f, d, triangle, &job, normal);
    cut(&job, 1, PLANES);
    int64_t whole = area_left(&job);
    return is_drawn(f, d, whole) ? list_pieces(f, d, triangle, &job, whole, normal) : SHEEN_OK;
}

size_t sheen_clip_scratch_bytes(void)
{
    return 2 * MAX_CLIP_CORNERS * sizeof(struct clip_corner);
}
