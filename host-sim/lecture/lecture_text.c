/*
 * lecture_text.c - text and pictures on a page.
 */
#include "lecture_plot.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#define TITLE_SIZE 27 /* px */
#define CLAIM_SIZE 16
#define TEXT_SIZE 16
#define MARGIN 36

/* Told apart also by those who see no red or no green (Okabe and Ito's palette). */
void sheen_page_ink(struct sheen_page *page, enum sheen_ink ink)
{
    static const uint32_t rgb[] = {
        [SHEEN_INK_TEXT] = 0x26262b,    [SHEEN_INK_FAINT] = 0xa8a8b0, [SHEEN_INK_FLAT] = 0x6e6e78,
        [SHEEN_INK_GOURAUD] = 0xcc8800, [SHEEN_INK_PHONG] = 0x0072b2, [SHEEN_INK_SLERP] = 0x009e73,
        [SHEEN_INK_WRONG] = 0xc2185b};

    cairo_set_source_rgb(page->cr, (rgb[ink] >> 16) / 255.0, (rgb[ink] >> 8 & 255) / 255.0, (rgb[ink] & 255) / 255.0);
}

/* ---- text ---- */

static void write_text(cairo_t *cr, double x, double y, enum sheen_align align, const char *text)
{
    cairo_text_extents_t extents;

    cairo_text_extents(cr, text, &extents);
    if (align != SHEEN_LEFT)
        x -= extents.x_advance / (align == SHEEN_CENTRE ? 2 : 1);
    cairo_move_to(cr, x, y);
    cairo_show_text(cr, text);
}

/* Whatever font the machine calls sans-serif: figures are not compared bit by bit. */
static void set_font(cairo_t *cr, double size, cairo_font_weight_t weight)
{
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, weight);
    cairo_set_font_size(cr, size);
}

int sheen_page_has_font(void)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    cairo_t *cr = cairo_create(surface);
    cairo_text_extents_t extents;

    set_font(cr, TEXT_SIZE, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_text_extents(cr, "M", &extents);
    int has_font = cairo_status(cr) == CAIRO_STATUS_SUCCESS && extents.width > 0;
    cairo_destroy(cr);
    cairo_surface_destroy(surface);
    return has_font;
}

void sheen_page_title(struct sheen_page *page, const char *title, const char *claim)
{
    sheen_page_ink(page, SHEEN_INK_TEXT);
    set_font(page->cr, TITLE_SIZE, CAIRO_FONT_WEIGHT_BOLD);
    write_text(page->cr, MARGIN, 48, SHEEN_LEFT, title);
    sheen_page_ink(page, SHEEN_INK_FLAT);
    set_font(page->cr, CLAIM_SIZE, CAIRO_FONT_WEIGHT_NORMAL);
    write_text(page->cr, MARGIN, 76, SHEEN_LEFT, claim);
    set_font(page->cr, TEXT_SIZE, CAIRO_FONT_WEIGHT_NORMAL);
}

void sheen_page_text(struct sheen_page *page, double x, double y, enum sheen_align align, enum sheen_ink ink,
                     const char *format, ...)
{
    char text[256];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    sheen_page_ink(page, ink);
    write_text(page->cr, x, y, align, text);
}

void sheen_page_number(struct sheen_page *page, double x, double y, enum sheen_ink ink, const char *format, ...)
{
    char text[256];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    sheen_page_ink(page, ink);
    write_text(page->cr, x, y, SHEEN_LEFT, text);
    printf("%s: %s\n", page->name, text);
}

/* ---- pictures ---- */

/* Pixels of 32 bits, 0x00rrggbb in the machine's order, from bytes or, where rgb is NULL, from intensities. */
static cairo_surface_t *image_of(const uint8_t *rgb, const double *intensity, int width, int height)
{
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    unsigned char *data = cairo_image_surface_get_data(image); /* NULL where memory is short: drawing then fails */
    size_t stride = (size_t)cairo_image_surface_get_stride(image);

    for (int i = 0; data && i < width * height; i++) {
        uint32_t *row = (uint32_t *)(void *)(data + (size_t)(i / width) * stride);
        if (rgb)
            row[i % width] = (uint32_t)rgb[3 * i] << 16 | (uint32_t)rgb[3 * i + 1] << 8 | rgb[3 * i + 2];
        else
            row[i % width] = 0x010101u * (uint32_t)lround(255 * fmin(fmax(intensity[i], 0), 1));
    }
    cairo_surface_mark_dirty(image);
    return image;
}

static void put_image(cairo_t *cr, double x, double y, double scale, cairo_surface_t *image)
{
    cairo_save(cr);
    cairo_translate(cr, x, y);
    cairo_scale(cr, scale, scale);
    cairo_set_source_surface(cr, image, 0, 0);
    cairo_rectangle(cr, 0, 0, cairo_image_surface_get_width(image), cairo_image_surface_get_height(image));
    cairo_fill(cr);
    cairo_restore(cr);
    cairo_surface_destroy(image); /* the record keeps it */
}

void sheen_page_picture(struct sheen_page *page, double x, double y, double scale, const uint8_t *rgb, int width,
                        int height)
{
    put_image(page->cr, x, y, scale, image_of(rgb, NULL, width, height));
}

void sheen_page_intensity(struct sheen_page *page, double x, double y, double scale, const double *intensity, int width,
                          int height)
{
    put_image(page->cr, x, y, scale, image_of(NULL, intensity, width, height));
}
