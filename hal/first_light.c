/*
 * first_light.c - border, corner marks, colour and grey bars, on any target.
 */
#include "sheen_first_light.h"

#define BLACK 0x000000u
#define WHITE 0xFFFFFFu
#define RED 0xFF0000u
#define GREEN 0x00FF00u
#define BLUE 0x0000FFu

#define GREY_STEPS 8u

/* Corner marks are 1 px away from the border; their size is a sixth of the picture's short side, 4..40 px. */
#define MARK_INSET 2u

static unsigned mark_size(unsigned w, unsigned h)
{
    unsigned size = (w < h ? w : h) / 6;

    return size < 4 ? 4 : size > 40 ? 40 : size;
}

/* The colour of a corner's mark at (u, v) px from the mark's outer corner inwards, both below size. */
static uint32_t mark(unsigned u, unsigned v, unsigned size, int right, int bottom)
{
    unsigned last = size - 1;

    if (!right && !bottom)
        return RED;
    if (!bottom)
        return u == 0 || v == 0 || u == last || v == last ? GREEN : BLACK;
    if (!right)
        return u + v >= last ? BLUE : BLACK; /* the right angle points inwards, where round glass shows it */
    return u == v || u + v == last ? WHITE : BLACK;
}

/* Whether `at` lies in the middle half, where the bars are, of an axis of `size` pixels. */
static int in_middle(unsigned at, unsigned size)
{
    return at - size / 4 < size - size / 4 * 2; /* in the first quarter the difference wraps to a huge value */
}

/* The colour at (x, y) of the bars, which are w x h px: red, green, blue above, steps of grey below. */
static uint32_t bars(unsigned x, unsigned y, unsigned w, unsigned h)
{
    unsigned step;

    if (y < h / 2)
        return RED >> x * 3 / w * 8;
    step = x * GREY_STEPS / w * 255 / (GREY_STEPS - 1);
    return step << 16 | step << 8 | step;
}

uint32_t sheen_first_light_colour(unsigned x, unsigned y, unsigned w, unsigned h)
{
    unsigned size = mark_size(w, h);
    int right = x >= w / 2, bottom = y >= h / 2;
    unsigned u = right ? w - 1 - x : x, v = bottom ? h - 1 - y : y; /* px from the nearest edges */

    if (u == 0 || v == 0)
        return WHITE;
    if (u >= MARK_INSET && v >= MARK_INSET && u < MARK_INSET + size && v < MARK_INSET + size)
        return mark(u - MARK_INSET, v - MARK_INSET, size, right, bottom);
    if (in_middle(x, w) && in_middle(y, h))
        return bars(x - w / 4, y - h / 4, w - w / 4 * 2, h - h / 4 * 2);
    return BLACK;
}

/* Maps 0..255 to 0..most, rounded to nearest. */
static unsigned scale(unsigned v, unsigned most)
{
    return (v * most + 127) / 255;
}

static unsigned to_565(uint32_t colour)
{
    return scale(colour >> 16 & 255, 31) << 11 | scale(colour >> 8 & 255, 63) << 5 | scale(colour & 255, 31);
}

/* Luminance, with weights 0.2126, 0.7152, 0.0722 in 1/256 (their sum is 256), rounded to a level. */
static unsigned to_level(uint32_t colour, unsigned max_level)
{
    return scale((54 * (colour >> 16 & 255) + 183 * (colour >> 8 & 255) + 19 * (colour & 255)) / 256, max_level);
}

/* The colour on grey targets: bars keep theirs, for its luminance; corner marks become white, to be seen. */
static uint32_t grey_colour(unsigned x, unsigned y, unsigned w, unsigned h)
{
    uint32_t colour = sheen_first_light_colour(x, y, w, h);

    return (in_middle(x, w) && in_middle(y, h)) || colour == BLACK ? colour : WHITE;
}

/* Writes pixel (x, y) of the picture into the row at `row`, in the target's format. */
static void put(const struct sheen_target *target, uint8_t *row, unsigned x, unsigned y)
{
    enum sheen_pixel pixel = (enum sheen_pixel)target->pixel;
    unsigned bits = sheen_pixel_bits(pixel), w = target->width, h = target->height;

    if (bits == 16) {
        unsigned v = to_565(sheen_first_light_colour(x, y, w, h)), low = pixel == SHEEN_RGB565_BE;

        row[2 * x + low] = (uint8_t)v;
        row[2 * x + !low] = (uint8_t)(v >> 8);
        return;
    }
    unsigned shift = 8 - bits - x * bits % 8, max_level = (1u << bits) - 1;
    uint8_t *byte = &row[x * bits / 8];

    *byte = (uint8_t)((*byte & ~(max_level << shift)) | to_level(grey_colour(x, y, w, h), max_level) << shift);
}

int sheen_first_light(const struct sheen_target *target, void *buffer, size_t bytes)
{
    if (!target || !target->push || !buffer || target->width == 0 || target->height == 0)
        return SHEEN_ERR_ARGUMENT;
    unsigned align = target->align_y ? target->align_y : 1;
    size_t row_bytes = sheen_row_bytes((enum sheen_pixel)target->pixel, target->width);
    size_t rows = bytes / row_bytes / align * align;

    if (rows == 0)
        return SHEEN_ERR_MEMORY; /* a band must have a multiple of align_y rows */
    for (unsigned y = 0; y < target->height; y += (unsigned)rows) {
        unsigned end = target->height - y < rows ? target->height : y + (unsigned)rows;
        struct sheen_rect rect = {0, (int16_t)y, (int16_t)target->width, (int16_t)end};
        int error;

        for (unsigned j = y; j < end; j++)
            for (unsigned x = 0; x < target->width; x++)
                put(target, (uint8_t *)buffer + (j - y) * row_bytes, x, j);
        error = target->push(target->ctx, rect, buffer);
        if (error == SHEEN_OK && target->wait)
            error = target->wait(target->ctx);
        if (error < 0)
            return error;
    }
    return SHEEN_OK;
}
