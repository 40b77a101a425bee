/*
 * lecture_orientation.c - a quad turned by 45 degrees: as a polygon by scan lines, and as triangles.
 *
 * Two opposite corners are bright, two dark. By scan lines the centre gets its light from
 * the edges that its row meets, so it changes as the quad turns. In triangles it does not
 * change, but depends on the diagonal along which the quad was cut. Normals on great arcs
 * depend on the scan line even within a triangle.
 */
#include <math.h>
#include <string.h>

#include "lecture.h"
#include "lecture_scene.h"

#define SIZE 129  /* px, odd: the picture's centre is a pixel's centre */
#define SMALL 45  /* likewise, for pictures of which only the centre is used */
#define TURNS 37  /* every 2.5 degrees of a quarter turn */
#define REACH 1.5 /* units, half the picture */

static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
static const double level[4] = {0.95, 0.15, 0.95, 0.15};

/* ---- the lecture's scan lines, on the whole polygon ---- */

/* Intensity at (x, y), interpolated along the two edges that the scan line meets, then along that line; 0 outside. */
static double polygon_at(double degrees, double x, double y)
{
    double c = cos(degrees * M_PI / 180), s = sin(degrees * M_PI / 180), at[2], value[2];
    int count = 0;

    for (int k = 0; k < 4 && count < 2; k++) {
        const double *a = corner[k], *b = corner[(k + 1) % 4];
        double xa = c * a[0] - s * a[1], ya = s * a[0] + c * a[1];
        double xb = c * b[0] - s * b[1], yb = s * b[0] + c * b[1];
        if ((ya <= y) == (yb <= y))
            continue;
        double t = (y - ya) / (yb - ya);
        at[count] = xa + t * (xb - xa);
        value[count++] = level[k] + t * (level[(k + 1) % 4] - level[k]);
    }
    if (count < 2 || (x - at[0]) * (x - at[1]) > 0)
        return 0;
    return value[0] + (x - at[0]) / (at[1] - at[0]) * (value[1] - value[0]);
}

static void polygon_picture(double degrees, double *intensity)
{
    for (int i = 0; i < SIZE * SIZE; i++)
        intensity[i] = polygon_at(degrees, (i % SIZE + 0.5 - SIZE / 2.0) * 2 * REACH / SIZE,
                                  (SIZE / 2.0 - i / SIZE - 0.5) * 2 * REACH / SIZE);
}

/* ---- the core's triangles ---- */

/* Cut between the bright corners or, if `other`, between the dark ones. */
static void make_quad(struct sheen_lecture_mesh *m, int other)
{
    unsigned v[4];

    sheen_lecture_mesh_begin(m, 2);
    for (int k = 0; k < 4; k++) {
        double normal[3], position[3] = {corner[k][0], corner[k][1], 0};
        sheen_lecture_lean(level[k], corner[k][0], corner[k][1], normal);
        v[k] = sheen_lecture_vertex(m, position, normal);
    }
    sheen_lecture_quad(m, v[other], v[1 + other], v[2 + other], v[(3 + other) % 4]);
}

/* One triangle about its centroid, its normals far apart. */
static void make_triangle(struct sheen_lecture_mesh *m)
{
    unsigned v[3];

    sheen_lecture_mesh_begin(m, 2);
    for (int k = 0; k < 3; k++) {
        double x = cos(2 * M_PI * k / 3 + 0.4), y = sin(2 * M_PI * k / 3 + 0.4), normal[3], position[3] = {x, y, 0};
        sheen_lecture_lean(cos((30 + 25 * k) * M_PI / 180), x, y, normal);
        v[k] = sheen_lecture_vertex(m, position, normal);
    }
    sheen_lecture_triangle(m, v[0], v[1], v[2]);
}

/* The intensity at the picture's centre, and its range, while mesh and light turn together. */
static int turn_mesh(const struct sheen_lecture_mesh *m, int shading, double *centre, double *range)
{
    static double picture[SMALL * SMALL];
    double low = 1, high = 0;

    for (int i = 0; i < TURNS; i++) {
        struct sheen_lecture_scene scene;
        static const double light[3] = {-0.45, 0.3, 0.84};
        sheen_lecture_scene_default(&scene, &m->mesh);
        if (shading != SHEEN_GOURAUD)
            memcpy(scene.light, light, sizeof light);
        scene.width = scene.height = SMALL;
        scene.reach = REACH;
        scene.shading = shading;
        scene.roll = 90.0 * i / (TURNS - 1);
        sheen_lecture_roll_light(&scene, scene.roll);
        int error = sheen_lecture_measure(&scene, picture);
        if (error)
            return error;
        centre[i] = picture[SMALL * SMALL / 2];
        low = fmin(low, centre[i]);
        high = fmax(high, centre[i]);
    }
    *range = high - low;
    return SHEEN_OK;
}

/* ---- the page ---- */

