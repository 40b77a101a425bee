/*
 * memory_target.c - a target in memory.
 */
#include "memory_target.h"

#include <stdlib.h>
#include <string.h>

static int breach(struct memory_target *t, const char *what)
{
    if (t->breaches++ == 0)
        t->first_breach = what;
    return 0;
}

static unsigned bits_of(const struct memory_target *t)
{
    return sheen_pixel_bits((enum sheen_pixel)t->target.pixel);
}

static size_t row_size(const struct memory_target *t, int pixels)
{
    return sheen_row_bytes((enum sheen_pixel)t->target.pixel, (unsigned)pixels);
}

static bool aligned(int edge, int align, int end)
{
    return align <= 1 || edge % align == 0 || edge == end;
}

static bool check(struct memory_target *t, struct sheen_rect r)
{
    int width = t->target.width, height = t->target.height, ax = t->target.align_x, ay = t->target.align_y;

    if (r.x0 < 0 || r.y0 < 0 || r.x1 > width || r.y1 > height)
        return breach(t, "a rectangle reaches out of the target");
    if (r.x0 >= r.x1 || r.y0 >= r.y1)
        return breach(t, "an empty rectangle");
    if (!aligned(r.x0, ax, 0) || !aligned(r.x1, ax, width) || !aligned(r.y0, ay, 0) || !aligned(r.y1, ay, height))
        return breach(t, "a rectangle that is not aligned");
    return true;
}

static void take(struct memory_target *t, struct sheen_rect r, const uint8_t *pixels)
{
    size_t bytes = row_size(t, r.x1 - r.x0);

    for (int y = r.y0; y < r.y1; y++) {
        memcpy(t->memory + (size_t)y * t->row_bytes + row_size(t, r.x0), pixels, bytes);
        pixels += bytes;
        for (int x = r.x0; x < r.x1; x++)
            t->times[y * t->target.width + x]++;
    }
}

static int push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    struct memory_target *t = ctx;

    if (t->in_flight)
        breach(t, "a push while another is under way");
    if (t->fail_push > 0 && --t->fail_push == 0)
        return t->fail_code;
    if (!check(t, rect))
        return SHEEN_ERR_ARGUMENT;
    t->pushes++;
    t->area += (long)(rect.x1 - rect.x0) * (rect.y1 - rect.y0);
    t->bytes += (long)row_size(t, rect.x1 - rect.x0) * (rect.y1 - rect.y0);
    if (!t->delayed) {
        take(t, rect, pixels);
        return SHEEN_OK;
    }
    t->in_flight = true;
    t->rect = rect;
    t->pixels = pixels;
    memcpy(t->copy, pixels, row_size(t, rect.x1 - rect.x0) * (size_t)(rect.y1 - rect.y0));
    return SHEEN_OK;
}

static int wait(void *ctx)
{
    struct memory_target *t = ctx;

    if (!t->in_flight)
        return SHEEN_OK;
    t->in_flight = false;
    if (memcmp(t->copy, t->pixels, row_size(t, t->rect.x1 - t->rect.x0) * (size_t)(t->rect.y1 - t->rect.y0)) != 0)
        breach(t, "a buffer was touched between push and wait");
    if (t->fail_wait > 0 && --t->fail_wait == 0)
        return t->fail_code;
    take(t, t->rect, t->pixels);
    return SHEEN_OK;
}

int memory_target_init(struct memory_target *t, int width, int height, enum sheen_pixel pixel)
{
    memset(t, 0, sizeof *t);
    t->target = (struct sheen_target){.ctx = t,
                                      .push = push,
                                      .wait = wait,
                                      .width = (uint16_t)width,
                                      .height = (uint16_t)height,
                                      .pixel = (uint8_t)pixel,
                                      .align_x = pixel == SHEEN_GREY2    ? 8
                                                 : pixel == SHEEN_GREY16 ? 2
                                                                         : 1,
                                      .align_y = 1};
    t->row_bytes = row_size(t, width);
    t->memory = calloc((size_t)height, t->row_bytes);
    t->copy = calloc((size_t)height, t->row_bytes);
    t->times = calloc((size_t)height, (size_t)width);
    if (!t->memory || !t->copy || !t->times) {
        memory_target_free(t);
        return -1;
    }
    return 0;
}

void memory_target_free(struct memory_target *t)
{
    free(t->memory);
    free(t->copy);
    free(t->times);
    t->memory = t->copy = t->times = NULL;
}

void memory_target_begin(struct memory_target *t)
{
    t->pushes = t->area = t->bytes = 0;
    memset(t->times, 0, (size_t)t->target.width * t->target.height);
}

unsigned memory_target_pixel(const struct memory_target *t, int x, int y)
{
    const uint8_t *row = t->memory + (size_t)y * t->row_bytes;
    unsigned bits = bits_of(t), bit = (unsigned)x * bits;

    if (t->target.pixel == SHEEN_RGB565_BE)
        return (unsigned)row[2 * x] << 8 | row[2 * x + 1];
    if (t->target.pixel == SHEEN_RGB565_LE)
        return (unsigned)row[2 * x + 1] << 8 | row[2 * x];
    return row[bit / 8] >> (8 - bits - bit % 8) & ((1u << bits) - 1);
}
