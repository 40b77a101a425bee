/*
 * points.c - point lights: their place relative to a mesh, and how their light falls.
 */
#include "../math/pose.h"
#include "morph.h"

/* Moves a place by a pose, which is not all zero; on an error the place is unchanged. */
static APART int move_by(const struct sheen_pose *pose, int32_t place[3])
{
    struct sheen_pose moved = {.translation = {place[0], place[1], place[2]}};
    const int error = sheen_pose_place(pose, &moved, &moved);

    for (int k = 0; k < 3 && error == SHEEN_OK; k++)
        place[k] = moved.translation[k];
    return error;
}

/*
 * Stores the place of point light i relative to the posed mesh's origin, along the model's axes, Q11.20. Range: both
 * are within 128 units of the eye; otherwise the light's radius is 0.
 */
static void place_point(struct draw *d, const struct sheen_light *light, const struct sheen_pose *pose,
                        const struct sheen_pose *view, unsigned i)
{
    const sheen_q24_t *offset = d->mesh->offset;
    int32_t *at = d->light.to[i], apart[3]; /* at first the mesh's origin */

    d->light.lv1[i] = 0;
    for (int k = 0; k < 3; k++) {
        at[k] = light->at[k];
        apart[k] = offset[k];
    }
    if ((!light->with_eye && !sheen_pose_is_zero(view) && move_by(view, at) < 0) || move_by(pose, apart) < 0) {
        at[0] = at[1] = at[2] = 0; /* no light reaches the mesh */
        return;
    }
    for (int k = 0; k < 3; k++)
        apart[k] = (int32_t)round_shift64((int64_t)at[k] - apart[k], 4);
    sheen_to_model(pose->rotation, apart, at);
    d->light.lv1[i] = light->radius * 16;
}

static COLD void points_place(struct draw *d, const struct sheen_object *object, const struct sheen_pose *view)
{
    struct sheen_pose pose;

    d->tint.reach = 0;
    if (sheen_pose_place(view, &object->pose, &pose) < 0)
        return; /* never: it was placed before without an error */
    for (unsigned i = 0; i < d->light.count; i++)
        if (object->lights[i].radius > 0) {
            place_point(d, &object->lights[i], &pose, view, i);
            d->tint.point_mask |= (uint8_t)(1u << i);
        }
    d->tint.reach = (int32_t)(((int64_t)pose.scale * d->mesh->scale) >> 16);
}

static int of_polygon(const struct sheen_mesh *mesh, uint32_t triangle, uint32_t polygon)
{
    return triangle < mesh->triangles && mesh->polygons != NULL && mesh->polygons[triangle] == polygon;
}

/* The mean of a polygon's vertices, each counted once; its triangles follow each other. Range: 2^15 times 2^16. */
static void points_middle(const struct draw *d, uint32_t triangle, int16_t middle[3])
{
    const struct sheen_mesh *mesh = d->mesh;
    const uint32_t polygon = mesh->polygons != NULL ? mesh->polygons[triangle] : triangle;
    uint32_t first = triangle, end = triangle + 1;
    int32_t sum[3] = {0, 0, 0}, count = 0;

    while (first > 0 && of_polygon(mesh, first - 1, polygon))
        first--;
    while (of_polygon(mesh, end, polygon))
        end++;
    for (uint32_t corner = 3 * first; corner < 3 * end; corner++) {
        const uint32_t index = mesh_index(mesh, corner);
        uint32_t known = 3 * first;
        int16_t store[3];
        while (mesh_index(mesh, known) != index)
            known++;
        if (known < corner)
            continue;
        const int16_t *at = position_of(d, mesh->positions + 3 * index, store);
        for (int i = 0; i < 3; i++)
            sum[i] += at[i];
        count++;
    }
    for (int i = 0; i < 3; i++)
        middle[i] = (int16_t)(sum[i] / count);
}

/* v / |v|, Q1.30. Range: square = |v|^2 is below 2^60 and not 0, so the product is below 2^62. */
static void unit_along(const int32_t v[3], uint64_t square, sheen_q30_t to[3])
{
    const unsigned up = clz64(square) & ~1u; /* |v| = sqrt(x) 2^(32 - up / 2), x in [1/4, 1) */
    const uint32_t root = sheen_reciprocal_root((uint32_t)((square << up) >> 32)); /* UQ1.31 */

    for (int k = 0; k < 3; k++)
        to[k] = (int32_t)round_shift64(v[k] * (int64_t)root, 33 - up / 2);
}

/* Range: parts of `at` are below 2^27, of the light's place below 2^29, see place_point: the square is below 2^62. */
static void points_beam(const struct lighting *l, unsigned i, const int32_t at[3], const int16_t normal[3],
                        struct beam *beam)
{
    const uint64_t whole = (uint64_t)l->lv1[i] * (uint64_t)l->lv1[i];
    uint64_t square = 0;
    int32_t lv = 0;

    for (int k = 0; k < 3; k++) {
        const int32_t v = l->to[i][k] - at[k];
        square += (uint64_t)((int64_t)v * v);
        beam->own[k] = v;
    }
    beam->left = 0;
    if (square >= whole)
        return;
    const unsigned zeros = clz64(whole);
    const uint32_t lost = sheen_ratio((uint32_t)((square << zeros) >> 32), (uint32_t)((whole << zeros) >> 32));
    beam->left = mul_high(~lost, ~lost);
    if (square != 0)
        unit_along(beam->own, square, beam->own);
    for (int k = 0; k < 3; k++) {
        if (square == 0)
            beam->own[k] = normal[k] * 32768;
        lv += sheen_mul_round(beam->own[k], l->view[k], 31);
    }
    beam->to = beam->own;
    beam->lv1 = (1 << 29) + lv;
}

const struct sheen_points sheen_points = {points_place, points_middle, points_beam};
