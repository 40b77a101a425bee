/*
 * text.c - glyphs of 5x7 pixels over a rectangle of a picture.
 */
#include "text.h"

#define GLYPH_W 5
#define GLYPH_H 7
#define CELL_W 6

/* A glyph is seven rows from the top, 5 bits each, the leftmost pixel highest. */
#define GLYPH(a, b, c, d, e, f, g)                                                                                     \
    {                                                                                                                  \
        0x##a, 0x##b, 0x##c, 0x##d, 0x##e, 0x##f, 0x##g                                                                \
    }

static const uint8_t digits[10][GLYPH_H] = {GLYPH(0E, 11, 13, 15, 19, 11, 0E), GLYPH(04, 0C, 04, 04, 04, 04, 0E),
                                            GLYPH(0E, 11, 01, 02, 04, 08, 1F), GLYPH(1F, 02, 04, 02, 01, 11, 0E),
                                            GLYPH(02, 06, 0A, 12, 1F, 02, 02), GLYPH(1F, 10, 1E, 01, 01, 11, 0E),
                                            GLYPH(06, 08, 10, 1E, 11, 11, 0E), GLYPH(1F, 01, 02, 04, 08, 08, 08),
                                            GLYPH(0E, 11, 11, 0E, 11, 11, 0E), GLYPH(0E, 11, 11, 0F, 01, 02, 0C)};

static const uint8_t letters[26][GLYPH_H] = {
    GLYPH(0E, 11, 11, 1F, 11, 11, 11), GLYPH(1E, 11, 11, 1E, 11, 11, 1E), GLYPH(0E, 11, 10, 10, 10, 11, 0E),
    GLYPH(1C, 12, 11, 11, 11, 12, 1C), GLYPH(1F, 10, 10, 1E, 10, 10, 1F), GLYPH(1F, 10, 10, 1E, 10, 10, 10),
    GLYPH(0E, 11, 10, 17, 11, 11, 0F), GLYPH(11, 11, 11, 1F, 11, 11, 11), GLYPH(0E, 04, 04, 04, 04, 04, 0E),
    GLYPH(07, 02, 02, 02, 02, 12, 0C), GLYPH(11, 12, 14, 18, 14, 12, 11), GLYPH(10, 10, 10, 10, 10, 10, 1F),
    GLYPH(11, 1B, 15, 15, 11, 11, 11), GLYPH(11, 11, 19, 15, 13, 11, 11), GLYPH(0E, 11, 11, 11, 11, 11, 0E),
    GLYPH(1E, 11, 11, 1E, 10, 10, 10), GLYPH(0E, 11, 11, 11, 15, 12, 0D), GLYPH(1E, 11, 11, 1E, 14, 12, 11),
    GLYPH(0F, 10, 10, 0E, 01, 01, 1E), GLYPH(1F, 04, 04, 04, 04, 04, 04), GLYPH(11, 11, 11, 11, 11, 11, 0E),
    GLYPH(11, 11, 11, 11, 11, 0A, 04), GLYPH(11, 11, 11, 15, 15, 1B, 11), GLYPH(11, 11, 0A, 04, 0A, 11, 11),
    GLYPH(11, 11, 0A, 04, 04, 04, 04), GLYPH(1F, 01, 02, 04, 08, 10, 1F)};

static const uint8_t dot[GLYPH_H] = GLYPH(00, 00, 00, 00, 00, 0C, 0C);

/* NULL: nothing to draw. */
static const uint8_t *glyph_of(char c)
{
    if (c >= '0' && c <= '9')
        return digits[c - '0'];
    if (c >= 'a' && c <= 'z')
        return letters[c - 'a'];
    if (c >= 'A' && c <= 'Z')
        return letters[c - 'A'];
    return c == '.' ? dot : 0;
}

struct sheen_rect text_rect(const struct text *text, unsigned width, unsigned height)
{
    int right = text->x + TEXT_MAX * CELL_W * text->scale, bottom = text->y + GLYPH_H * text->scale;

    return (struct sheen_rect){text->x, text->y, (int16_t)(right < (int)width ? right : (int)width),
                               (int16_t)(bottom < (int)height ? bottom : (int)height)};
}

/* The pixels in memory as the core's overlay gets them: 565 values, or a byte a grey level. */
static void put_white(void *pixels, unsigned at, enum sheen_pixel pixel)
{
    if (sheen_pixel_bits(pixel) == 16)
        ((uint16_t *)pixels)[at] = 0xFFFF;
    else
        ((uint8_t *)pixels)[at] = (uint8_t)((1u << sheen_pixel_bits(pixel)) - 1u);
}

void text_overlay(void *ctx, const struct sheen_canvas *canvas)
{
    const struct text *text = ctx;
    const struct sheen_rect rect = canvas->rect;
    int scale = text->scale;

    for (int y = rect.y0 > text->y ? rect.y0 : text->y; y < rect.y1 && (y - text->y) / scale < GLYPH_H; y++) {
        int row = (y - text->y) / scale, x = text->x;

        for (const char *c = text->line; *c; c++, x += CELL_W * scale) {
            const uint8_t *glyph = glyph_of(*c);

            for (int i = 0; glyph && i < GLYPH_W * scale; i++)
                if (glyph[row] >> (GLYPH_W - 1 - i / scale) & 1 && x + i >= rect.x0 && x + i < rect.x1)
                    put_white(canvas->pixels, (unsigned)(y - rect.y0) * canvas->pitch + (unsigned)(x + i - rect.x0),
                              (enum sheen_pixel)text->pixel);
        }
    }
}
