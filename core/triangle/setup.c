/*
 * setup.c - set-up of a triangle: from its vertices to edges, gradients and depth.
 */
#include "triangle.h"

/*
 * The corners' weights for Blinn's way, proportional to 1/m and scaled by a power of two so that the largest is in
 * [1/2, 1). A quad's are a quarter of that, because the plane through corners 0 to 2 may give corner 3, with S and T at
 * most 2, up to four times as much.
 */
void sheen_weigh(struct surface_corners *c)
{
    const struct screen *screen = c->screen;
    uint32_t all = 0;

    c->flat_weight = screen->flat_weight;
    UNROLLED
    for (int k = 0; k < 3; k++) {
        const uint32_t weight = ((uint32_t)c->at.v[k]->z << screen->weight_shift) + (uint32_t)screen->weight_offset;
        c->weight[k] = weight | (0u - screen->flat_weight); /* all ones if all weights are equal */
        all |= c->weight[k];
    }
    for (int k = 0; k < 3; k++) /* `all` is 0 if far / near is so large that no bits of weight are left */
        c->weight[k] = c->weight[k] << clz32(all | 1u) >> (c->at.v[3] != NULL ? 2 : 0);
    if (c->weight[0] == c->weight[1] && c->weight[0] == c->weight[2])
        c->flat_weight = 1;
}

/* Swaps the two corners that follow corner 0. */
static void turn_over(struct corners *c, struct gradients *g)
{
    const struct vertex *v = c->v[1];
    const int16_t *normal = c->normal[1];

    c->v[1] = c->v[2];
    c->normal[1] = c->normal[2];
    c->v[2] = v;
    c->normal[2] = normal;
    for (int i = 0; i < 2; i++) {
        int32_t to = g->to1[i];
        g->to1[i] = g->to2[i];
        g->to2[i] = to;
    }
}

/*
 * Fills in the differences to corner 0 and twice the area, 1/4096 px^2; turns back faces over so that all corners run
 * clockwise.
 */
static void orient(struct surface_corners *c, struct gradients *g)
{
    const struct vertex *const *v = c->at.v;
    const int32_t x1 = v[1]->x - v[0]->x, y1 = v[1]->y - v[0]->y, x2 = v[2]->x - v[0]->x, y2 = v[2]->y - v[0]->y;
    int32_t low;

    g->to1[0] = x1;
    g->to1[1] = y1;
    g->to2[0] = x2;
    g->to2[1] = y2;
    uint32_t all = magnitude32(x1) | magnitude32(y1) | magnitude32(x2) | magnitude32(y2);
    if (v[3] != NULL)
        all |= magnitude32(v[3]->x - v[0]->x) | magnitude32(v[3]->y - v[0]->y);
    g->bits = (uint16_t)(32 - clz32(all));
    if (g->bits <= NARROW_BITS) {
        low = x1 * y2 - y1 * x2;
        c->back = low < 0;
    } else {
        int64_t area = (int64_t)x1 * y2 - (int64_t)y1 * x2; /* |area| <= (2 * 511 * 64)^2 < 2^32 */
        low = (int32_t)(uint32_t)(uint64_t)area;
        c->back = area < 0;
    }
    g->area = c->back ? 0u - (uint32_t)low : (uint32_t)low;
    if (c->back)
        turn_over(&c->at, g);
}

/*
 * If depth differences times 2^stretch exceed this, a plane with 15-bit steps may be off by a step of z16 or more. Then
 * what that plane lacks at corners 1 and 2, less than 2^7 steps, is added as a second plane. The lack is computed as
 * Q.22 of a step, modulo 2^32, and cut to Q.8.
 */
#define STEEPEST_DEPTH 32768

