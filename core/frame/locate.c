/*
 * locate.c - where a point lies on the target.
 */
#include "../math/pose.h"
#include "frame.h"

/* Project a point: the origin of a mesh of one vertex, whose scale is a raw step, so that all of the range is left. */
static int before_eye(const struct sheen_frame *f, const struct sheen_pose *model, const sheen_q24_t point[3],
                      struct vertex *v)
{
    static const int16_t origin[3] = {0, 0, 0};
    struct sheen_mesh mesh = {.scale = 1};
    struct sheen_pose pose;
    struct transform t;

    if (sheen_pose_place(&f->view.pose, model, &pose) < 0)
        return SHEEN_ERR_ARGUMENT;
    for (int k = 0; k < 3; k++) {
        const int64_t at = sheen_pose_part(&pose, k, point);
        if (at > INT32_MAX || at < -INT32_MAX)
            return SHEEN_ERR_ARGUMENT;
        mesh.offset[k] = (sheen_q24_t)at;
    }
    sheen_pose_identity(&pose);
    if (sheen_transform_begin(&t, &f->projection, &mesh, &pose) < 0)
        return SHEEN_ERR_ARGUMENT;
    const struct point seen = sheen_transform_point(&t, origin);
    sheen_project(&f->projection, t.screen_shift, &seen, v);
    return SHEEN_OK;
}

COLD int sheen_locate(const struct sheen_frame *f, const struct sheen_pose *model, const sheen_q24_t point[3],
                      struct sheen_spot *spot)
{
    static const struct sheen_pose world = {.scale = 0};
    const struct sheen_rect *port = &f->viewport;
    struct vertex v;

    if (f->state == IDLE)
        return SHEEN_ERR_STATE;
    if (before_eye(f, model != NULL ? model : &world, point, &v) < 0)
        return SHEEN_ERR_ARGUMENT;
    *spot = (struct sheen_spot){.depth = 0};
    if ((v.flags & (OUTSIDE_NEAR | OUTSIDE_FAR)) != 0)
        return SHEEN_OK;
    *spot = (struct sheen_spot){target_x(f, v.x), target_y(f, v.y), v.z, 0};
    spot->inside = spot->x >= port->x0 * SUBPIXEL_ONE && spot->x < port->x1 * SUBPIXEL_ONE &&
                   spot->y >= port->y0 * SUBPIXEL_ONE && spot->y < port->y1 * SUBPIXEL_ONE;
    return SHEEN_OK;
}
