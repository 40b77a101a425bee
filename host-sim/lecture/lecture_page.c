/*
 * lecture_page.c - recorded pages to PNG files.
 */
#include <stdlib.h>

#include "lecture_plot.h"
#include "png_file.h"

/* Of a page on the contact sheet. */
#define SHEET_SCALE 0.5
#define SHEET_COLUMNS 2

int sheen_page_open(struct sheen_page *page, const char *name)
{
    static const cairo_rectangle_t extents = {0, 0, SHEEN_PAGE_WIDTH, SHEEN_PAGE_HEIGHT};

    page->name = name;
    page->record = cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &extents);
    page->cr = cairo_create(page->record);
    cairo_set_source_rgb(page->cr, 1, 1, 1);
    cairo_paint(page->cr);
    return cairo_status(page->cr) == CAIRO_STATUS_SUCCESS ? SHEEN_OK : SHEEN_ERR_MEMORY;
}

void sheen_page_close(struct sheen_page *page)
{
    cairo_destroy(page->cr);
    cairo_surface_destroy(page->record);
}

/* Rows of 32-bit pixels, 0x00rrggbb in the machine's order, to bytes r, g, b. */
static int write_surface(cairo_surface_t *surface, int width, int height, const char *path,
                         struct sheen_problem *problem)
{
    uint8_t *rgb = malloc((size_t)width * (size_t)height * 3), *out = rgb;
    int error = SHEEN_OK;

    if (!rgb)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: not enough memory", path);
    cairo_surface_flush(surface);
    for (int y = 0; y < height; y++) {
        const unsigned char *row =
            cairo_image_surface_get_data(surface) + (size_t)y * (size_t)cairo_image_surface_get_stride(surface);
        const uint32_t *pixel = (const uint32_t *)(const void *)row; /* cairo aligns its rows */
        for (int x = 0; x < width; x++) {
            *out++ = (uint8_t)(pixel[x] >> 16);
            *out++ = (uint8_t)(pixel[x] >> 8);
            *out++ = (uint8_t)pixel[x];
        }
    }
    error = sheen_png_write(path, rgb, (unsigned)width, (unsigned)height, problem);
    free(rgb);
    return error;
}

/* Pages side by side at a scale, `columns` a row. */
static int write_pages(const struct sheen_page *pages, int count, int columns, double scale, const char *path,
                       struct sheen_problem *problem)
{
    int width = (int)(SHEEN_PAGE_WIDTH * scale) * columns;
    int height = (int)(SHEEN_PAGE_HEIGHT * scale) * ((count + columns - 1) / columns);
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    cairo_t *cr = cairo_create(surface);
    int error;

    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    for (int i = 0; i < count; i++) {
        cairo_save(cr);
        cairo_translate(cr, i % columns * (SHEEN_PAGE_WIDTH * scale), i / columns * (SHEEN_PAGE_HEIGHT * scale));
        cairo_scale(cr, scale, scale);
        cairo_set_source_surface(cr, pages[i].record, 0, 0);
        cairo_rectangle(cr, 0, 0, SHEEN_PAGE_WIDTH, SHEEN_PAGE_HEIGHT);
        cairo_fill(cr);
        cairo_restore(cr);
    }
    if (cairo_status(cr) != CAIRO_STATUS_SUCCESS)
        error = sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: %s", path, cairo_status_to_string(cairo_status(cr)));
    else
        error = write_surface(surface, width, height, path, problem);
    cairo_destroy(cr);
    cairo_surface_destroy(surface);
    return error;
}

int sheen_page_write(const struct sheen_page *page, const char *path, struct sheen_problem *problem)
{
    cairo_status_t status = cairo_status(page->cr);

    if (status != CAIRO_STATUS_SUCCESS)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: %s", path, cairo_status_to_string(status));
    return write_pages(page, 1, 1, 1, path, problem);
}

int sheen_page_write_sheet(const struct sheen_page *pages, int count, const char *path, struct sheen_problem *problem)
{
    return write_pages(pages, count, SHEET_COLUMNS, SHEET_SCALE, path, problem);
}