HOT static void mend_depth(struct plane *depth, const struct gradients *g, int32_t d1, int32_t d2)
{
    const uint32_t at1 = depth->dx * (uint32_t)g->to1[0] + depth->dy * (uint32_t)g->to1[1];
    const uint32_t at2 = depth->dx * (uint32_t)g->to2[0] + depth->dy * (uint32_t)g->to2[1];
    const int32_t lack1 = (int32_t)(((uint32_t)d1 << 22) - at1), lack2 = (int32_t)(((uint32_t)d2 << 22) - at2);
    struct plane rest;

    sheen_plane(&rest, g, 0, asr32(lack1, 14), asr32(lack2, 14), 8);
    depth->base += rest.base;
    depth->dx += rest.dx;
    depth->dy += rest.dy;
}

static void depth_plane(struct setup *s, const struct surface_corners *c, const struct gradients *g, int flat)
{
    const int32_t bias = s->draw->depth_bias;
    int32_t z[3] = {c->at.v[0]->z, c->at.v[1]->z, c->at.v[2]->z};

    for (int k = 0; k < 3 && bias != 0; k++)
        z[k] = max32(DEPTH_FAR, min32(z[k] + bias, DEPTH_FAR + DEPTH_RANGE));
    const int32_t d1 = z[1] - z[0], d2 = z[2] - z[0];
    const uint32_t steep = magnitude32(d1) + magnitude32(d2);

    if (flat) {
        s->depth = (struct plane){(uint32_t)z[0] << 16, 0, 0};
    } else if (steep > STEEPEST_DIFFERENCE) {
        s->depth = sheen_gradient_plane(g, z, 16);
    } else {
        sheen_plane(&s->depth, g, (uint32_t)z[0] << 16, d1, d2, 16);
        if (steep << max32(g->stretch, 0) > STEEPEST_DEPTH && !g->wide)
            mend_depth(&s->depth, g, d1, d2);
    }
}

HOT unsigned sheen_triangle_begin(const struct screen *screen, struct sheen_rect rect, struct span *spans,
                                  struct surface_corners *c, struct gradients *g, struct setup *s)
{
    const struct vertex *const fourth = c->at.v[3];
    struct screen_corner ring[4], *const at = &ring[1]; /* corner 3 (of quads), then 2, 0, 1 */

    orient(c, g);
    c->screen = screen;
    at[1].x = c->at.v[0]->x + screen->centre_x;
    at[1].y = c->at.v[0]->y + screen->centre_y;
    at[2].x = at[1].x + g->to1[0];
    at[2].y = at[1].y + g->to1[1];
    at[0].x = at[1].x + g->to2[0];
    at[0].y = at[1].y + g->to2[1];
    for (int k = 0; k < 3; k++)
        at[k].row = first_centre(at[k].y);
    int32_t top = min32(at[0].row, min32(at[1].row, at[2].row)), bottom = max32(at[0].row, max32(at[1].row, at[2].row));
    if (fourth != NULL) {
        ring[0].x = fourth->x + screen->centre_x;
        ring[0].y = fourth->y + screen->centre_y;
        ring[0].row = first_centre(ring[0].y);
        top = min32(top, ring[0].row);
        bottom = max32(bottom, ring[0].row);
    }
    int32_t end_row = min32(bottom, screen->viewport.y1);
    const struct edge_rows to = {max32(top, rect.y0), min32(end_row, rect.y1),
                                 top >= rect.y0 && bottom <= rect.y1 - screen->shared_rows, fourth != NULL};
    s->row = (int16_t)to.end;
    s->end_row = (int16_t)end_row;
    if (to.row >= to.end)
        return 0;
    s->right = right_edges(sheen_edges_begin(s->edge, at, &to, spans), to.quad);
    s->needs_clipping =
        ((c->at.v[0]->flags | c->at.v[1]->flags | c->at.v[2]->flags) & OFF_VIEW) != 0 || screen->shared_rows > 0;
    if (s->needs_clipping)
        sheen_clip_spans(spans, (unsigned)(to.end - to.row), rect);
    c->flat = !sheen_gradients(g, at[1].x, at[1].y);
    depth_plane(s, c, g, c->flat);
    return (unsigned)(to.end - to.row);
}
