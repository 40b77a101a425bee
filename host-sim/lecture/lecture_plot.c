/*
 * lecture_plot.c - axes and curves on a page.
 */
#include "lecture_plot.h"

#include <math.h>

/* Values to px of the page; y grows upwards in a plot. */
static double place_x(const struct sheen_axes *a, double x)
{
    return a->x + (x - a->x0) / (a->x1 - a->x0) * a->width;
}

static double place_y(const struct sheen_axes *a, double y)
{
    return a->y + (a->y1 - y) / (a->y1 - a->y0) * a->height;
}

void sheen_page_line(struct sheen_page *page, enum sheen_ink ink, double line_width, double x0, double y0, double x1,
                     double y1)
{
    sheen_page_ink(page, ink);
    cairo_set_line_width(page->cr, line_width);
    cairo_move_to(page->cr, x0, y0);
    cairo_line_to(page->cr, x1, y1);
    cairo_stroke(page->cr);
}

/* Where a grid begins: the first multiple of step that is not below low. */
static double first_step(double low, double step)
{
    return ceil(low / step - 1e-9) * step;
}

void sheen_page_axes(struct sheen_page *page, const struct sheen_axes *a, double x_step, int x_decimals, double y_step,
                     int y_decimals)
{
    for (double v = first_step(a->x0, x_step); v <= a->x1 + 1e-9 * x_step; v += x_step) {
        double x = place_x(a, v);
        sheen_page_line(page, SHEEN_INK_FAINT, 0.4, x, a->y, x, a->y + a->height);
        if (x_decimals >= 0)
            sheen_page_text(page, x, a->y + a->height + 20, SHEEN_CENTRE, SHEEN_INK_TEXT, "%.*f", x_decimals,
                            fabs(v) < 1e-9 * x_step ? 0 : v);
    }
    for (double v = first_step(a->y0, y_step); v <= a->y1 + 1e-9 * y_step; v += y_step) {
        double y = place_y(a, v);
        sheen_page_line(page, SHEEN_INK_FAINT, 0.4, a->x, y, a->x + a->width, y);
        if (y_decimals >= 0)
            sheen_page_text(page, a->x - 8, y + 5, SHEEN_RIGHT, SHEEN_INK_TEXT, "%.*f", y_decimals,
                            fabs(v) < 1e-9 * y_step ? 0 : v);
    }
    sheen_page_ink(page, SHEEN_INK_FLAT);
    cairo_set_line_width(page->cr, 1);
    cairo_rectangle(page->cr, a->x, a->y, a->width, a->height);
    cairo_stroke(page->cr);
}

void sheen_page_axis_names(struct sheen_page *page, const struct sheen_axes *a, const char *below, const char *above)
{
    if (below)
        sheen_page_text(page, a->x + a->width / 2, a->y + a->height + 40, SHEEN_CENTRE, SHEEN_INK_TEXT, "%s", below);
    if (above)
        sheen_page_text(page, a->x, a->y - 8, SHEEN_LEFT, SHEEN_INK_TEXT, "%s", above);
}

void sheen_page_curve(struct sheen_page *page, const struct sheen_axes *a, enum sheen_ink ink, double line_width,
                      const double *x, const double *y, int count)
{
    cairo_save(page->cr);
    cairo_rectangle(page->cr, a->x, a->y, a->width, a->height);
    cairo_clip(page->cr);
    sheen_page_ink(page, ink);
    cairo_set_line_width(page->cr, line_width);
    cairo_set_line_join(page->cr, CAIRO_LINE_JOIN_ROUND);
    for (int i = 0; i < count; i++)
        cairo_line_to(page->cr, place_x(a, x[i]), place_y(a, y[i]));
    cairo_stroke(page->cr);
    cairo_restore(page->cr);
}

void sheen_page_dot(struct sheen_page *page, const struct sheen_axes *a, enum sheen_ink ink, double x, double y)
{
    sheen_page_ink(page, ink);
    cairo_arc(page->cr, place_x(a, x), place_y(a, y), 4.5, 0, 6.2832);
    cairo_fill(page->cr);
}
