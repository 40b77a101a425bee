/*
 * lecture_plot.h - figures: text, axes, curves and pictures on a page. Private to lecture*.c.
 *
 * cairo draws lines and letters, because they are not what sheen is about and letters of
 * our own would only be worse. A page is recorded so that it can be drawn twice: as a
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
#define SHEEN_SHEET_CELL 320 /* width of a cell of the sheet */
#define SHEEN_SHEET_ROW 318  /* height of a cell */

/* The smallest letters allowed, on a page and on the sheet, px. */
#define SHEEN_SMALLEST_TYPE 11
#define SHEEN_PAGE_TEXTS 160

/* What a page is drawn on. A figure that is wanted as PNG and as SVG is drawn on two pages, one of each form. */
enum sheen_form {
    SHEEN_RECORD, /* replayed as PNG and on the sheet; cairo 1.16 would leak memory if it wrote a record as SVG */
    SHEEN_SVG     /* written while it is drawn; does not print its lines of numbers, which the record printed */
};

/* A rectangle on the page, px from the top left. */
struct sheen_box {
    double x0, y0, x1, y1;
};

struct sheen_page {
    const char *name; /* the file's name, also printed before each line on standard output */
    enum sheen_form form;
    int width, height;
    const char *title, *claim;
    struct sheen_box heart; /* the part of the page that the contact sheet shows; all 0: none */
    cairo_surface_t *surface;
    cairo_t *cr;
    FILE *svg; /* writes to svg_text */
    char *svg_text;
    size_t svg_count;
    const struct sheen_page *shown; /* only on the sheet: the pages whose hearts it shows, which MUST outlive it */
    int shown_count;
    /* The texts on the page, for sheen_page_check(): extents and letter size. */
    int texts;
    struct sheen_page_text {
        struct sheen_box box;
        double size;
        char start[32];
    } text[SHEEN_PAGE_TEXTS];
};

/* Returns 0 or SHEEN_ERR_MEMORY. Call sheen_page_close() in either case. */
int sheen_page_open(struct sheen_page *page, const char *name, enum sheen_form form, int width, int height);
void sheen_page_close(struct sheen_page *page);
/*
 * Returns 0 if all texts can be read. Otherwise *problem says why not: SHEEN_ERR_ARGUMENT if a text leaves the page,
 * touches another text or a figure on the sheet, is cut by the heart's edge or is too small to read, on the page or on
 * the sheet; SHEEN_ERR_CAPACITY if there are too many texts to check.
 */
int sheen_page_check(const struct sheen_page *page, struct sheen_problem *problem);
/* 1 if the machine has a font to write with. */
int sheen_page_has_font(void);

/* ---- what a page is made of; coordinates are px from the top left, unless axes are given ---- */

enum sheen_ink {
    SHEEN_INK_TEXT = 0,
    SHEEN_INK_FAINT, /* the reference that a curve is compared with */
    SHEEN_INK_FLAT,
    SHEEN_INK_GOURAUD,
    SHEEN_INK_PHONG,
    SHEEN_INK_SLERP,
    SHEEN_INK_WRONG,
    SHEEN_INK_PAPER /* the page's own colour, for lines and text on pictures */
};

enum sheen_align {
    SHEEN_LEFT,
    SHEEN_CENTRE,
    SHEEN_RIGHT
};

void sheen_page_ink(struct sheen_page *page, enum sheen_ink ink);
/* claim: the lecture's claim that the page shows. Both strings MUST outlive the page. */
void sheen_page_title(struct sheen_page *page, const char *title, const char *claim);
/* At the foot of the page, what there is to see on it, in plain words; at most two lines. */
void sheen_page_caption(struct sheen_page *page, const char *caption);
void sheen_page_text(struct sheen_page *page, double x, double y, enum sheen_align align, enum sheen_ink ink,
                     const char *format, ...) __attribute__((format(printf, 6, 7)));
/* Breaks the text into lines of at most `width` px, 1.3 * size apart; returns the last line's y. */
double sheen_page_lines(struct sheen_page *page, double x, double y, double width, double size, int bold,
                        enum sheen_ink ink, const char *text);
/* A line of numbers, on the page and, with the page's name before it, on standard output. */
void sheen_page_number(struct sheen_page *page, double x, double y, enum sheen_ink ink, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/*
 * width * height pixels, each `scale` px wide: either 3 bytes r, g, b per pixel or one intensity 0..1. An intensity of
 * 0 means that the pixel was not drawn: it gets the page's white.
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

/* The box, a grid every x_step and y_step, and labels with x_decimals and y_decimals decimals; -1: no labels. */
void sheen_page_axes(struct sheen_page *page, const struct sheen_axes *axes, double x_step, int x_decimals,
                     double y_step, int y_decimals);
/* What the axes measure: the x axis' name below the box, the y axis' name above it on the left. Either may be NULL. */
void sheen_page_axis_names(struct sheen_page *page, const struct sheen_axes *axes, const char *below,
                           const char *above);
/* A curve through `count` points, clipped to the box. */
void sheen_page_curve(struct sheen_page *page, const struct sheen_axes *axes, enum sheen_ink ink, double line_width,
                      const double *x, const double *y, int count);
void sheen_page_dot(struct sheen_page *page, const struct sheen_axes *axes, enum sheen_ink ink, double x, double y);
/* Unlike a curve's, the ends are px of the page. */
void sheen_page_line(struct sheen_page *page, enum sheen_ink ink, double line_width, double x0, double y0, double x1,
                     double y1);

/* ---- to files ---- */

/* Writes a PNG or an SVG file, according to the page's form. Nothing more can be drawn on an SVG page after that. */
int sheen_page_write(struct sheen_page *page, const char *path, struct sheen_problem *problem);
/* Opens *sheet and draws the contact sheet on it: a key to the colours, then each page's title, claim and heart. */
int sheen_page_sheet(struct sheen_page *sheet, const struct sheen_page *pages, int count);
/* Draws the hearts of the sheet's pages to cr; does nothing for any other page. */
void sheen_page_hearts(const struct sheen_page *sheet, cairo_t *cr);

#endif
