/*
 * lecture_text.c - text and pictures on a page.
 */
#include "lecture_plot.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define TITLE_SIZE 27 /* px */
#define TEXT_SIZE 16
#define MARGIN 36

/* Readers who cannot see red or green can tell these colours apart too (Okabe and Ito's palette). */
void sheen_page_ink(struct sheen_page *page, enum sheen_ink ink)
{
    static const uint32_t rgb[] = {
        [SHEEN_INK_TEXT] = 0x26262b,    [SHEEN_INK_FAINT] = 0xa8a8b0, [SHEEN_INK_FLAT] = 0x6e6e78,
        [SHEEN_INK_GOURAUD] = 0xcc8800, [SHEEN_INK_PHONG] = 0x0072b2, [SHEEN_INK_SLERP] = 0x009e73,
        [SHEEN_INK_WRONG] = 0xc2185b,   [SHEEN_INK_PAPER] = 0xffffff};

    cairo_set_source_rgb(page->cr, (rgb[ink] >> 16) / 255.0, (rgb[ink] >> 8 & 255) / 255.0, (rgb[ink] & 255) / 255.0);
}

/* ---- text ---- */

static void note_text(struct sheen_page *page, const cairo_text_extents_t *e, double x, double y, double size,
                      const char *text)
{
    if (page->texts >= SHEEN_PAGE_TEXTS) /* sheen_page_check refuses it */
        return;
    struct sheen_page_text *t = &page->text[page->texts++];
    x += e->x_bearing;
    y += e->y_bearing;
    t->box = (struct sheen_box){x, y, x + e->width, y + e->height};
    t->size = size;
    snprintf(t->start, sizeof t->start, "%s", text);
}

/* Writes letters as outlines, so that an SVG looks the same on every machine. */
static void write_text(struct sheen_page *page, double x, double y, enum sheen_align align, const char *text)
{
    cairo_text_extents_t extents;
    cairo_matrix_t font;

    cairo_get_font_matrix(page->cr, &font);
    cairo_text_extents(page->cr, text, &extents);
    if (align != SHEEN_LEFT)
        x -= extents.x_advance / (align == SHEEN_CENTRE ? 2 : 1);
    note_text(page, &extents, x, y, font.yy, text);
    cairo_move_to(page->cr, x, y);
    cairo_text_path(page->cr, text);
    cairo_fill(page->cr);
}

/* Any font that the machine calls sans-serif will suffice, because figures are not compared bit by bit. */
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

/* How many bytes of the text fit into `width`, up to a space or the end; at least one word. */
static size_t fitting(cairo_t *cr, const char *text, double width)
{
    char line[256];
    size_t fits = 0, length = 0;

    do {
        length += strcspn(text + length + (length > 0), " ") + (length > 0);
        cairo_text_extents_t extents;
        snprintf(line, sizeof line, "%.*s", (int)length, text);
        cairo_text_extents(cr, line, &extents);
        if (fits > 0 && extents.x_advance > width)
            break;
        fits = length;
    } while (text[length] != '\0');
    return fits;
}

double sheen_page_lines(struct sheen_page *page, double x, double y, double width, double size, int bold,
                        enum sheen_ink ink, const char *text)
{
    sheen_page_ink(page, ink);
    set_font(page->cr, size, bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    for (;;) {
        char line[256];
        size_t length = fitting(page->cr, text, width);
        snprintf(line, sizeof line, "%.*s", (int)length, text);
        write_text(page, x, y, SHEEN_LEFT, line);
        text += length;
        if (*text == '\0')
            break;
        text++; /* the space */
        y += 1.3 * size;
    }
    set_font(page->cr, TEXT_SIZE, CAIRO_FONT_WEIGHT_NORMAL);
    return y;
}

void sheen_page_title(struct sheen_page *page, const char *title, const char *claim)
{
    page->title = title;
    page->claim = claim;
    sheen_page_lines(page, MARGIN, 48, page->width - 2 * MARGIN, TITLE_SIZE, 1, SHEEN_INK_TEXT, title);
    sheen_page_lines(page, MARGIN, 76, page->width - 2 * MARGIN, TEXT_SIZE, 0, SHEEN_INK_FLAT, claim);
}

void sheen_page_caption(struct sheen_page *page, const char *caption)
{
    sheen_page_line(page, SHEEN_INK_FAINT, 0.6, MARGIN, page->height - 62, page->width - MARGIN, page->height - 62);
    sheen_page_lines(page, MARGIN, page->height - 39, page->width - 2 * MARGIN, TEXT_SIZE, 0, SHEEN_INK_TEXT, caption);
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
    write_text(page, x, y, align, text);
}

void sheen_page_number(struct sheen_page *page, double x, double y, enum sheen_ink ink, const char *format, ...)
{
    char text[256];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    sheen_page_ink(page, ink);
    write_text(page, x, y, SHEEN_LEFT, text);
    if (page->form != SHEEN_SVG)
        printf("%s: %s\n", page->name, text);
}

/* ---- pictures ---- */

/* An image of 32-bit pixels, 0x00rrggbb in the machine's byte order, from rgb or, if that is NULL, from intensity. */
static cairo_surface_t *image_of(const uint8_t *rgb, const double *intensity, int width, int height)
{
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    unsigned char *data = cairo_image_surface_get_data(image); /* NULL if memory is short: drawing then fails */
    size_t stride = (size_t)cairo_image_surface_get_stride(image);

    for (int i = 0; data && i < width * height; i++) {
        uint32_t *row = (uint32_t *)(void *)(data + (size_t)(i / width) * stride);
        if (rgb)
            row[i % width] = (uint32_t)rgb[3 * i] << 16 | (uint32_t)rgb[3 * i + 1] << 8 | rgb[3 * i + 2];
        else
            row[i % width] = intensity[i] > 0 ? 0x010101u * (uint32_t)lround(255 * fmin(intensity[i], 1)) : 0xffffff;
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
