/*
 * quads.c - two triangles of a plane polygon that are listed, and so set up and drawn, as one.
 */
#include "../triangle/reflection.h"
#include "frame.h"

/*
 * The value of d->quads. Shaders that need vertices' normals take quads over which these are linear in space, so none
 * in affine views, which interpolate on the screen. Two-sided objects and morphs have no viewpoint, and so no quads.
 */
static uint8_t most_warp(const struct sheen_frame *f, const struct draw *d)
{
    const enum quads_taken taken = (enum quads_taken)d->shader->quads;

    if (taken == QUADS_NONE || f->forced != 0 || d->mesh->polygons == NULL || d->mesh->triangles > QUAD)
        return 0;
    if (taken == QUADS_ANY)
        return SHEEN_WARP_PLANE;
    if (f->view.affine)
        return 0;
    if (taken == QUADS_LIT)
        return d->light.count == 1 && d->light.ramp == NULL ? SHEEN_WARP_PLANE - 1 : 0;
    return sheen_most_bend(d, taken == QUADS_CLOSE ? CLOSE_ARCS : (uint32_t)d->most_apart << 21);
}

/* The corners of triangles i and i + 1, in struct quad's order; 0 if they are not a fan of one polygon. */
static inline int fan_at(const struct sheen_mesh *mesh, uint32_t i, uint32_t index[4])
{
    if (i + 1 >= mesh->triangles || mesh->polygons[i + 1] != mesh->polygons[i])
        return 0;
    index[0] = mesh_index(mesh, 3 * i);
    index[1] = mesh_index(mesh, 3 * i + 5);
    index[2] = mesh_index(mesh, 3 * i + 1);
    index[3] = mesh_index(mesh, 3 * i + 2);
    return index[0] == mesh_index(mesh, 3 * i + 3) && index[3] == mesh_index(mesh, 3 * i + 4);
}

#define DEPTH_SLACK 64 /* z16 */

/*
 * Whether corner 3's depth is within DEPTH_SLACK of what the plane of the other corners gives there, and at least as
 * far before the far plane. Range: depths' differences < 2^16, areas of 13 bits.
 */
static APART int depth_is_near(const struct vertex *const v[4], const int32_t area[3])
{
    const int32_t z = v[0]->z;
    unsigned down = 0;

    while (area[0] >> down >= 1 << 12)
        down++;
    const int32_t base = asr32(area[0], down), more = (v[3]->z - z) * base - (v[1]->z - z) * asr32(area[1], down) -
                                                      (v[2]->z - z) * asr32(area[2], down);
    return magnitude32(more) <= (uint32_t)(base * DEPTH_SLACK) && v[3]->z >= DEPTH_FAR + DEPTH_SLACK;
}

static APART int depth_is_held(const struct vertex *const v[4], int32_t bias)
{
    int held = 0;

    for (int k = 0; k < 4; k++)
        held |= (uint32_t)(v[k]->z + bias - DEPTH_FAR) > DEPTH_RANGE;
    return held;
}

/*
 * Whether no corner's depth is held at a limit, and the depth that the plane of the other corners gives corner 3 is in
 * range or near its own; with and without bias, because 1/m comes from depths without it. For a quad seen nearly
 * edge-on, the plane through three snapped corners may differ from the quad's so much that depth or 1/m could wrap.
 */
static inline int depth_stays(const struct vertex *const v[4], const int32_t area[3], int32_t bias)
{
    const int32_t z = v[0]->z, least = z + min32(bias, 0), most = z + max32(bias, 0);
    const int32_t steep = (int32_t)(magnitude32(v[1]->z - z) + magnitude32(v[2]->z - z));

    return (bias == 0 || !depth_is_held(v, bias)) &&
           (3 * steep <= min32(least - DEPTH_FAR, UINT16_MAX - most) || depth_is_near(v, area));
}

/*
 * Areas as in struct quad; 0 if the snapped quad is not convex, or corner 3, or its depth, may lie far beyond the
 * triangle of the other corners.
 */
static inline int quad_areas(const struct vertex *const v[4], int32_t area[3], int32_t bias)
{
    const int32_t base = small_twice_area(v[0], v[1], v[2]), first = small_twice_area(v[0], v[3], v[2]),
                  second = small_twice_area(v[0], v[1], v[3]);

    area[0] = base;
    area[1] = first;
    area[2] = second;
    return base > 0 && first > 0 && second > 0 && first + second > base && max32(first, second) <= 2 * base &&
           depth_stays(v, area, bias);
}

/* The `list` of struct sheen_quads. */
static int list_quad(struct sheen_frame *f, const struct draw_record *d, const struct transform *t,
                     const uint16_t *place, uint32_t i)
{
    const struct vertex *v[4];
    unsigned any = 0, all = LIT;
    struct quad q;
    const uint32_t *const index = q.index, none = f->config.max_used;

    if (!fan_at(d->as.mesh, i, q.index))
        return 0;
    SHEEN_TAP(QUAD_LOOKED_AT, 1);
    if ((place[index[3]] >= none || place[index[2]] >= none || place[index[1]] >= none || place[index[0]] >= none) &&
        !sheen_use_corners(f, d, t, index, 4))
        return 0;
    UNROLLED
    for (int k = 0; k < 4; k++) {
        v[k] = f->vertex + place[index[k]];
        any |= v[k]->flags;
        all &= v[k]->flags;
    }
    if ((any & (OUTSIDE | OFF_VIEW)) != 0)
        return 0;
    if (!quad_areas(v, q.area, d->as.depth_bias)) {
        const int away = q.area[1] <= 0 && q.area[2] <= 0;
        SHEEN_TAP(QUAD_LISTED, away);
        return away;
    }
    if (d->as.shader->quads != QUADS_ANY) {
        if (all == 0)
            sheen_light_corners(&d->as, v, index, 4);
        q.v = v;
        if (!(d->as.shader->quads == QUADS_LIT ? sheen_lit_linearly(&d->as, &q) : sheen_reflects_whole(&f->screen, &q)))
            return 0;
    }
    SHEEN_TAP(QUAD_LISTED, 1);
    f->count.front += 2;
    (void)sheen_bin_triangle(f, v, i | QUAD, 0);
    return 1;
}

/* The corners in struct corners' order. */
static void quad_corners(const struct sheen_frame *f, const struct draw_record *d, uint32_t triangle, struct corners *c)
{
    static const uint8_t order[3] = {0, 5, 1};
    const struct sheen_mesh *mesh = d->as.mesh;
    const int16_t *own = corner_parts(mesh, d->as.shader);

    c->triangle = (uint16_t)triangle;
    c->v[3] = used_vertex(f, d, mesh_index(mesh, 3 * triangle + 2));
    UNROLLED
    for (uint32_t k = 0; k < 3; k++) {
        const uint32_t index = mesh_index(mesh, 3 * triangle + order[k]);
        c->v[k] = used_vertex(f, d, index);
        c->normal[k] = own + 3 * index;
    }
}

const struct sheen_quads sheen_quads = {most_warp, list_quad, quad_corners};
