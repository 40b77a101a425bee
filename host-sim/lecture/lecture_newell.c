/*
 * lecture_newell.c - a polygon's normal by Newell's sum: corners on a straight line do it no harm, its length is
 * twice the polygon's area, and the choice of origin does not matter.
 *
 * The core computes the normal, cuts the polygon into triangles and draws it; the figure counts the pixels.
 */

#include "lecture.h"
#include "lecture_scene.h"

#define CORNERS 11
#define UNIT 30 /* px */
#define WIDTH (10 * UNIT)
#define HEIGHT (8 * UNIT)
#define LEFT 70 /* place of the picture on the page */
#define TOP 128
#define ORIGINS 3

/* Counter-clockwise. */
static const int corner[CORNERS][2] = {{0, 0}, {3, 0}, {6, 0}, {10, 0}, {10, 3}, {7, 3},
                                       {4, 3}, {4, 6}, {4, 8}, {0, 8},  {0, 4}};
static const int origin[ORIGINS][2] = {{0, 0}, {5, 4}, {10, 0}};

/* The z component of (a - o) x (b - o). */
static int cross(const int *a, const int *b, const int *o)
{
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/* Which way the outline turns at corner k, by its two neighbours alone: > 0 left, < 0 right, 0 straight on. */
static int turn(int k)
{
    const int *before = corner[(k + CORNERS - 1) % CORNERS], *here = corner[k], *next = corner[(k + 1) % CORNERS];

    return cross(here, next, before);
}

/* ---- by the core ---- */

/* Computes the normal with each corner as the first. normal: from corner 0; *least: the smallest z of all. */
static int core_normals(sheen_q30_t normal[3], sheen_q30_t *least)
{
    int32_t points[3 * CORNERS];

    for (int k = 0; k < CORNERS; k++) {
        points[3 * k] = corner[k][0];
        points[3 * k + 1] = corner[k][1];
        points[3 * k + 2] = 0;
    }
    *least = INT32_MAX;
    for (int first = CORNERS - 1; first >= 0; first--) {
        uint32_t order[CORNERS];
        for (int k = 0; k < CORNERS; k++)
            order[k] = (uint32_t)(first + k) % CORNERS;
        int error = sheen_polygon_normal(points, order, CORNERS, normal);
        if (error)
            return error;
        *least = normal[2] < *least ? normal[2] : *least;
    }
    return SHEEN_OK;
}

static int make_mesh(struct sheen_lecture_mesh *m, const sheen_q30_t normal[3])
{
    uint32_t order[CORNERS], scratch[SHEEN_TRIANGULATE_WORDS(CORNERS)], triangles[3 * (CORNERS - 2)];
    const double up[3] = {0, 0, 1};
    int32_t points[3 * CORNERS];

    sheen_lecture_mesh_begin(m, 1);
    for (int k = 0; k < CORNERS; k++) {
        double position[3] = {(corner[k][0] - 5) / 16.0, (corner[k][1] - 4) / 16.0, 0};
        for (int i = 0; i < 3; i++)
            points[3 * k + i] = i < 2 ? corner[k][i] : 0;
        order[k] = sheen_lecture_vertex(m, position, up);
    }
    int error = sheen_triangulate(points, order, CORNERS, normal, scratch, triangles);
    for (int i = 0; !error && i < CORNERS - 2; i++)
        sheen_lecture_triangle(m, triangles[3 * i], triangles[3 * i + 1], triangles[3 * i + 2]);
    return error;
}

static int draw_polygon(struct sheen_page *page, const sheen_q30_t normal[3], int *pixels)
{
    static struct sheen_lecture_mesh mesh;
    static double picture[WIDTH * HEIGHT];
    struct sheen_lecture_scene scene;
    int error = make_mesh(&mesh, normal);

    if (error)
        return error;
    sheen_lecture_scene_default(&scene, &mesh.mesh);
    scene.width = WIDTH;
    scene.height = HEIGHT;
    scene.reach = 4 / 16.0;
    scene.diffuse = 0.9;
    error = sheen_lecture_measure(&scene, picture);
    *pixels = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        *pixels += picture[i] > 0;
    sheen_page_intensity(page, LEFT, TOP, 1, picture, WIDTH, HEIGHT);
    return error;
}

/* ---- the page ---- */

static void draw_corners(struct sheen_page *page)
{
    for (int k = 0; k < CORNERS; k++) {
        const int *a = corner[k], *b = corner[(k + 1) % CORNERS];
        sheen_page_line(page, SHEEN_INK_TEXT, 1.4, LEFT + a[0] * UNIT, TOP + HEIGHT - a[1] * UNIT, LEFT + b[0] * UNIT,
                        TOP + HEIGHT - b[1] * UNIT);
    }
    for (int k = 0; k < CORNERS; k++) {
        sheen_page_ink(page, turn(k) > 0 ? SHEEN_INK_PHONG : turn(k) < 0 ? SHEEN_INK_WRONG : SHEEN_INK_GOURAUD);
        cairo_arc(page->cr, LEFT + corner[k][0] * UNIT, TOP + HEIGHT - corner[k][1] * UNIT, 6, 0, 6.2832);
        cairo_fill(page->cr);
    }
    sheen_page_text(page, LEFT + 4 * UNIT + 20, TOP + 18, SHEEN_LEFT, SHEEN_INK_FLAT, "three in a row say:");
    sheen_page_text(page, LEFT + 4 * UNIT + 34, TOP + 44, SHEEN_LEFT, SHEEN_INK_PHONG, "up");
    sheen_page_text(page, LEFT + 4 * UNIT + 34, TOP + 68, SHEEN_LEFT, SHEEN_INK_GOURAUD, "nothing: in line");
    sheen_page_text(page, LEFT + 4 * UNIT + 34, TOP + 92, SHEEN_LEFT, SHEEN_INK_WRONG, "down");
    sheen_page_text(page, LEFT + WIDTH / 2, TOP + HEIGHT + 34, SHEEN_CENTRE, SHEEN_INK_TEXT,
                    "Newell's sum over all: up");
    page->heart = (struct sheen_box){LEFT - 16, TOP - 14, LEFT + WIDTH + 16, TOP + HEIGHT + 44};
}

/* Plots how the sum grows, edge by edge, for each origin. */
static void draw_sums(struct sheen_page *page)
{
    static const enum sheen_ink ink[ORIGINS] = {SHEEN_INK_PHONG, SHEEN_INK_SLERP, SHEEN_INK_GOURAUD};
    struct sheen_axes axes = {532, 128, 430, 260, 0, CORNERS, -20, 120};
    double x[CORNERS + 1], sum[CORNERS + 1];

    sheen_page_axes(page, &axes, 1, 0, 20, 0);
    sheen_page_axis_names(page, &axes, "edges added", "z of the sum of Pₖ × Pₖ₊₁, in squares");
    for (int o = 0; o < ORIGINS; o++) {
        x[0] = sum[0] = 0;
        for (int k = 0; k < CORNERS; k++) {
            x[k + 1] = k + 1;
            sum[k + 1] = sum[k] + cross(corner[k], corner[(k + 1) % CORNERS], origin[o]);
        }
        sheen_page_curve(page, &axes, ink[o], 2, x, sum, CORNERS + 1);
        for (int k = 1; k <= CORNERS; k++)
            sheen_page_dot(page, &axes, ink[o], x[k], sum[k]);
        sheen_page_number(page, 592, 466 + 26 * o, ink[o], "seen from (%d, %d): the sum is %.0f", origin[o][0],
                          origin[o][1], sum[CORNERS]);
    }
}

int sheen_lecture_newell(struct sheen_page *page)
{
    sheen_q30_t normal[3], least;
    int pixels = 0, straight = 0, down = 0;
    int error = core_normals(normal, &least);

    sheen_page_title(page, "Newell's sum",
                     "A polygon's N is the sum of Pₖ × Pₖ₊₁, and |N| twice its area; corners in line do no harm.");
    sheen_page_caption(page, "Three corners of this polygon may say up, down or nothing at all. The sum over all its "
                             "edges is right from wherever it is seen, and twice the area that the core covers.");
    if (!error)
        error = draw_polygon(page, normal, &pixels);
    if (error)
        return error;
    for (int k = 0; k < CORNERS; k++) {
        straight += turn(k) == 0;
        down += turn(k) < 0;
    }
    draw_corners(page);
    draw_sums(page);
    sheen_page_number(page, 36, 466, SHEEN_INK_TEXT, "of %d corners %d turn up, %d are in line, %d turns down", CORNERS,
                      CORNERS - straight - down, straight, down);
    sheen_page_number(page, 36, 492, SHEEN_INK_PHONG, "the core's normal, begun at any corner: z at least %.6f",
                      least / 1073741824.0);
    sheen_page_number(page, 36, 518, SHEEN_INK_PHONG, "the core covers %d px, squares of %d px: twice that is %.2f",
                      pixels, UNIT, 2.0 * pixels / (UNIT * UNIT));
    return SHEEN_OK;
}
