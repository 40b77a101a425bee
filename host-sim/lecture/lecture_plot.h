/*
 * lecture_plot.h - figures: text, axes, curves and pictures on a page. Private to lecture*.c.
 *
 * Lines and letters are cairo's: they are no part of what sheen is about, and letters of
 * our own would only be worse. A page is recorded, so that it can be drawn twice: as a
 * file of its own and, smaller, on the contact sheet.
 */
#ifndef SHEEN_LECTURE_PLOT_H
#define SHEEN_LECTURE_PLOT_H

#include <cairo.h>
#include <stdint.h>
#include <stdio.h>

#include "problem.h"

/* Size of a figure's page and of the contact sheet, px. */
#define SHEEN_PAGE_WIDTH 1000
#define SHEEN_PAGE_HEIGHT 650
#define SHEEN_SHEET_WIDTH 960
#define SHEEN_SHEET_CELL 320 /* wide; */
#define SHEEN_SHEET_ROW 318  /* and high */

/* Letters are this large at least, on a page and on the sheet, px. */
#define SHEEN_SMALLEST_TYPE 11
#define SHEEN_PAGE_TEXTS 160

/* What a page is drawn on: one of either kind for a figure that is wanted as PNG and as SVG. */
enum sheen_form {
    SHEEN_RECORD, /* replayed as PNG and on the sheet; of it cairo 1.16 would lose memory when writing SVG */
    SHEEN_SVG     /* drawn as it is written; its lines of figures are not printed once more */
};

/* px of the page, from the top left. */
struct sheen_box {
    double x0, y0, x1, y1;
};

struct sheen_page {
    const char *name; /* of the file, and before each line on standard output */
    enum sheen_form form;
    int width, height;
    const char *title, *claim;
    struct sheen_box heart; /* what of it the contact sheet shows; all 0: nothing */
    cairo_surface_t *surface;
    cairo_t *cr;
    FILE *svg; /* into svg_text */
    char *svg_text;
    size_t svg_count;
    const struct sheen_page *shown; /* on the sheet: the pages whose hearts it shows; they outlive it */
    int shown_count;
    /* What is written on it, for sheen_page_check: the letters' extents and size. */
    int texts;
    struct sheen_page_text {
        struct sheen_box box;
        double size;
        char start[32];
    } text[SHEEN_PAGE_TEXTS];
};

/* 0, or SHEEN_ERR_MEMORY. Close in either case. */
int sheen_page_open(struct sheen_page *page, const char *name, enum sheen_form form, int width, int height);
void sheen_page_close(struct sheen_page *page);
/*
 * 0, or SHEEN_ERR_ARGUMENT and *problem: a text leaves the page, touches another one, is cut by the heart's edge or is
 * too small to read, by itself or on the sheet.
 */
int sheen_page_check(const struct sheen_page *page, struct sheen_problem *problem);
/* 1 where the machine has a font to write with. */
int sheen_page_has_font(void);

/* ---- what a page is made of; all coordinates px from the top left ---- */

enum sheen_ink {
    SHEEN_INK_TEXT = 0,
    SHEEN_INK_FAINT, /* what is compared with */
    SHEEN_INK_FLAT,
    SHEEN_INK_GOURAUD,
    SHEEN_INK_PHONG,
    SHEEN_INK_SLERP,
    SHEEN_INK_WRONG,
    SHEEN_INK_PAPER /* as the page, on pictures */
};

enum sheen_align {
    SHEEN_LEFT,
    SHEEN_CENTRE,
    SHEEN_RIGHT
};

void sheen_page_ink(struct sheen_page *page, enum sheen_ink ink);
/* The lecture's claim that the page shows: both strings outlive the page. */
void sheen_page_title(struct sheen_page *page, const char *title, const char *claim);
/* What is seen, in plain words, at the foot; at most two lines. */
void sheen_page_caption(struct sheen_page *page, const char *caption);
void sheen_page_text(struct sheen_page *page, double x, double y, enum sheen_align align, enum sheen_ink ink,
                     const char *format, ...) __attribute__((format(printf, 6, 7)));
/* Bold where `bold`, of that size, in lines of at most `width` px, 1.3 sizes apart; returns the last line's y. */
double sheen_page_lines(struct sheen_page *page, double x, double y, double width, double size, int bold,
                        enum sheen_ink ink, const char *text);
/* A line of figures, on the page and, with the page's name before it, on standard output. */
void sheen_page_number(struct sheen_page *page, double x, double y, enum sheen_ink ink, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/*
 * width * height pixels, each `scale` px wide: of 3 bytes r, g, b, or of one intensity 0..1; one that is 0 was not
 * drawn, and the page shows through.
 */
void sheen_page_picture(struct sheen_page *page, double x, double y, double scale, const uint8_t *rgb, int width,
                        int height);
void sheen_page_intensity(struct sheen_page *page, double x, double y, double scale, const double *intensity, int width,
                          int height);

/* A plot's box on the page and what its edges mean. */
struct sheen_axes {
    double x, y, width, height; /* px */
    double x0, x1, y0, y1;
};

/* Box, grid every x_step and y_step, and labels with that many decimals; -1: without. */
void sheen_page_axes(struct sheen_page *page, const struct sheen_axes *axes, double x_step, int x_decimals,
                     double y_step, int y_decimals);
/* What the axes measure: below, and above on the left. Either may be NULL. */
void sheen_page_axis_names(struct sheen_page *page, const struct sheen_axes *axes, const char *below,
                           const char *above);
/* Clipped to the box; count points. */
void sheen_page_curve(struct sheen_page *page, const struct sheen_axes *axes, enum sheen_ink ink, double line_width,
                      const double *x, const double *y, int count);
void sheen_page_dot(struct sheen_page *page, const struct sheen_axes *axes, enum sheen_ink ink, double x, double y);
/* In px of the page. */
void sheen_page_line(struct sheen_page *page, enum sheen_ink ink, double line_width, double x0, double y0, double x1,
                     double y1);

/* ---- to files ---- */

/* A page of an SVG is complete then. */
int sheen_page_write(struct sheen_page *page, const char *path, struct sheen_problem *problem);
/* The contact sheet, on a page that this opens: what it is, then each page's title, claim and heart. */
int sheen_page_sheet(struct sheen_page *sheet, const struct sheen_page *pages, int count);
/* Those hearts, onto what the sheet itself was drawn on. */
void sheen_page_hearts(const struct sheen_page *sheet, cairo_t *cr);

#endif
