/*
 * lecture_write.c - recorded pages to PNG and SVG files.
 */
#include <stdlib.h>
#include <string.h>

#include <cairo-svg.h>

#include "lecture_plot.h"
#include "out_file.h"
#include "png_file.h"

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

static cairo_status_t draw_record(const struct sheen_page *page, cairo_surface_t *surface)
{
    cairo_t *cr = cairo_create(surface);

    cairo_set_source_surface(cr, page->record, 0, 0);
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

/* What cairo has written, in memory that grows. */
struct bytes {
    unsigned char *data;
    size_t count, room;
};

static cairo_status_t append(void *closure, const unsigned char *data, unsigned count)
{
    struct bytes *to = closure;

    if (to->count + count > to->room) {
        size_t room = 2 * (to->count + count);
        unsigned char *more = realloc(to->data, room);
        if (!more)
            return CAIRO_STATUS_NO_MEMORY;
        to->data = more;
        to->room = room;
    }
    memcpy(to->data + to->count, data, count);
    to->count += count;
    return CAIRO_STATUS_SUCCESS;
}

static int write_svg(const struct sheen_page *page, const char *path, struct sheen_problem *problem)
{
    struct bytes bytes = {NULL, 0, 0};
    cairo_surface_t *surface = cairo_svg_surface_create_for_stream(append, &bytes, page->width, page->height);

    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
    cairo_status_t status = draw_record(page, surface);
    cairo_surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    int error = status != CAIRO_STATUS_SUCCESS
                    ? sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: %s", path, cairo_status_to_string(status))
                    : sheen_out_file(path, bytes.data, bytes.count, problem);
    free(bytes.data);
    return error;
}

int sheen_page_write(const struct sheen_page *page, const char *path, struct sheen_problem *problem)
{
    cairo_status_t status = cairo_status(page->cr);
    size_t length = strlen(path);

    if (status != CAIRO_STATUS_SUCCESS)
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: %s", path, cairo_status_to_string(status));
    if (length > 4 && strcmp(path + length - 4, ".svg") == 0)
        return write_svg(page, path, problem);
    return write_png(page, path, problem);
}
