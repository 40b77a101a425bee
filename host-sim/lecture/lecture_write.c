/*
 * lecture_write.c - pages to PNG and SVG files.
 */
#include <stdlib.h>

#include "lecture_plot.h"
#include "out_file.h"
#include "png_file.h"

/* Writes an image of 32-bit pixels, 0x00rrggbb in the machine's byte order, as PNG. */
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

static cairo_status_t draw_record(const struct sheen_page *page, cairo_surface_t *surface)
{
    cairo_t *cr = cairo_create(surface);

    cairo_set_source_surface(cr, page->surface, 0, 0);
    cairo_paint(cr);
    sheen_page_hearts(page, cr);
    cairo_status_t status = cairo_status(cr);
    cairo_destroy(cr);
    return status;
}

static int write_png(const struct sheen_page *page, const char *path, struct sheen_problem *problem)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, page->width, page->height);
    cairo_status_t status = draw_record(page, surface);
    int error = status != CAIRO_STATUS_SUCCESS
                    ? sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: %s", path, cairo_status_to_string(status))
                    : write_surface(surface, page->width, page->height, path, problem);

    cairo_surface_destroy(surface);
    return error;
}

static int write_svg(struct sheen_page *page, const char *path, struct sheen_problem *problem)
{
    cairo_surface_finish(page->surface);
    cairo_status_t status = cairo_surface_status(page->surface);
    if (status == CAIRO_STATUS_SUCCESS && fflush(page->svg) != 0)
        status = CAIRO_STATUS_NO_MEMORY;
    if (status != CAIRO_STATUS_SUCCESS)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: %s", path, cairo_status_to_string(status));
    return sheen_out_file(path, page->svg_text, page->svg_count, problem);
}

int sheen_page_write(struct sheen_page *page, const char *path, struct sheen_problem *problem)
{
    cairo_status_t status = cairo_status(page->cr);

    if (status != CAIRO_STATUS_SUCCESS)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: %s", path, cairo_status_to_string(status));
    return page->form == SHEEN_SVG ? write_svg(page, path, problem) : write_png(page, path, problem);
}
