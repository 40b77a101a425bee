/*
 * setup.c - three vertices to edges, depth and the set-up of their shading.
 */
#include "triangle.h"

/*
 * Start an edge from (xa, ya) down to (xb, yb), 1/64 px, ya < yb, at pixel row
 * `row`, at or below the first one whose centre the edge reaches. The column is
 * that of the first pixel centre at or right of the crossing, exactly:
 *   column = ceil((xa - 32 + (64 row + 32 - ya) (xb - xa) / (yb - ya)) / 64).
 * Range: height, |width| <= 65,408 (corners lie within +-511 px of the viewport's centre), rows skipped at most
 * height / 64 + 1, so `part` is at most 63 height + 63 (height - 1) + 64 (height / 64 + 1) (height - 1): 0.999 * 2^32.
 */
static void edge_begin(struct edge *e, int32_t xa, int32_t ya, int32_t xb, int32_t yb, int32_t row)
{
    int32_t height = yb - ya, width = xb - xa;
    int32_t first = first_centre(ya), skipped = row - first;
    int32_t rest = first * SUBPIXEL_ONE + SUBPIXEL_HALF - ya; /* 0..63 */
    int32_t step = width / height, carry = width % height;

    if (carry < 0) {
        step--;
        carry += height;
    }
    e->size = (uint32_t)height << SUBPIXEL_BITS;
    e->step = step;
    e->carry = (uint32_t)carry << SUBPIXEL_BITS;

    int32_t start = xa - SUBPIXEL_HALF + rest * step; /* 1/64 px, without the remainder's part */
    uint32_t part =
        (uint32_t)(start & 63) * (uint32_t)height + (uint32_t)rest * (uint32_t)carry + (uint32_t)skipped * e->carry;
    e->column = asr32(start, SUBPIXEL_BITS) + skipped * step;
    if (part >= e->size) {
        uint32_t whole = part / e->size;
        e->column += (int32_t)whole;
        part -= whole * e->size;
    }
    e->error = (int32_t)part;
    if (part > 0) {
        e->column++;
        e->error -= (int32_t)e->size;
    }
}

/* Order three corners from top to bottom; returns 1 where that is an odd permutation. */
static int sort_rows(const int32_t y[3], unsigned order[3])
{
    int odd = 0;

    for (unsigned k = 0; k < 3; k++)
        order[k] = k;
    for (unsigned k = 0; k < 3; k++) {
        unsigned i = k == 1 ? 1 : 0; /* compare 0-1, 1-2, 0-1 */
        if (y[order[i + 1]] < y[order[i]]) {
            unsigned swapped = order[i];
            order[i] = order[i + 1];
            order[i + 1] = swapped;
            odd = !odd;
        }
    }
    return odd;
}

/* Both edges at row s->row; the lower short edge waits in middle_*, bottom_*. */
static void edges_begin(struct setup *s, const int32_t x[3], const int32_t y[3], const unsigned order[3])
{
    unsigned top = order[0], middle = order[1], bottom = order[2];
    struct edge *longer = s->long_right ? &s->right : &s->left, *shorter = s->long_right ? &s->left : &s->right;

    edge_begin(longer, x[top], y[top], x[bottom], y[bottom], s->row);
    if (s->row < s->middle_row)
        edge_begin(shorter, x[top], y[top], x[middle], y[middle], s->row);
    else
        edge_begin(shorter, x[middle], y[middle], x[bottom], y[bottom], s->row);
}

/* The lower short edge takes over at row s->middle_row. */
void sheen_triangle_lower_edge(const struct screen *screen, struct setup *s)
{
    edge_begin(s->long_right ? &s->left : &s->right, s->middle_x + screen->centre_x, s->middle_y + screen->centre_y,
               s->bottom_x + screen->centre_x, s->bottom_y + screen->centre_y, s->row);
}

/* Weights of Blinn's way, proportional to 1/m, brought up to [1/2, 1) by a power of two. */
static void weigh(const struct screen *screen, struct surface_corners *c)
{
    uint32_t all = 0;

    c->flat_weight = screen->flat_weight;
    for (int k = 0; k < 3; k++) {
        c->weight[k] =
            c->flat_weight ? UINT32_MAX : ((uint32_t)c->at.v[k]->z << screen->weight_shift) + screen->weight_offset;
        all |= c->weight[k];
    }
    for (int k = 0; k < 3 && all != 0; k++) /* all 0: far is too far for near, no weight is left to tell */
        c->weight[k] <<= clz32(all);
    if (c->weight[0] == c->weight[1] && c->weight[0] == c->weight[2])
        c->flat_weight = 1;
}

static struct plane depth_plane(const struct gradients *g, const struct surface_corners *c)
{
    const int32_t z[3] = {c->at.v[0]->z, c->at.v[1]->z, c->at.v[2]->z};

    if (g != NULL)
        return sheen_gradient_plane(g, z, 16);
    struct plane constant = {(uint32_t)z[0] << 16, 0, 0};
    return constant;
}

/* Put corners in clockwise order on the screen; returns twice the area, 1/4096 px^2. */
static uint32_t orient(struct corners *c, uint8_t *back)
{
    int64_t area = twice_area(c->v[0], c->v[1], c->v[2]);

    *back = area > 0;
    if (area < 0) {
        const struct vertex *v = c->v[1];
        const int16_t *normal = c->normal[1];
        c->v[1] = c->v[2];
        c->normal[1] = c->normal[2];
        c->v[2] = v;
        c->normal[2] = normal;
        area = -area;
    }
    return (uint32_t)area; /* <= (2 * 511 * 64)^2 < 2^32 */
}

int sheen_triangle_begin(const struct screen *screen, int32_t from, struct surface_corners *c, struct gradients *g,
                         int *flat, struct setup *s)
{
    int32_t x[3], y[3];
    unsigned order[3];

    uint32_t area = orient(&c->at, &c->back);
    for (int k = 0; k < 3; k++) {
        x[k] = c->at.v[k]->x + screen->centre_x;
        y[k] = c->at.v[k]->y + screen->centre_y;
    }
    s->long_right = sort_rows(y, order) != 0; /* clockwise: top, middle, bottom even = middle on the right */
    s->row = (int16_t)max32(first_centre(y[order[0]]), from);
    s->middle_row = (int16_t)first_centre(y[order[1]]);
    s->end_row = (int16_t)min32(first_centre(y[order[2]]), screen->viewport.y1);
    if (s->row >= s->end_row)
        return 0;
    const struct vertex *middle = c->at.v[order[1]], *bottom = c->at.v[order[2]];
    s->middle_x = middle->x;
    s->middle_y = middle->y;
    s->bottom_x = bottom->x;
    s->bottom_y = bottom->y;
    edges_begin(s, x, y, order);
    *flat = !sheen_gradients(g, x, y, area);
    weigh(screen, c);
    s->depth = depth_plane(*flat ? NULL : g, c);
    return 1;
}
