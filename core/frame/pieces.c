/*
 * pieces.c - lists what is left of triangles that leave the view volume; vertex/clip.c cuts them.
 */
#include <string.h>

#include "frame.h"

/* The corners of a mesh's triangle in eye space, and their normals. */
static void triangle_corners(const struct sheen_frame *f, const struct draw_record *d, const struct transform *t,
                             uint16_t triangle, struct clip_corner corner[3], const int16_t *normal[3])
{
    for (uint32_t k = 0; k < 3; k++) {
        uint32_t index = mesh_index(d->as.mesh, 3u * triangle + k);
        corner[k].point = sheen_transform_point(t, d->as.mesh->positions + 3 * index);
        corner[k].v = *used_vertex(f, d, index);
        for (uint32_t i = 0; i < 3; i++)
            corner[k].share[i] = i == k ? 1 << 30 : 0;
        normal[k] = d->as.mesh->normals != NULL ? d->as.mesh->normals + 3 * index : NULL;
    }
}

/* Attributes of the triangle's corners; pieces store values interpolated between them. */
struct attributes {
    const int16_t *normal[3];
    uint16_t lit[3][2];
    int16_t carried[3][3];
};

/* Light the corners for the side that is seen, and fill in what the shader carries in place of normals. */
static void light_triangle(const struct draw_record *d, uint16_t triangle, int back, struct attributes *a)
{
    const struct sheen_shader *shader = d->as.shader;

    for (int k = 0; k < 3; k++) {
        int16_t seen[3];
        for (int i = 0; shader->light != NULL && i < 3; i++)
            seen[i] = (int16_t)(back ? -max32(a->normal[k][i], -32767) : a->normal[k][i]);
        a->lit[k][0] = a->lit[k][1] = 0;
        if (shader->light != NULL)
            shader->light(&d->as, seen, a->lit[k]);
    }
    if (shader->carry == NULL)
        return;
    shader->carry(&d->as, triangle, back, a->carried);
    for (int k = 0; k < 3; k++)
        a->normal[k] = a->carried[k];
}

static APART int32_t shared(const int32_t share[3], int32_t a, int32_t b, int32_t c)
{
    return (int32_t)round_shift64((int64_t)share[0] * a + (int64_t)share[1] * b + (int64_t)share[2] * c, 30);
}

/* A corner as pieces store it; unit: the shader's unit_normals. */
static void piece_corner(const struct clip_corner *from, const struct attributes *a, int unit, struct vertex *v,
                         int16_t out[3])
{
    const int16_t *const *normal = a->normal;

    *v = from->v;
    v->flags = (uint16_t)(LIT | LIT_AS_SEEN | (from->v.flags & OFF_VIEW));
    if (normal[0] == NULL)
        return;
    int32_t n[3];
    for (int i = 0; i < 3; i++)
        n[i] = out[i] = (int16_t)shared(from->share, normal[0][i], normal[1][i], normal[2][i]);
    if (unit == UNIT_IN_SPACE && sheen_normalize(n, n) == SHEEN_OK)
        for (int i = 0; i < 3; i++)
            out[i] = (int16_t)min32(asr32(n[i] + (1 << 14), 15), 32767);
    for (int i = 0; i < 2; i++)
        v->kept[i] = (uint16_t)max32(0, shared(from->share, a->lit[0][i], a->lit[1][i], a->lit[2][i]));
}

/* Twice the area of triangle i >= 1 of the polygon's fan. */
static APART int64_t fan_area(const struct clip_job *job, unsigned i)
{
    const struct clip_corner *p = job->polygon;

    return sheen_twice_area(&p[0].v, &p[i].v, &p[i + 1].v);
}

/* Twice the area of what is left; 0 if nothing is left. */
static int64_t area_left(const struct clip_job *job)
{
    int64_t area = 0;

    for (unsigned i = 1; i + 1 < job->count; i++)
        area += fan_area(job, i);
    return area;
}

/*
 * List what is left as a fan. whole: twice the area of all that is left of the triangle; its sign tells which side is
 * seen, and slivers of the fan that snapping turned over are left out. Pieces that find no room are counted.
 */