static int draw_pictures(struct sheen_page *page, const struct sheen_lecture_mesh *quad)
{
    static double picture[SIZE * SIZE];

    for (int k = 0; k < 4; k++) {
        struct sheen_lecture_scene scene;
        double degrees = k % 2 ? 45 : 0, x = 138 + (SIZE + 14) * (k % 2), y = 108 + (SIZE + 14) * (k / 2);
        sheen_lecture_scene_default(&scene, &quad->mesh);
        scene.width = scene.height = SIZE;
        scene.reach = REACH;
        scene.roll = degrees;
        int error = SHEEN_OK;
        if (k / 2)
            error = sheen_lecture_measure(&scene, picture);
        else
            polygon_picture(degrees, picture);
        if (error)
            return error;
        sheen_page_intensity(page, x, y, 1, picture, SIZE, SIZE);
        if (k / 2)
            sheen_page_text(page, x + SIZE / 2, y + SIZE + 24, SHEEN_CENTRE, SHEEN_INK_TEXT, "turned by %.0f°",
                            degrees);
    }
    sheen_page_text(page, 36, 170, SHEEN_LEFT, SHEEN_INK_WRONG, "by scan");
    sheen_page_text(page, 36, 192, SHEEN_LEFT, SHEEN_INK_WRONG, "lines");
    sheen_page_text(page, 36, 332, SHEEN_LEFT, SHEEN_INK_GOURAUD, "triangles");
    page->heart = (struct sheen_box){30, 104, 424, 418};
    return SHEEN_OK;
}

static int draw_quad(struct sheen_page *page, const struct sheen_lecture_mesh *quad,
                     const struct sheen_lecture_mesh *other, const double *degrees)
{
    struct sheen_axes axes = {552, 128, 410, 150, 0, 90, 0, 1};
    double polygon[TURNS], centre[TURNS], range, low = 1, high = 0;

    for (int i = 0; i < TURNS; i++) {
        polygon[i] = polygon_at(degrees[i] + 1e-9, 0, 0);
        low = fmin(low, polygon[i]);
        high = fmax(high, polygon[i]);
    }
    sheen_page_axes(page, &axes, 15, 0, 0.25, 2);
    sheen_page_axis_names(page, &axes, NULL, "intensity at the quad's centre");
    sheen_page_curve(page, &axes, SHEEN_INK_WRONG, 2.2, degrees, polygon, TURNS);
    sheen_page_number(page, 36, 516, SHEEN_INK_WRONG, "polygon by scan lines: the centre from %.3f to %.3f", low, high);
    int error = turn_mesh(quad, SHEEN_GOURAUD, centre, &range);
    if (error)
        return error;
    sheen_page_curve(page, &axes, SHEEN_INK_GOURAUD, 2.2, degrees, centre, TURNS);
    sheen_page_number(page, 36, 542, SHEEN_INK_GOURAUD, "triangles, bright corners joined: %.3f, changes by %.4f",
                      centre[0], range);
    error = turn_mesh(other, SHEEN_GOURAUD, centre, &range);
    if (error)
        return error;
    sheen_page_curve(page, &axes, SHEEN_INK_GOURAUD, 2.2, degrees, centre, TURNS);
    sheen_page_number(page, 36, 568, SHEEN_INK_GOURAUD, "triangles, dark corners joined: %.3f, changes by %.4f",
                      centre[0], range);
    return SHEEN_OK;
}

static int draw_triangle(struct sheen_page *page, const double *degrees)
{
    static struct sheen_lecture_mesh triangle;
    struct sheen_axes axes = {552, 338, 410, 100, 0, 90, 0.7, 1};
    double centre[TURNS], range;

    make_triangle(&triangle);
    sheen_page_axes(page, &axes, 15, 0, 0.1, 1);
    sheen_page_axis_names(page, &axes, "degrees that it has turned", "intensity at the centre of a triangle");
    int error = turn_mesh(&triangle, SHEEN_PHONG, centre, &range);
    if (error)
        return error;
    sheen_page_curve(page, &axes, SHEEN_INK_PHONG, 2.2, degrees, centre, TURNS);
    sheen_page_number(page, 552, 516, SHEEN_INK_PHONG, "Phong in a triangle: changes by %.4f", range);
    error = turn_mesh(&triangle, SHEEN_SLERP, centre, &range);
    if (error)
        return error;
    sheen_page_curve(page, &axes, SHEEN_INK_SLERP, 2.2, degrees, centre, TURNS);
    sheen_page_number(page, 552, 542, SHEEN_INK_SLERP, "slerp in a triangle: changes by %.4f", range);
    return SHEEN_OK;
}

int sheen_lecture_orientation(struct sheen_page *page)
{
    static struct sheen_lecture_mesh quad, other;
    double degrees[TURNS];

    make_quad(&quad, 0);
    make_quad(&other, 1);
    for (int i = 0; i < TURNS; i++)
        degrees[i] = 90.0 * i / (TURNS - 1);
    sheen_page_title(page, "Orientation dependence",
                     "A polygon shaded by scan lines changes as it turns; cut into triangles it does not.");
    sheen_page_caption(page,
                       "A square with two bright and two dark corners. By scan lines its centre changes from grey "
                       "to black as it turns; in triangles it keeps its light, though which way it was cut decides.");
    int error = draw_pictures(page, &quad);
    if (!error)
        error = draw_quad(page, &quad, &other, degrees);
    return error ? error : draw_triangle(page, degrees);
}
