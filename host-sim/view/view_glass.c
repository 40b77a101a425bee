/*
 * view_glass.c - how a glass looks to the eye.
 *
 * A theme is the colour of a pixel that is off and of one that is fully on; between them each channel is linear in its
 * byte. A dark LCD pixel lets some backlight through; a dark OLED pixel is black, and a grey OLED has a single colour.
 */
#include "view_glass.h"

struct theme {
    const char *name;
    uint32_t off, on, gap; /* 0x00RRGGBB */
};

static const struct theme themes[SHEEN_THEMES] = {
    [SHEEN_THEME_AUTO] = {"auto", 0, 0, 0},
    [SHEEN_THEME_PLAIN] = {"plain", 0x000000, 0xffffff, 0x000000},
    [SHEEN_THEME_LCD] = {"lcd", 0x0c0e12, 0xf6faff, 0x060708},
    [SHEEN_THEME_OLED] = {"oled", 0x000000, 0xf4fbff, 0x000000},
    [SHEEN_THEME_BLUE] = {"blue", 0x000000, 0x4ab8ff, 0x000000},
    [SHEEN_THEME_YELLOW] = {"yellow", 0x000000, 0xffd53a, 0x000000},
    [SHEEN_THEME_GREEN] = {"green", 0x000000, 0x5cff70, 0x000000},
};

const char *sheen_theme_name(enum sheen_theme theme)
{
    return themes[theme].name;
}

uint32_t sheen_theme_colour(enum sheen_theme theme, const uint8_t rgb[3])
{
    uint32_t colour = 0;

    for (int k = 0; k < 3; k++) {
        uint32_t off = themes[theme].off >> (16 - 8 * k) & 255, on = themes[theme].on >> (16 - 8 * k) & 255;
        colour = colour << 8 | (off * (255u - rgb[k]) + on * rgb[k] + 127) / 255;
    }
    return colour;
}

/* Draws one pixel of the panel: a lit square, with the gap on its right and below. */
static void draw_pixel(uint32_t *out, unsigned stride, const struct sheen_glass_look *look, uint32_t lit, uint32_t gap)
{
    unsigned side = look->scale - look->gap;

    for (unsigned y = 0; y < look->scale; y++) {
        for (unsigned x = 0; x < look->scale; x++)
            out[(unsigned long)y * stride + x] = x < side && y < side ? lit : gap;
    }
}

void sheen_glass_draw(const struct sheen_glass_picture *picture, const struct sheen_glass_look *look, uint32_t *out,
                      unsigned stride)
{
    uint32_t gap = themes[look->theme].gap;
    const uint8_t *rgb = picture->rgb;

    for (unsigned y = 0; y < picture->height; y++) {
        uint32_t *row = out + (unsigned long)y * look->scale * stride;
        for (unsigned x = 0; x < picture->width; x++, rgb += 3) {
            if (picture->has(picture->panel, x, y))
                draw_pixel(row + x * look->scale, stride, look, sheen_theme_colour(look->theme, rgb), gap);
            else
                draw_pixel(row + x * look->scale, stride, look, SHEEN_BEZEL, SHEEN_BEZEL);
        }
    }
}
