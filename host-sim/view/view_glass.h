/*
 * view_glass.h - how a glass looks to the eye: pixels with gaps between them, in the colours of its kind.
 */
#ifndef SHEEN_VIEW_GLASS_H
#define SHEEN_VIEW_GLASS_H

#include <stdint.h>

/* In the order of --theme. */
enum sheen_theme {
    SHEEN_THEME_AUTO, /* as the panel is: lcd or oled, for ideal plain */
    SHEEN_THEME_PLAIN,
    SHEEN_THEME_LCD,
    SHEEN_THEME_OLED,
    SHEEN_THEME_BLUE,
    SHEEN_THEME_YELLOW,
    SHEEN_THEME_GREEN,
    SHEEN_THEMES
};

struct sheen_glass_look {
    enum sheen_theme theme; /* not auto */
    unsigned scale;         /* px of the window per pixel of the panel, 1..16 */
    unsigned gap;           /* how many of these px are dark, right of and below each pixel; less than scale */
};

/* The theme's name in --theme. */
const char *sheen_theme_name(enum sheen_theme theme);

/* How a colour of 3 bytes looks on a glass of that theme: 0x00RRGGBB. */
uint32_t sheen_theme_colour(enum sheen_theme theme, const uint8_t rgb[3]);

/* What lies around the glass, also in the corners of a round one. */
#define SHEEN_BEZEL 0x1c1d20u

/*
 * Draws a picture of width x height pixels as width * scale x height * scale values 0x00RRGGBB, rows `stride` values
 * apart. has(panel, x, y) is 0 where the glass has no pixel.
 */
struct sheen_glass_picture {
    const uint8_t *rgb; /* 3 bytes per pixel */
    unsigned width, height;
    int (*has)(const void *panel, unsigned x, unsigned y);
    const void *panel;
};
void sheen_glass_draw(const struct sheen_glass_picture *picture, const struct sheen_glass_look *look, uint32_t *out,
                      unsigned stride);

#endif
