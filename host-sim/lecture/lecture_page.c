/*
 * lecture_page.c - opens, closes and checks pages, and draws the contact sheet.
 */
#include <cairo-svg.h>
#include <math.h>
#include <stdlib.h>

#include "lecture_plot.h"

#define HEART_WIDTH 300.0 /* largest size of a heart on the sheet, px */
#define HEART_HEIGHT 218.0
#define HEART_TOP 82 /* below a cell's top */
#define COLUMNS (SHEEN_SHEET_WIDTH / SHEEN_SHEET_CELL)

static cairo_status_t append(void *stream, const unsigned char *data, unsigned count)
{
    return fwrite(data, 1, count, stream) == count ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_NO_MEMORY;
}

int sheen_page_open(struct sheen_page *page, const char *name, enum sheen_form form, int width, int height)
{
    const cairo_rectangle_t extents = {0, 0, width, height};

    *page = (struct sheen_page){.name = name, .form = form, .width = width, .height = height};
    if (form == SHEEN_SVG) {
        page->svg = open_memstream(&page->svg_text, &page->svg_count);
        if (!page->svg)
            return SHEEN_ERR_MEMORY;
        page->surface = cairo_svg_surface_create_for_stream(append, page->svg, width, height);
        cairo_svg_surface_set_document_unit(page->surface, CAIRO_SVG_UNIT_PX);
    } else {
        page->surface = cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &extents);
    }
    page->cr = cairo_create(page->surface);
    cairo_set_source_rgb(page->cr, 1, 1, 1);
    cairo_paint(page->cr);
    return cairo_status(page->cr) == CAIRO_STATUS_SUCCESS ? SHEEN_OK : SHEEN_ERR_MEMORY;
}

void sheen_page_close(struct sheen_page *page)
{
    cairo_destroy(page->cr);
    cairo_surface_destroy(page->surface);
    if (page->svg)
        fclose(page->svg);
    free(page->svg_text);
}

/* ---- what can be read ---- */

static int overlap(const struct sheen_box *a, const struct sheen_box *b)
{
    return a->x0 < b->x1 && b->x0 < a->x1 && a->y0 < b->y1 && b->y0 < a->y1;
}

static int within(const struct sheen_box *a, const struct sheen_box *b)
{
    return a->x0 >= b->x0 && a->x1 <= b->x1 && a->y0 >= b->y0 && a->y1 <= b->y1;
}

/* The scale at which the sheet shows a page; 0 if it shows nothing of it. */
static double heart_scale(const struct sheen_box *heart)
{
    if (heart->x1 <= heart->x0 || heart->y1 <= heart->y0)
        return 0;
    return fmin(1, fmin(HEART_WIDTH / (heart->x1 - heart->x0), HEART_HEIGHT / (heart->y1 - heart->y0)));
}

static int refuse(struct sheen_problem *problem, const struct sheen_page *page, const char *text, const char *why)
{
    return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: the text '%s' %s", page->name, text, why);
}

/* Where the sheet shows page i's heart. The sheet's first cell is the key's. */
static struct sheen_box shown_box(int i, const struct sheen_box *heart)
{
    double scale = heart_scale(heart), width = (heart->x1 - heart->x0) * scale;
    double x = (i + 1) % COLUMNS * SHEEN_SHEET_CELL + (SHEEN_SHEET_CELL - width) / 2;
    double y = (i + 1) / COLUMNS * SHEEN_SHEET_ROW + HEART_TOP;

    return (struct sheen_box){x, y, x + width, y + (heart->y1 - heart->y0) * scale};
}

static int check_text(const struct sheen_page *page, const struct sheen_page_text *t, struct sheen_problem *problem)
{
    const struct sheen_box whole = {0, 0, page->width, page->height};

    if (!within(&t->box, &whole))
        return refuse(problem, page, t->start, "leaves the page");
    if (t->size < SHEEN_SMALLEST_TYPE)
        return refuse(problem, page, t->start, "is too small");
    for (const struct sheen_page_text *other = page->text; other < t; other++)
        if (overlap(&t->box, &other->box))
            return refuse(problem, page, t->start, "touches another one");
    for (int i = 0; i < page->shown_count; i++) {
        struct sheen_box box = shown_box(i, &page->shown[i].heart);
        if (overlap(&t->box, &box))
            return refuse(problem, page, t->start, "runs into a figure");
    }
    if (!overlap(&t->box, &page->heart))
        return SHEEN_OK;
    if (!within(&t->box, &page->heart))
        return refuse(problem, page, t->start, "is cut on the contact sheet");
    if (t->size * heart_scale(&page->heart) < SHEEN_SMALLEST_TYPE)
        return refuse(problem, page, t->start, "is too small on the contact sheet");
    return SHEEN_OK;
}

