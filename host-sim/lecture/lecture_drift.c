/*
 * lecture_drift.c - the lecture's N_new = (N_old + dN) / |N_old + dN|, read as a recursion.
 *
 * dN is the step between unnormalised normals, so a normal that is renormalised at each step
 * falls behind. Let a be its angle to the chord d = N2 - N1: in the limit of small steps
 * da = -sin(a) ds along the chord, so that tan(a/2) ends at tan(a0/2) exp(-|d|). For normals
 * 60 degrees apart that is 5 degrees short. The core keeps N unnormalised and normalises a copy.
 */
#include <math.h>

#include "lecture.h"
#include "sheen.h"

#define STEPS 120 /* px from one normal to the other */
#define SPANS 91  /* whole degrees 0..90 */

/* The recursion in the plane of both normals: angle[i] is the degrees turned after i steps. */
static void naive(double degrees, int steps, double *angle)
{
    double phi = degrees * M_PI / 180, x = 1, y = 0;

    angle[0] = 0;
    for (int i = 1; i <= steps; i++) {
        x += (cos(phi) - 1) / steps;
        y += sin(phi) / steps;
        double length = hypot(x, y);
        x /= length;
        y /= length;
        angle[i] = atan2(y, x) * 180 / M_PI;
    }
}

/* The degrees turned at the end, in the limit of small steps. */
static double naive_limit(double degrees)
{
    double phi = degrees * M_PI / 180, start = M_PI / 2 + phi / 2;

    return (start - 2 * atan(tan(start / 2) * exp(-2 * sin(phi / 2)))) * 180 / M_PI;
}

static int draw_steps(struct sheen_page *page)
{
    struct sheen_axes axes = {76, 128, 340, 240, 0, STEPS, 0, 65};
    double x[STEPS + 1], wrong[STEPS + 1], core[STEPS], centre[STEPS];
    int error = sheen_lecture_angles(SHEEN_PHONG, 60, STEPS, core);

    if (error)
        return error;
    naive(60, STEPS, wrong);
    for (int i = 0; i <= STEPS; i++)
        x[i] = i;
    for (int i = 0; i < STEPS; i++)
        centre[i] = i + 0.5;
    double end = core[STEPS - 1] + (core[STEPS - 1] - core[STEPS - 2]) / 2; /* half a pixel on */
    sheen_page_axes(page, &axes, 20, 0, 15, 0);
    sheen_page_axis_names(page, &axes, "px along the row", "degrees from the first normal");
    page->heart = (struct sheen_box){36, 104, 436, 420};
    sheen_page_curve(page, &axes, SHEEN_INK_WRONG, 2.2, x, wrong, STEPS + 1);
    sheen_page_curve(page, &axes, SHEEN_INK_PHONG, 2.2, centre, core, STEPS);
    sheen_page_dot(page, &axes, SHEEN_INK_WRONG, STEPS, wrong[STEPS]);
    sheen_page_dot(page, &axes, SHEEN_INK_PHONG, STEPS, end);
    sheen_page_text(page, 300, 300, SHEEN_LEFT, SHEEN_INK_WRONG, "renormalised");
    sheen_page_text(page, 270, 190, SHEEN_RIGHT, SHEEN_INK_PHONG, "kept as it is");
    sheen_page_number(page, 36, 480, SHEEN_INK_WRONG, "renormalised at each of %d steps: ends at %.2f°", STEPS,
                      wrong[STEPS]);
    sheen_page_number(page, 36, 506, SHEEN_INK_FLAT, "in endless small steps: %.2f°", naive_limit(60));
    sheen_page_number(page, 36, 532, SHEEN_INK_PHONG, "kept unnormalised, as the core's pixels show: %.2f°", end);
    return SHEEN_OK;
}

static void draw_spans(struct sheen_page *page)
{
    static const int steps[3] = {4, 16, 256};
    struct sheen_axes axes = {552, 128, 410, 240, 0, 90, 0, 18};
    double degrees[SPANS], missing[SPANS], angle[257];

    sheen_page_axes(page, &axes, 15, 0, 3, 0);
    sheen_page_axis_names(page, &axes, "degrees between the two normals",
                          "degrees missing at the end (thick: more steps)");
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < SPANS; i++) {
            degrees[i] = i;
            naive(i, steps[k], angle);
            missing[i] = i - angle[steps[k]];
        }
        sheen_page_curve(page, &axes, SHEEN_INK_WRONG, 1 + 0.6 * k, degrees, missing, SPANS);
        sheen_page_number(page, 500, 480 + 26 * k, SHEEN_INK_WRONG,
                          "%d steps: missing %.2f° at 30°, %.2f° at 60°, %.2f° at 90°", steps[k], missing[30],
                          missing[60], missing[90]);
    }
}

int sheen_lecture_drift(struct sheen_page *page)
{
    sheen_page_title(page, "Normals step by step",
                     "The next normal is the last one plus a constant step, brought to unit length.");
    sheen_page_caption(page, "Read as a recursion that is a misprint: steps are too short for a normal that was "
                             "lengthened, and it never arrives (red). The core steps on unnormalised (blue).");
    int error = draw_steps(page);

    if (!error)
        draw_spans(page);
    return error;
}
