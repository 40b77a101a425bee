/*
 * lecture_barycentric.c - one triangle: a point's intensity is I = b1 I1 + b2 I2 + b3 I3, with the point's barycentric
 * coordinates b1, b2, b3, whichever way scan lines run.
 *
 * The coordinates are read from pixels that the core drew: with one corner white and two black, Gouraud shading shows
 * the white corner's coordinate.
 */
#include <math.h>

#include "lecture.h"
#include "lecture_scene.h"

#define SIZE 241   /* px, odd: the point P is the middle pixel's centre */
#define SMALL 161  /* px, the pictures of the coordinates */
#define REACH 1.05 /* units, half a picture's height */
#define LEVELS 16  /* bands, so that lines of equal intensity show */
#define TURNS 37   /* every 2.5 degrees of a quarter turn */

static const double corner[3][2] = {{-0.95, -0.8}, {0.95, -0.55}, {-0.15, 0.95}};
static const double level[3] = {0.95, 0.15, 0.5};

static void make_triangle(struct sheen_lecture_mesh *m, const double *intensity)
{
    unsigned v[3];

    sheen_lecture_mesh_begin(m, 2);
    for (int k = 0; k < 3; k++) {
        double normal[3], position[3] = {corner[k][0], corner[k][1], 0};
        sheen_lecture_lean(intensity[k], corner[k][0], corner[k][1], normal);
        v[k] = sheen_lecture_vertex(m, position, normal);
    }
    sheen_lecture_triangle(m, v[0], v[1], v[2]);
}

/* Draws the triangle with these intensities at its corners. */
static int measure(const double *intensity, int size, double roll, double *picture)
{
    static struct sheen_lecture_mesh triangle;
    struct sheen_lecture_scene scene;

    make_triangle(&triangle, intensity);
    sheen_lecture_scene_default(&scene, &triangle.mesh);
    scene.width = scene.height = size;
    scene.reach = REACH;
    scene.roll = roll;
    return sheen_lecture_measure(&scene, picture);
}

/* Twice the area of (a, b, P), P being the origin. */
static double area(const double *a, const double *b)
{
    return a[0] * b[1] - a[1] * b[0];
}

/* P's coordinates: a corner's is the area of the part opposite it, divided by the whole area. */
static void by_area(double b[3])
{
    double whole = 0;

    for (int k = 0; k < 3; k++)
        whole += b[k] = area(corner[(k + 1) % 3], corner[(k + 2) % 3]);
    for (int k = 0; k < 3; k++)
        b[k] /= whole;
}

/* ---- the triangle, P, and the three areas ---- */

/* The outline shows corners that are as white as the page. */
static void draw_outline(struct sheen_page *page, double x, double y, int size)
{
    for (int k = 0; k < 3; k++) {
        const double *a = corner[k], *b = corner[(k + 1) % 3];
        double scale = size / 2.0 / REACH, cx = x + size / 2.0, cy = y + size / 2.0;
        sheen_page_line(page, SHEEN_INK_FAINT, 0.8, cx + a[0] * scale, cy - a[1] * scale, cx + b[0] * scale,
                        cy - b[1] * scale);
    }
}

static void draw_parts(struct sheen_page *page, double x, double y)
{
    static const double lean[3][2] = {{-20, 18}, {-2, 24}, {0, -8}};
    double scale = SIZE / 2.0 / REACH, px = x + SIZE / 2.0, py = y + SIZE / 2.0;

    for (int k = 0; k < 3; k++) {
        double cx = px + corner[k][0] * scale, cy = py - corner[k][1] * scale;
        sheen_page_line(page, SHEEN_INK_PAPER, 4, px, py, cx, cy);
        sheen_page_line(page, SHEEN_INK_PHONG, 1.8, px, py, cx, cy);
        sheen_page_text(page, cx + lean[k][0], cy + lean[k][1], SHEEN_CENTRE, SHEEN_INK_TEXT, "I%d = %.2f", k + 1,
                        level[k]);
    }
    sheen_page_ink(page, SHEEN_INK_PAPER);
    cairo_arc(page->cr, px, py, 8, 0, 6.2832);
    cairo_fill(page->cr);
    sheen_page_ink(page, SHEEN_INK_PHONG);
    cairo_arc(page->cr, px, py, 5, 0, 6.2832);
    cairo_fill(page->cr);
    sheen_page_text(page, px + 12, py - 4, SHEEN_LEFT, SHEEN_INK_PAPER, "P");
}