int sheen_page_check(const struct sheen_page *page, struct sheen_problem *problem)
{
    int error = SHEEN_OK;

    if (page->texts >= SHEEN_PAGE_TEXTS)
        return sheen_problem(problem, SHEEN_ERR_CAPACITY, "%s: more than %d texts", page->name, SHEEN_PAGE_TEXTS - 1);
    for (int i = 0; !error && i < page->texts; i++)
        error = check_text(page, &page->text[i], problem);
    return error;
}

/* ---- the contact sheet ---- */

void sheen_page_hearts(const struct sheen_page *sheet, cairo_t *cr)
{
    for (int i = 0; i < sheet->shown_count; i++) {
        const struct sheen_box *h = &sheet->shown[i].heart;
        struct sheen_box box = shown_box(i, h);
        cairo_save(cr);
        cairo_translate(cr, box.x0, box.y0);
        cairo_scale(cr, heart_scale(h), heart_scale(h));
        cairo_rectangle(cr, 0, 0, h->x1 - h->x0, h->y1 - h->y0);
        cairo_clip(cr);
        cairo_set_source_surface(cr, sheet->shown[i].surface, -h->x0, -h->y0);
        cairo_paint(cr);
        cairo_restore(cr);
    }
}

static void draw_key(struct sheen_page *sheet)
{
    static const struct {
        enum sheen_ink ink;
        const char *text;
    } keys[] = {{SHEEN_INK_FAINT, "the exact value"},         {SHEEN_INK_FLAT, "flat shading"},
                {SHEEN_INK_GOURAUD, "Gouraud shading"},       {SHEEN_INK_PHONG, "Phong shading"},
                {SHEEN_INK_SLERP, "slerp, along great arcs"}, {SHEEN_INK_WRONG, "what goes wrong"}};

    sheen_page_lines(sheet, 16, 36, SHEEN_SHEET_CELL - 32, 20, 1, SHEEN_INK_TEXT, "The lecture in figures");
    sheen_page_lines(sheet, 16, 62, SHEEN_SHEET_CELL - 32, 13, 0, SHEEN_INK_FLAT,
                     "Each claim of Goldman's \"Shading Algorithms\" against what the core's integers draw:");
    for (unsigned i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        double y = 128 + 25 * i;
        sheen_page_line(sheet, keys[i].ink, keys[i].ink == SHEEN_INK_FAINT ? 5 : 3, 18, y - 5, 48, y - 5);
        sheen_page_lines(sheet, 60, y, SHEEN_SHEET_CELL - 76, 14, 0, SHEEN_INK_TEXT, keys[i].text);
    }
}

int sheen_page_sheet(struct sheen_page *sheet, const struct sheen_page *pages, int count)
{
    int rows = (count + COLUMNS) / COLUMNS;
    int error = sheen_page_open(sheet, "contact-sheet", SHEEN_RECORD, SHEEN_SHEET_WIDTH, rows * SHEEN_SHEET_ROW);

    if (error)
        return error;
    sheet->shown = pages;
    sheet->shown_count = count;
    draw_key(sheet);
    for (int i = 0; i < count; i++) {
        double x = 16 + (i + 1) % COLUMNS * SHEEN_SHEET_CELL, y = (i + 1) / COLUMNS * SHEEN_SHEET_ROW;
        sheen_page_lines(sheet, x, y + 30, SHEEN_SHEET_CELL - 24, 16, 1, SHEEN_INK_TEXT, pages[i].title);
        sheen_page_lines(sheet, x, y + 50, SHEEN_SHEET_CELL - 24, 12.5, 0, SHEEN_INK_FLAT, pages[i].claim);
    }
    return cairo_status(sheet->cr) == CAIRO_STATUS_SUCCESS ? SHEEN_OK : SHEEN_ERR_MEMORY;
}
