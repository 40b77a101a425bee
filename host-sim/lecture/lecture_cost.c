/*
 * lecture_cost.c - what each shading costs, as last measured by the bench (lecture_cost.h, from tests/bench/budget).
 */
#include "lecture_cost.h"
#include "lecture.h"

#define BAR 21 /* px high */
#define GROUP (2 * BAR + 20)

static const struct {
    const char *name;
    enum sheen_ink ink;
} shadings[4] = {
    {"flat", SHEEN_INK_FLAT}, {"Gouraud", SHEEN_INK_GOURAUD}, {"Phong", SHEEN_INK_PHONG}, {"slerp", SHEEN_INK_SLERP}};

static const char *const processors[2] = {"Cortex-M0+", "Cortex-M3"};

/* The M3's bars are the paler ones. The largest cost is `width` px long. */
static void draw_bars(struct sheen_page *page, double x, double y, double width, const double cost[2][4], int decimals,
                      const char *unit)
{
    double most = 0;

    for (int p = 0; p < 2; p++)
        for (int k = 0; k < 4; k++)
            most = cost[p][k] > most ? cost[p][k] : most;
    for (int k = 0; k < 4; k++) {
        double top = y + GROUP * k;
        sheen_page_text(page, x - 10, top + BAR + 5, SHEEN_RIGHT, shadings[k].ink, "%s", shadings[k].name);
        for (int p = 0; p < 2; p++) {
            double length = width * cost[p][k] / most, at = top + (BAR + 2) * p;
            sheen_page_ink(page, shadings[k].ink);
            cairo_rectangle(page->cr, x, at, length, BAR);
            cairo_fill(page->cr);
            if (p == 1) {
                cairo_set_source_rgba(page->cr, 1, 1, 1, 0.45);
                cairo_rectangle(page->cr, x, at, length, BAR);
                cairo_fill(page->cr);
            }
            sheen_page_text(page, x + length + 8, at + 16, SHEEN_LEFT, SHEEN_INK_TEXT, "%.*f%s", decimals, cost[p][k],
                            k == 0 ? unit : "");
        }
    }
}

static void draw_key(struct sheen_page *page, double x, double y)
{
    sheen_page_ink(page, SHEEN_INK_FLAT);
    cairo_rectangle(page->cr, x, y, 26, 14);
    cairo_fill(page->cr);
    sheen_page_text(page, x + 34, y + 13, SHEEN_LEFT, SHEEN_INK_TEXT, "%s", processors[0]);
    sheen_page_ink(page, SHEEN_INK_FLAT);
    cairo_rectangle(page->cr, x + 156, y, 26, 14);
    cairo_fill(page->cr);
    cairo_set_source_rgba(page->cr, 1, 1, 1, 0.45);
    cairo_rectangle(page->cr, x + 156, y, 26, 14);
    cairo_fill(page->cr);
    sheen_page_text(page, x + 190, y + 13, SHEEN_LEFT, SHEEN_INK_TEXT, "%s", processors[1]);
}

int sheen_lecture_cost(struct sheen_page *page)
{
    sheen_page_title(page, "What a shading costs",
                     "Phong is slower than Gouraud: light is found anew at each point, from its own normal.");
    sheen_page_caption(page,
                       "Instructions, counted. On large triangles whose normals differ much each pixel pays (left). "
                       "Where they nearly agree the core takes cheaper ways: the frame of a sphere (right).");
    sheen_page_text(page, 110, 124, SHEEN_LEFT, SHEEN_INK_TEXT, "a pixel of two large triangles");
    draw_bars(page, 110, 140, 240, pixel_cost, 0, " instructions");
    sheen_page_text(page, 592, 124, SHEEN_LEFT, SHEEN_INK_TEXT, "a frame: a sphere of 3,968 triangles");
    draw_bars(page, 592, 140, 220, frame_cost, 1, " million");
    draw_key(page, 110, 396);
    page->heart = (struct sheen_box){26, 104, 420, 418};
    for (int p = 0; p < 2; p++) {
        sheen_page_number(page, 36 + 490 * p, 466, SHEEN_INK_TEXT, "%s, a pixel: %.1f, %.1f, %.1f, %.1f", processors[p],
                          pixel_cost[p][0], pixel_cost[p][1], pixel_cost[p][2], pixel_cost[p][3]);
        sheen_page_number(page, 36 + 490 * p, 492, SHEEN_INK_TEXT, "%s, a frame: %.2f, %.2f, %.2f, %.2f", processors[p],
                          frame_cost[p][0], frame_cost[p][1], frame_cost[p][2], frame_cost[p][3]);
    }
    sheen_page_text(
        page, 36, 530, SHEEN_LEFT, SHEEN_INK_FLAT,
        "By tests/run bench: gcc -O2, depth test and 565 pixels included, 320x240, one light with highlight.");
    return SHEEN_OK;
}