static int draw_triangle(struct sheen_page *page, double *shaded)
{
    static double bands[SIZE * SIZE];
    double x = 106, y = 128;
    int error = measure(level, SIZE, 0, shaded);

    for (int i = 0; i < SIZE * SIZE; i++)
        bands[i] = shaded[i] > 0 ? (floor(shaded[i] * LEVELS) + 0.5) / LEVELS : 0;
    sheen_page_intensity(page, x, y, 1, bands, SIZE, SIZE);
    draw_outline(page, x, y, SIZE);
    draw_parts(page, x, y);
    page->heart = (struct sheen_box){34, 104, 400, 384};
    return error;
}

/* ---- the coordinates ---- */

struct sums {
    double low, high, off; /* range of the coordinates' sum; largest error of b1 I1 + b2 I2 + b3 I3 */
};

static void add_up(double *const b[3], const double *shaded, struct sums *sums)
{
    *sums = (struct sums){2, 0, 0};
    for (int i = 0; i < SIZE * SIZE; i++) {
        double sum = b[0][i] + b[1][i] + b[2][i];
        if (sum < 0.5) /* outside the triangle */
            continue;
        sums->low = fmin(sums->low, sum);
        sums->high = fmax(sums->high, sum);
        sums->off = fmax(sums->off, fabs(b[0][i] * level[0] + b[1][i] * level[1] + b[2][i] * level[2] - shaded[i]));
    }
}

static int draw_coordinates(struct sheen_page *page, double *const b[3])
{
    static double small[SMALL * SMALL], whole[SMALL * SMALL];
    static const double all[3] = {1, 1, 1};
    int error = measure(all, SMALL, 0, whole);

    for (int k = 0; !error && k < 3; k++) {
        double one[3] = {k == 0, k == 1, k == 2}, x = 430 + (SMALL + 24) * k;
        error = measure(one, SIZE, 0, b[k]);
        if (!error)
            error = measure(one, SMALL, 0, small);
        for (int i = 0; i < SMALL * SMALL; i++)
            small[i] = whole[i] > 0 ? fmax(small[i], 1e-6) : 0;
        sheen_page_intensity(page, x, 150, 1, small, SMALL, SMALL);
        draw_outline(page, x, 150, SMALL);
        sheen_page_text(page, x + SMALL / 2, 336, SHEEN_CENTRE, SHEEN_INK_GOURAUD, "β%d: corner %d is white", k + 1,
                        k + 1);
    }
    return error;
}

static int draw_turning(struct sheen_page *page)
{
    static double picture[SIZE * SIZE];
    double low = 1, high = 0;

    for (int i = 0; i < TURNS; i++) {
        int error = measure(level, SIZE, 90.0 * i / (TURNS - 1), picture);
        if (error)
            return error;
        low = fmin(low, picture[SIZE * SIZE / 2]);
        high = fmax(high, picture[SIZE * SIZE / 2]);
    }
    sheen_page_number(page, 36, 548, SHEEN_INK_GOURAUD,
                      "while the triangle is turned by 90° the intensity at P changes by %.4f", high - low);
    return SHEEN_OK;
}

int sheen_lecture_barycentric(struct sheen_page *page)
{
    static double shaded[SIZE * SIZE], coordinate[3][SIZE * SIZE];
    double *const b[3] = {coordinate[0], coordinate[1], coordinate[2]}, exact[3];
    const int middle = SIZE * SIZE / 2;
    struct sums sums;

    sheen_page_title(page, "Barycentric coordinates",
                     "In a triangle I = β1 I1 + β2 I2 + β3 I3: no direction is special.");
    sheen_page_caption(page, "A point's coordinates are the shares of the three areas that it cuts the triangle into. "
                             "Drawn with one corner white, Gouraud shading shows them; they add up to white.");
    int error = draw_triangle(page, shaded);
    if (!error)
        error = draw_coordinates(page, b);
    if (error)
        return error;
    by_area(exact);
    add_up(b, shaded, &sums);
    sheen_page_number(page, 36, 424, SHEEN_INK_GOURAUD, "at P the core draws β = %.4f, %.4f, %.4f", b[0][middle],
                      b[1][middle], b[2][middle]);
    sheen_page_number(page, 36, 450, SHEEN_INK_FLAT, "by areas β = %.4f, %.4f, %.4f", exact[0], exact[1], exact[2]);
    sheen_page_number(page, 36, 496, SHEEN_INK_GOURAUD, "β1 + β2 + β3 over all pixels: from %.4f to %.4f", sums.low,
                      sums.high);
    sheen_page_number(page, 36, 522, SHEEN_INK_GOURAUD,
                      "β1 I1 + β2 I2 + β3 I3 against the shaded triangle: off by at most %.4f", sums.off);
    return draw_turning(page);
}
