/*
 * test_panel_canvas.c - the ideal memory that simulated panels are compared with.
 */
#include "test_panel_canvas.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

void canvas_open_choice(struct canvas *canvas, const struct sheen_sim_choice *choice)
{
    size_t pixels = (size_t)choice->width * choice->height;

    *canvas = (struct canvas){.noise = 0x1234567u + choice->orientation};
    if (sheen_sim_panel_open(&canvas->panel, choice) < 0)
        fail_msg("%s cannot be simulated", choice->record ? choice->record->name : "ideal");
    canvas->target = sheen_sim_panel_target(canvas->panel);
    canvas->ideal = calloc(pixels, sizeof *canvas->ideal);
    canvas->seen = calloc(pixels, sizeof *canvas->seen);
    canvas->buffer = calloc(pixels, 2);
    assert_true(canvas->ideal && canvas->seen && canvas->buffer);
}

void canvas_open(struct canvas *canvas, const char *name, int orientation, unsigned width, unsigned height)
{
    struct sheen_sim_choice choice;
    char why[160];

    if (sheen_sim_choose(&choice, name, orientation, width, height, why, sizeof why) < 0)
        fail_msg("%s", why);
    canvas_open_choice(canvas, &choice);
}

void canvas_close(struct canvas *canvas)
{
    sheen_sim_panel_close(canvas->panel);
    free(canvas->ideal);
    free(canvas->seen);
    free(canvas->buffer);
}

static unsigned noise(struct canvas *canvas, unsigned below)
{
    canvas->noise = canvas->noise * 1664525u + 1013904223u;
    return (canvas->noise >> 8) % below;
}

void canvas_put(uint8_t *row, enum sheen_pixel pixel, unsigned x, uint16_t value)
{
    unsigned bits = sheen_pixel_bits(pixel);

    if (bits == 16) {
        row[2 * x] = (uint8_t)(value >> 8);
        row[2 * x + 1] = (uint8_t)value;
        return;
    }
    unsigned shift = 8 - bits - x * bits % 8;
    uint8_t *byte = &row[x * bits / 8];

    *byte = (uint8_t)((*byte & ~(((1u << bits) - 1) << shift)) | (unsigned)value << shift);
}

int canvas_push(struct canvas *canvas, struct sheen_rect rect)
{
    const struct sheen_target *target = canvas->target;
    enum sheen_pixel pixel = (enum sheen_pixel)target->pixel;
    unsigned bits = sheen_pixel_bits(pixel), width = (unsigned)(rect.x1 - rect.x0);

    for (int y = rect.y0; y < rect.y1; y++) {
        uint8_t *row = canvas->buffer + (unsigned)(y - rect.y0) * sheen_row_bytes(pixel, width);

        for (unsigned x = 0; x < width; x++) {
            uint16_t value = (uint16_t)noise(canvas, 1u << bits);

            canvas->ideal[(unsigned)y * target->width + (unsigned)rect.x0 + x] = value;
            canvas_put(row, pixel, x, value);
        }
    }
    int error = target->push(target->ctx, rect, canvas->buffer);

    return error < 0 ? error : target->wait(target->ctx);
}

int canvas_push_all(struct canvas *canvas, unsigned band)
{
    unsigned height = canvas->target->height;

    for (unsigned y = 0; y < height; y += band) {
        unsigned end = y + band < height ? y + band : height;
        int error =
            canvas_push(canvas, (struct sheen_rect){0, (int16_t)y, (int16_t)canvas->target->width, (int16_t)end});

        if (error < 0)
            return error;
    }
    return 0;
}

/* A random range first..end on an axis of `size`: both are multiples of `align`, except that `end` may be the size. */
static void range(struct canvas *canvas, unsigned size, unsigned align, int16_t *first, int16_t *end)
{
    unsigned steps = (size + align - 1) / align, a = noise(canvas, steps), b = noise(canvas, steps);

    *first = (int16_t)((a < b ? a : b) * align);
    *end = (int16_t)(((a < b ? b : a) + 1) * align);
    if (*end > (int16_t)size)
        *end = (int16_t)size;
}

struct sheen_rect canvas_rect(struct canvas *canvas)
{
    const struct sheen_target *target = canvas->target;
    struct sheen_rect rect;

    range(canvas, target->width, target->align_x, &rect.x0, &rect.x1);
    range(canvas, target->height, target->align_y, &rect.y0, &rect.y1);
    return rect;
}

unsigned canvas_differences(struct canvas *canvas)
{
    unsigned width = canvas->target->width, count = 0;

    assert_int_equal(sheen_sim_panel_picture(canvas->panel, canvas->seen), 0);
    for (unsigned y = 0; y < canvas->target->height; y++)
        for (unsigned x = 0; x < width; x++)
            count +=
                canvas->seen[y * width + x] != canvas->ideal[y * width + x] && sheen_sim_panel_has(canvas->panel, x, y);
    return count;
}

void canvas_quiet(const struct canvas *canvas)
{
    if (sheen_sim_panel_complaints(canvas->panel))
        fail_msg("%u complaints, first: %s", sheen_sim_panel_complaints(canvas->panel),
                 sheen_sim_panel_complaint(canvas->panel));
}
