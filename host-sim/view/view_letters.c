/*
 * view_letters.c - letters drawn with cairo.
 */
#include "view_letters.h"

#include <cairo.h>
#include <fontconfig/fontconfig.h>

#define TEXT_SIZE 13 /* px */

void sheen_letters(const struct sheen_letters *letters, int x, int y, int grey, const char *line)
{
    cairo_surface_t *surface = cairo_image_surface_create_for_data(letters->pixels, CAIRO_FORMAT_RGB24, letters->width,
                                                                   letters->height, letters->pitch);
    cairo_t *cr = cairo_create(surface);

    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, TEXT_SIZE);
    cairo_set_source_rgb(cr, grey / 255.0, grey / 255.0, grey / 255.0);
    cairo_move_to(cr, x, y);
    cairo_show_text(cr, line);
    cairo_destroy(cr);
    cairo_surface_destroy(surface);
}

void sheen_letters_end(void)
{
    cairo_debug_reset_static_data(); /* what cairo and fontconfig keep of the font would be reported as leaked */
    FcFini();
}
