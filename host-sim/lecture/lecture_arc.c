/*
 * lecture_arc.c - the normals between two ends: linear interpolation (lerp) against a great arc (slerp).
 *
 * The core's normals are read from its pixels. A row lit along the left normal shows
 * cos(angle); lit at a right angle to it, in the arc's plane, it shows sin(angle).
 */
#include <math.h>

#include "lecture.h"
#include "lecture_scene.h"

#define COUNT 180 /* px along the arc */
#define ROWS 9
#define FAN 8     /* parts that a fan is divided into */
#define REACH 126 /* length of a fan's rays, px */

int sheen_lecture_angles(int shading, double degrees, int count, double *angle)
{
    static struct sheen_lecture_mesh facet;
    static double part[2][512 * ROWS]; /* cosines and sines */
    struct sheen_lecture_scene scene;

    sheen_lecture_facet(&facet, degrees, count, ROWS);
    for (int k = 0; k < 2; k++) {
        sheen_lecture_facet_scene(&scene, &facet, count, ROWS, degrees / 2 - 90 * k);
        scene.shading = shading;
        int error = sheen_lecture_measure(&scene, part[k]);
        if (error)
            return error;
    }
    for (int i = 0; i < count; i++)
        angle[i] = atan2(part[1][ROWS / 2 * count + i], part[0][ROWS / 2 * count + i]) * 180 / M_PI;
    return SHEEN_OK;
}

/* Degrees that the linearly interpolated normal has turned at t. */
static double lerp_angle(double degrees, double t)
{
    double phi = degrees * M_PI / 180;

    return atan2(t * sin(phi), 1 - t + t * cos(phi)) * 180 / M_PI;
}

/* Draws normals at even steps of t, read from the core's pixels, as rays from (x, y). */
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
        double degrees = angle[i] + (at - i) * (angle[i + 1] - angle[i]), turn = (180 - 45 - degrees) * M_PI / 180;
        sheen_page_line(page, ink, 2.4, x, y, x + REACH * cos(turn), y - REACH * sin(turn));
        if (k > 0) {
            *widest = fmax(*widest, degrees - last);
            *narrowest = fmin(*narrowest, degrees - last);
        }
        last = degrees;
    }
    return error;
}

/* Draws what is divided into even parts: the arc for slerp, the chord for lerp. */
static void draw_cuts(struct sheen_page *page, double x, double y, int slerp)
{
    double chord = REACH * sqrt(0.5);

    sheen_page_ink(page, SHEEN_INK_FAINT);
    cairo_set_line_width(page->cr, 1.4);
    if (slerp)
        cairo_arc(page->cr, x, y, REACH, -M_PI * 3 / 4, -M_PI / 4);
    else {
        cairo_move_to(page->cr, x - chord, y - chord);
        cairo_line_to(page->cr, x + chord, y - chord);
    }
    cairo_stroke(page->cr);
}

static int draw_fans(struct sheen_page *page)
{
    static const int shading[2] = {SHEEN_PHONG, SHEEN_SLERP};

    for (int k = 0; k < 2; k++) {
        double widest, narrowest, x = 132 + 190 * k, y = 262;
        enum sheen_ink ink = k ? SHEEN_INK_SLERP : SHEEN_INK_PHONG;
        draw_cuts(page, x, y, k);
        int error = draw_fan(page, x, y, shading[k], &widest, &narrowest);
        if (error)
            return error;
        sheen_page_text(page, x, y + 26, SHEEN_CENTRE, ink, k ? "slerp: the arc" : "lerp: the chord");
        sheen_page_text(page, x, y + 48, SHEEN_CENTRE, ink, "in 8 even parts");
        sheen_page_number(page, 36, 380 + 26 * k, ink, "%s over 90°: eighths of %.2f° to %.2f°", k ? "slerp" : "lerp",
                          narrowest, widest);
    }
    page->heart = (struct sheen_box){32, 116, 422, 330};
    return SHEEN_OK;
}

static int draw_curves(struct sheen_page *page)
{
    static const double span[3] = {30, 60, 90};
    struct sheen_axes axes = {490, 128, 472, 310, 0, 1, -4.5, 4.5};
    double t[COUNT], angle[COUNT], off[COUNT], truth[COUNT];

    sheen_page_axes(page, &axes, 0.25, 2, 1.5, 1);
    sheen_page_axis_names(page, &axes, "t, from the first normal to the second", "degrees ahead of an even turn");
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
            sheen_page_text(page, 850, k == 1 ? 238 : 170, SHEEN_CENTRE, SHEEN_INK_PHONG, "lerp, %.0f°", degrees);
        sheen_page_number(page, 36 + 490 * slerp, 512 + 26 * (k % 3), slerp ? SHEEN_INK_SLERP : SHEEN_INK_PHONG,
                          "%s %.0f°: at most %.3f° ahead (formula %.3f°)", slerp ? "slerp" : "lerp", degrees, most,
                          by_formula);
    }
    sheen_page_text(page, 845, 316, SHEEN_CENTRE, SHEEN_INK_SLERP, "slerp, 30°, 60° and 90°");
    return SHEEN_OK;
}

int sheen_lecture_arc(struct sheen_page *page)
{
    sheen_page_title(page, "Normals by lerp and by slerp",
                     "Normals on a great arc turn evenly, which is more natural than linear interpolation.");
    sheen_page_caption(page, "Normals read from the pixels that the core drew. Interpolated along the chord they hurry "
                             "through the middle (blue); along the arc they do not (green). Grey: the formulas.");
    int error = draw_fans(page);

    return error ? error : draw_curves(page);
}
