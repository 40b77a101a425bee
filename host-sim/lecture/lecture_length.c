/*
 * lecture_length.c - D(t), the squared length of an interpolated normal, by second differences.
 *
 * With c = N1.N2, D(t) = (1 - t)^2 + t^2 + 2 t (1 - t) c. The lecture as printed loses a sign in the first line of D's
 * change, so E and F, derived from that line, are wrong too. With the sign put right the second difference is constant:
 * 4 (1 - c) dt^2. The core steps D in this way, in UQ1.31, modulo 2^32 (phong_rows.c).
 */
#include <math.h>

#include "lecture.h"
#include "triangle/quadric.h"

#define STEPS 120 /* px from one normal to the other */
#define DEGREES 60

static double exact(double t, double c)
{
    return (1 - t) * (1 - t) + t * t + 2 * t * (1 - t) * c;
}

/* D as printed: by the second line of the lecture's change of D, and by its E - F(t). */
static void printed(double c, double *second_line, double *e_less_f)
{
    double dt = 1.0 / STEPS, e = 2 * dt * (1 + dt + (1 + dt) * c);

    second_line[0] = e_less_f[0] = 1;
    for (int i = 0; i < STEPS; i++) {
        double t = i * dt;
        second_line[i + 1] = second_line[i] + 2 * dt * (1 + dt + (1 - 2 * t + dt) * c);
        e_less_f[i + 1] = e_less_f[i] + e - 2 * t * c;
    }
}

/* D as the core's rows step it: two adds per pixel. */
static void stepped(double c, double *d)
{
    const double one = 2147483648.0, dt = 1.0 / STEPS;
    const struct quadric q = {.base = 0x80000000u,
                              .dx = (uint32_t)(int32_t)lround(-2 * (1 - c) * dt * (1 - dt) * one),
                              .dxx = (uint32_t)lround(4 * (1 - c) * dt * dt * one)};
    uint32_t value, step, bend;

    quadric_run(&q, 0, &value, &step, &bend);
    for (int i = 0; i <= STEPS; i++) {
        d[i] = value / one;
        value += step;
        step += bend;
    }
}

struct rows {
    double x[STEPS + 1], exact[STEPS + 1], core[STEPS + 1], second_line[STEPS + 1], e_less_f[STEPS + 1];
};

static void draw_plot(struct sheen_page *page, const struct rows *r)
{
    struct sheen_axes axes = {76, 128, 340, 240, 0, STEPS, 0, 3};

    sheen_page_axes(page, &axes, 20, 0, 0.5, 1);
    sheen_page_axis_names(page, &axes, "px along the row", "D, the squared length of the normal");
    sheen_page_curve(page, &axes, SHEEN_INK_FAINT, 5, r->x, r->exact, STEPS + 1);
    sheen_page_curve(page, &axes, SHEEN_INK_WRONG, 2, r->x, r->second_line, STEPS + 1);
    sheen_page_curve(page, &axes, SHEEN_INK_WRONG, 2, r->x, r->e_less_f, STEPS + 1);
    sheen_page_curve(page, &axes, SHEEN_INK_PHONG, 2, r->x, r->core, STEPS + 1);
    sheen_page_text(page, 290, 268, SHEEN_CENTRE, SHEEN_INK_PHONG, "mended: two adds a pixel");
    sheen_page_text(page, 258, 168, SHEEN_RIGHT, SHEEN_INK_WRONG, "as printed");
    sheen_page_text(page, 140, 352, SHEEN_LEFT, SHEEN_INK_WRONG, "E - F(t), as printed");
    page->heart = (struct sheen_box){36, 104, 436, 420};
}

static void draw_formulas(struct sheen_page *page)
{
    double x = 480;

    sheen_page_text(page, x, 134, SHEEN_LEFT, SHEEN_INK_FLAT, "with c = N1·N2, from pixel to pixel");
    sheen_page_text(page, x, 166, SHEEN_LEFT, SHEEN_INK_TEXT, "D(t) = (1 - t)² + t² + 2 t (1 - t) c");
    sheen_page_text(page, x, 214, SHEEN_LEFT, SHEEN_INK_WRONG, "printed:");
    sheen_page_text(page, x + 90, 214, SHEEN_LEFT, SHEEN_INK_WRONG, "ΔD = 2 Δt (1 + Δt + (1 - 2t + Δt) c)");
    sheen_page_text(page, x + 90, 242, SHEEN_LEFT, SHEEN_INK_WRONG, "ΔD = E - F(t),  F(t) = 2 t c");
    sheen_page_text(page, x, 290, SHEEN_LEFT, SHEEN_INK_PHONG, "mended:");
    sheen_page_text(page, x + 90, 290, SHEEN_LEFT, SHEEN_INK_PHONG, "ΔD = 2 Δt (2t - 1 + Δt) (1 - c)");
    sheen_page_text(page, x + 90, 318, SHEEN_LEFT, SHEEN_INK_PHONG, "ΔΔD = 4 (1 - c) Δt², a constant");
    sheen_page_text(page, x, 366, SHEEN_LEFT, SHEEN_INK_FLAT, "The print lost the minus of -2 (1 - t) Δt.");
}

int sheen_lecture_length(struct sheen_page *page)
{
    static struct rows r;
    double c = cos(DEGREES * M_PI / 180), off = 0, least = 1;

    for (int i = 0; i <= STEPS; i++) {
        r.x[i] = i;
        r.exact[i] = exact(i / (double)STEPS, c);
    }
    printed(c, r.second_line, r.e_less_f);
    stepped(c, r.core);
    for (int i = 0; i <= STEPS; i++) {
        off = fmax(off, fabs(r.core[i] - r.exact[i]));
        least = fmin(least, r.core[i]);
    }
    sheen_page_title(page, "Lengths by adding", "Between two normals the squared length D needs two adds a pixel.");
    sheen_page_caption(page,
                       "Half way between normals 60° apart the interpolated one has D = 3/4. The printed formulas "
                       "(red) miss it by a lost sign; mended (blue) they are what the core adds up in integers.");
    draw_plot(page, &r);
    draw_formulas(page);
    sheen_page_number(page, 36, 470, SHEEN_INK_WRONG, "as printed: D ends at %.4f, and at %.2f by E - F(t)",
                      r.second_line[STEPS], r.e_less_f[STEPS]);
    sheen_page_number(page, 36, 496, SHEEN_INK_PHONG, "mended, in 32-bit integers: %.6f in the middle, %.6f at the end",
                      least, r.core[STEPS]);
    sheen_page_number(page, 36, 522, SHEEN_INK_FLAT, "the core's steps are off by at most %.1f millionths", 1e6 * off);
    return SHEEN_OK;
}
