/*
 * lecture_arc.c - normals between two ends: interpolated (lerp) against on a great arc (slerp).
 *
 * The core's normals are read from its pixels: lit along the left normal a row shows
 * cos(angle), lit at a right angle to it, within the arc's plane, sin(angle).
 */
#include <math.h>

#include "lecture.h"
#include "lecture_scene.h"

#define PI 3.14159265358979323846
#define COUNT 180 /* px along the arc */
#define ROWS 9
#define FAN 8 /* parts of a fan */

/* A facet across the whole picture, its normals +-degrees/2 from the eye's direction. */
static void make_facet(struct sheen_lecture_mesh *m, double degrees, double half_width, double half_height)
{
    unsigned v[4];

    sheen_lecture_mesh_begin(m, 2);
    for (int k = 0; k < 4; k++) {
        int right = k == 1 || k == 2;
        double lean = (right ? degrees : -degrees) / 2 * PI / 180, normal[3] = {sin(lean), 0, cos(lean)};
        double position[3] = {right ? half_width : -half_width, k > 1 ? half_height : -half_height, 0};
        v[k] = sheen_lecture_vertex(m, position, normal);
    }
    sheen_lecture_quad(m, v[0], v[1], v[2], v[3]);
}

int sheen_lecture_angles(int shading, double degrees, int count, double *angle)
{
    static struct sheen_lecture_mesh facet;
    static double part[2][512 * ROWS]; /* cosines and sines */
    struct sheen_lecture_scene scene;
    double left = -degrees / 2 * PI / 180;

    /* A pixel is 1/256 unit, so that the facet's corners lie on pixel corners. */
    make_facet(&facet, degrees, count / 512.0, 0.03125);
    sheen_lecture_scene_default(&scene, &facet);
    scene.width = count;
    scene.height = ROWS;
    scene.distance = 1; /* fov stays above a degree */
    scene.reach = ROWS / 512.0;
    scene.shading = shading;
    for (int k = 0; k < 2; k++) {
        scene.light[0] = sin(left + k * PI / 2);
        scene.light[1] = 0;
        scene.light[2] = cos(left + k * PI / 2);
        int error = sheen_lecture_measure(&scene, part[k]);
        if (error)
            return error;
    }
    for (int i = 0; i < count; i++)
        angle[i] = atan2(part[1][ROWS / 2 * count + i], part[0][ROWS / 2 * count + i]) * 180 / PI;
    return SHEEN_OK;
}

/* Of the normal that is interpolated linearly. */
static double lerp_angle(double degrees, double t)
{
    double phi = degrees * PI / 180;

    return atan2(t * sin(phi), 1 - t + t * cos(phi)) * 180 / PI;
}

/* Normals at even steps of t, read from the core's pixels, as rays from (x, y). */
static int draw_fan(struct sheen_page *page, double x, double y, int shading, double *widest, double *narrowest)
{
    enum sheen_ink ink = shading == SHEEN_SLERP ? SHEEN_INK_SLERP : SHEEN_INK_PHONG;
    double angle[COUNT], last = 0;
    int error = sheen_lecture_angles(shading, 90, COUNT, angle);

    *widest = 0;
    *narrowest = 90;
    for (int k = 0; !error && k <= FAN; k++) {
        double at = k * COUNT / (double)FAN - 0.5; /* between the pixels */
        int i = (int)fmin(fmax(at, 0), COUNT - 2);
        double degrees = angle[i] + (at - i) * (angle[i + 1] - angle[i]), turn = (180 - 45 - degrees) * PI / 180;
        sheen_page_line(page, ink, 2.4, x, y, x + 160 * cos(turn), y - 160 * sin(turn));
        if (k > 0) {
            *widest = fmax(*widest, degrees - last);
            *narrowest = fmin(*narrowest, degrees - last);
        }
        last = degrees;
    }
    return error;
}

static int draw_fans(struct sheen_page *page)
{
    static const int shading[2] = {SHEEN_PHONG, SHEEN_SLERP};

    for (int k = 0; k < 2; k++) {
        double widest, narrowest, y = 280 + 214 * k;
        int error = draw_fan(page, 190, y, shading[k], &widest, &narrowest);
        if (error)
            return error;
        sheen_page_text(page, 190, y + 24, SHEEN_CENTRE, k ? SHEEN_INK_SLERP : SHEEN_INK_PHONG, "%s, even steps of t",
                        k ? "slerp" : "lerp");
        sheen_page_number(page, 36, 566 + 26 * k, k ? SHEEN_INK_SLERP : SHEEN_INK_PHONG,
                          "%s over 90°: eighths of %.2f° to %.2f°", k ? "slerp" : "lerp", narrowest, widest);
    }
    return SHEEN_OK;
}

static int draw_curves(struct sheen_page *page)
{
    static const double span[3] = {30, 60, 90};
    struct sheen_axes axes = {430, 118, 532, 330, 0, 1, -4.5, 4.5};
    double t[COUNT], angle[COUNT], off[COUNT], truth[COUNT];

    sheen_page_axes(page, &axes, 0.25, 2, 1.5, 1);
    sheen_page_axis_names(page, &axes, "t", "angle from the first normal, less t times the whole, degrees");
    for (int k = 0; k < 6; k++) {
        double degrees = span[k % 3], most = 0, by_formula = 0;
        int slerp = k >= 3, error = sheen_lecture_angles(slerp ? SHEEN_SLERP : SHEEN_PHONG, degrees, COUNT, angle);
        if (error)
            return error;
        for (int i = 0; i < COUNT; i++) {
            t[i] = (i + 0.5) / COUNT;
            off[i] = angle[i] - t[i] * degrees;
            truth[i] = slerp ? 0 : lerp_angle(degrees, t[i]) - t[i] * degrees;
            most = fmax(most, fabs(off[i]));
            by_formula = fmax(by_formula, fabs(truth[i]));
        }
        sheen_page_curve(page, &axes, SHEEN_INK_FAINT, 5, t, truth, COUNT);
        sheen_page_curve(page, &axes, slerp ? SHEEN_INK_SLERP : SHEEN_INK_PHONG, 1.8, t, off, COUNT);
        if (!slerp && k > 0)
            sheen_page_text(page, 838, k == 1 ? 234 : 156, SHEEN_CENTRE, SHEEN_INK_PHONG, "%.0f°", degrees);
        sheen_page_number(page, 410 + 290 * slerp, 528 + 26 * (k % 3), slerp ? SHEEN_INK_SLERP : SHEEN_INK_PHONG,
                          "%s %.0f°: %.3f° (formula %.3f°)", slerp ? "slerp" : "lerp", degrees, most, by_formula);
    }
    return SHEEN_OK;
}

int sheen_lecture_arc(struct sheen_page *page)
{
    sheen_page_title(page, "Normals by lerp and by slerp",
                     "Interpolated normals hurry through the middle, normals on a great arc step evenly. "
                     "Formulas in grey.");
    int error = draw_fans(page);

    return error ? error : draw_curves(page);
}