static APART void list_pieces(struct sheen_frame *f, const struct draw_record *d, uint16_t triangle,
                              const struct clip_job *job, int64_t whole, const struct attributes *a)
{
    for (unsigned i = 1; i + 1 < job->count; i++) {
        const struct clip_corner *fan[3] = {&job->polygon[0], &job->polygon[i], &job->polygon[i + 1]};
        const struct vertex *const v[4] = {&fan[0]->v, &fan[1]->v, &fan[2]->v};
        int64_t area = fan_area(job, i);
        if (area == 0 || (area > 0) != (whole > 0))
            continue;
        if (!sheen_bin_triangle(f, v, f->pieces, OFF_VIEW | LIT_AS_SEEN))
            continue;
        if (f->pieces == f->config.max_clipped) {
            f->pieces_short++;
            continue;
        }
        struct piece *piece = &f->piece[f->pieces++];
        piece->triangle = triangle;
        for (int k = 0; k < 3; k++)
            piece_corner(fan[k], a, d->as.shader->unit_normals, &piece->corner[k], piece->normal[k]);
    }
}

/* Whether the side that is seen is drawn; if so, it is lit. whole: as in list_pieces(). */
static int is_drawn(struct sheen_frame *f, const struct draw_record *d, uint16_t triangle, int64_t whole,
                    struct attributes *a)
{
    if (whole == 0 || (whole > 0 && !d->as.two_sided))
        return 0;
    f->count.front++;
    light_triangle(d, triangle, whole > 0, a);
    return 1;
}

/*
 * If attributes are linear on the screen, the four corners that the near plane may leave are two parts, triangles that
 * are each linear by itself; otherwise what it leaves is one part. The loop goes over the parts twice, first for their
 * area, since the sign of the whole tells which side is seen, then to list them. The four corners are kept in worker
 * 0's set-ups, which follow its scratch and are not in use while draws are accepted.
 */
_Static_assert(SHEEN_BYTES_CLIPPING == 2 * MAX_CLIP_CORNERS * sizeof(struct clip_corner) &&
                   SETUP_BYTES >= 4 * sizeof(struct clip_corner),
               "four corners find room");
static void cut_parts(struct sheen_frame *f, const struct draw_record *d, uint16_t triangle, struct clip_job *job,
                      struct attributes *a)
{
    struct clip_corner *quad = (struct clip_corner *)f->scratch + 2 * MAX_CLIP_CORNERS;
    const unsigned parts = job->on_screen && job->count == 4 ? 2 : 1;
    int64_t whole = 0;

    if (parts > 1)
        memcpy(quad, job->polygon, 4 * sizeof *quad);
    for (unsigned round = 0; round < 2 * parts; round++) {
        if (parts > 1) {
            job->polygon[0] = quad[0];
            job->polygon[1] = quad[1 + round % 2];
            job->polygon[2] = quad[2 + round % 2];
            job->count = 3;
        }
        if (parts > 1 || round == 0)
            sheen_clip(job, 1, CLIP_PLANES);
        if (round < parts)
            whole += area_left(job);
        else if (round > parts || is_drawn(f, d, triangle, whole, a))
            list_pieces(f, d, triangle, job, whole, a);
        else
            return;
    }
}

static COLD void cut_triangle(struct sheen_frame *f, const struct draw_record *d, const struct transform *t,
                              uint16_t triangle)
{
    struct clip_corner *scratch = f->scratch;
    struct clip_job job = {&f->projection, t, 0, scratch, scratch + MAX_CLIP_CORNERS, 3};
    struct attributes a;

    triangle_corners(f, d, t, triangle, job.polygon, a.normal);
    if (d->as.morph != NULL)
        d->as.morph->morpher->cut(&d->as, &job, triangle, a.normal, a.carried);
    f->count.clipped++;
    sheen_clip(&job, 0, 1);
    /* slerp's normals are linear in space; without perspective, space and screen do not differ */
    job.on_screen = f->view.affine && !d->as.shader->unit_normals && f->projection.orthographic == 0;
    cut_parts(f, d, triangle, &job, &a);
}

static void piece_corners(const struct piece *piece, struct corners *c)
{
    c->triangle = piece->triangle;
    c->v[3] = NULL;
    for (unsigned k = 0; k < 3; k++) {
        c->v[k] = &piece->corner[clockwise_corner(k)];
        c->normal[k] = piece->normal[clockwise_corner(k)];
    }
}

const struct sheen_clipper sheen_clipper = {cut_triangle, piece_corners};
