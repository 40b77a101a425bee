/*
 * lecture_increments.c - slerp step by step against its closed form, along a row of 320 px and a right angle.
 *
 * The lecture expands the steps of sines and cosines: four products per pixel, exact except for rounding. With 16-bit
 * numbers the step's own cosine is rounded, and the error grows along the row. The core approximates arcs by a series,
 * a quadratic over each part of a row (slerp_parts.c), so that no error is carried from pixel to pixel for long.
 */
#include <math.h>

#include "lecture.h"
#include "lecture_scene.h"

#define COUNT 320
#define ROWS 9
#define DEGREES 90
#define FROM 20.0 /* direction of the light, degrees left of the eye's */

/* Angles from the light to N1 and N2, the normals DEGREES / 2 to either side of the eye's direction. */
static const double ends[2] = {-DEGREES / 2.0 + FROM, DEGREES / 2.0 + FROM};

static double closed_form(double t)
{
    double phi = DEGREES * M_PI / 180;

    return (sin((1 - t) * phi) * cos(ends[0] * M_PI / 180) + sin(t * phi) * cos(ends[1] * M_PI / 180)) / sin(phi);
}

/* x rounded to `bits` bits after the point; 0: not rounded. */
static double rounded(double x, int bits)
{
    return bits > 0 ? floor(ldexp(x, bits) + 0.5) / ldexp(1, bits) : x;
}

/* The lecture's four lines, each sine and cosine rounded to `bits` bits. */
static void lecture_steps(int bits, double *row)
{
    double phi = DEGREES * M_PI / 180, step = phi / COUNT, at = step / 2; /* the first pixel's centre */
    double s = rounded(sin(at), bits), c = rounded(cos(at), bits);
    double s_left = rounded(sin(phi - at), bits), c_left = rounded(cos(phi - at), bits);
    double ds = rounded(sin(step), bits), dc = rounded(cos(step), bits);

    for (int i = 0; i < COUNT; i++) {
        row[i] = (s_left * cos(ends[0] * M_PI / 180) + s * cos(ends[1] * M_PI / 180)) / sin(phi);
        double next = rounded(s * dc + c * ds, bits), next_left = rounded(s_left * dc - c_left * ds, bits);
        c = rounded(c * dc - s * ds, bits);
        c_left = rounded(c_left * dc + s_left * ds, bits);
        s = next;
        s_left = next_left;
    }
}

struct rows {
    double x[COUNT], exact[COUNT], core[COUNT], lecture[COUNT]; /* px, L.N */
    double core_off[COUNT], lecture_off[COUNT];                 /* error, levels of 255 */
    double core_most, lecture_most, doubles_most;               /* largest error, levels of 255 */
};

static int take_rows(struct rows *r)
{
    static struct sheen_lecture_mesh facet;
    static double picture[COUNT * ROWS], doubles[COUNT];
    struct sheen_lecture_scene scene;

    sheen_lecture_facet(&facet, DEGREES, COUNT, ROWS);
    sheen_lecture_facet_scene(&scene, &facet, COUNT, ROWS, FROM);
    scene.shading = SHEEN_SLERP;
    int error = sheen_lecture_measure(&scene, picture);
    lecture_steps(14, r->lecture);
    lecture_steps(0, doubles);
    for (int i = 0; i < COUNT; i++) {
        r->x[i] = i + 0.5;
        r->exact[i] = closed_form((i + 0.5) / COUNT);
        r->core[i] = picture[ROWS / 2 * COUNT + i];
        r->core_off[i] = 255 * (r->core[i] - r->exact[i]);
        r->lecture_off[i] = 255 * (r->lecture[i] - r->exact[i]);
        r->core_most = fmax(r->core_most, fabs(r->core_off[i]));
        r->lecture_most = fmax(r->lecture_most, fabs(r->lecture_off[i]));
        r->doubles_most = fmax(r->doubles_most, 255 * fabs(doubles[i] - r->exact[i]));
    }
    return error;
}

int sheen_lecture_increments(struct sheen_page *page)
{
    static struct rows r;
    struct sheen_axes light = {552, 128, 410, 240, 0, COUNT, 0, 1.05};
    struct sheen_axes off = {76, 128, 340, 240, 0, COUNT, -0.5, 3};

    r.core_most = r.lecture_most = r.doubles_most = 0;
    int error = take_rows(&r);
    sheen_page_title(page, "Slerp step by step",
                     "Sines and cosines of even steps follow from the last ones: slerp needs no sine a pixel.");
    sheen_page_caption(page,
                       "Light along a row of 320 px whose normals turn by 90°. Stepped as printed with 16-bit sines "
                       "it drifts (red); the core steps the light itself, and stays on the closed form (grey).");
    sheen_page_axes(page, &light, 80, 0, 0.25, 2);
    sheen_page_axis_names(page, &light, "px along the row", "light L·N");
    sheen_page_curve(page, &light, SHEEN_INK_FAINT, 6, r.x, r.exact, COUNT);
    sheen_page_curve(page, &light, SHEEN_INK_SLERP, 2, r.x, r.core, COUNT);
    sheen_page_text(page, 757, 262, SHEEN_CENTRE, SHEEN_INK_SLERP, "the core, step by step,");
    sheen_page_text(page, 757, 284, SHEEN_CENTRE, SHEEN_INK_FLAT, "on the closed form");
    page->heart = (struct sheen_box){30, 104, 436, 420};
    sheen_page_axes(page, &off, 80, 0, 0.5, 1);
    sheen_page_axis_names(page, &off, "px along the row", "off the closed form, levels of 255");
    sheen_page_curve(page, &off, SHEEN_INK_WRONG, 1.8, r.x, r.lecture_off, COUNT);
    sheen_page_curve(page, &off, SHEEN_INK_SLERP, 1.8, r.x, r.core_off, COUNT);
    sheen_page_text(page, 250, 216, SHEEN_RIGHT, SHEEN_INK_WRONG, "printed, 16 bits");
    sheen_page_text(page, 300, 322, SHEEN_LEFT, SHEEN_INK_SLERP, "the core");
    sheen_page_number(page, 36, 480, SHEEN_INK_WRONG, "the lecture's steps, 16-bit sines: off by up to %.2f/255",
                      r.lecture_most);
    sheen_page_number(page, 36, 506, SHEEN_INK_FLAT, "the same in doubles: %.1g/255", r.doubles_most);
    sheen_page_number(page, 36, 532, SHEEN_INK_SLERP, "the core's pixels: off by at most %.2f/255", r.core_most);
    return error;
}
