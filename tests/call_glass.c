/*
 * call_glass.c - a panel for random sequences of calls.
 */
#include "call_glass.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static enum sheen_pixel pixel_of(const struct glass *g)
{
    return (enum sheen_pixel)g->target.pixel;
}

static bool on_grid(int edge, int align, int end)
{
    return align <= 1 || edge % align == 0 || edge == end;
}

static void check_rect(const struct glass *g, struct sheen_rect r)
{
    const struct sheen_target *t = &g->target;

    assert_true(r.x0 < r.x1 && r.y0 < r.y1);
    assert_true(r.x0 >= g->viewport.x0 && r.x1 <= g->viewport.x1 && r.y0 >= g->viewport.y0 && r.y1 <= g->viewport.y1);
    assert_true(on_grid(r.x0, t->align_x, 0) && on_grid(r.x1, t->align_x, t->width));
    assert_true(on_grid(r.y0, t->align_y, 0) && on_grid(r.y1, t->align_y, t->height));
}

static uint16_t value_at(const uint8_t *row, enum sheen_pixel pixel, unsigned x)
{
    unsigned bits = sheen_pixel_bits(pixel), bit = x * bits;

    if (bits == 16)
        return (uint16_t)(pixel == SHEEN_RGB565_BE ? row[2 * x] << 8 | row[2 * x + 1]
                                                   : row[2 * x + 1] << 8 | row[2 * x]);
    return (uint16_t)(row[bit / 8] >> (8 - bits - bit % 8) & ((1u << bits) - 1));
}

static unsigned row_bytes(const struct glass *g, struct sheen_rect r)
{
    return sheen_row_bytes(pixel_of(g), (unsigned)(r.x1 - r.x0));
}

static void show(struct glass *g, struct sheen_rect r, const uint8_t *row)
{
    for (int y = r.y0; y < r.y1; y++, row += row_bytes(g, r))
        for (int x = r.x0; x < r.x1; x++)
            g->shown[y * g->target.width + x] = value_at(row, pixel_of(g), (unsigned)(x - r.x0));
}

/* Return the code that was ordered, if any, once; the panel shows noise then. */
static int fault(struct glass *g, int *ordered)
{
    int code = *ordered;

    *ordered = 0;
    if (code == 0)
        return SHEEN_OK;
    if (g->failed == 0)
        g->failed = code;
    g->broken = true;
    glass_scribble(g);
    return code;
}

static int push(void *ctx, struct sheen_rect r, const void *pixels)
{
    struct glass *g = ctx;

    g->events++;
    assert_false(g->flying); /* else two pushes are under way */
    assert_false(g->broken);
    assert_true(g->locked == g->has_lock);
    check_rect(g, r);
    int error = fault(g, &g->fail_push);
    if (error < 0)
        return error;
    g->pushes++;
    g->area += (unsigned)((r.x1 - r.x0) * (r.y1 - r.y0));
    for (int y = r.y0; y < r.y1; y++)
        for (int x = r.x0; x < r.x1; x++)
            g->times[y * g->target.width + x]++;
    g->flying = g->target.wait != NULL;
    g->rect = r;
    g->pixels = pixels;
    memcpy(g->copy, pixels, row_bytes(g, r) * (size_t)(r.y1 - r.y0));
    if (!g->flying || !g->late)
        show(g, r, pixels);
    return SHEEN_OK;
}

static int wait(void *ctx)
{
    struct glass *g = ctx;

    g->events++;
    assert_true(g->locked == g->has_lock);
    if (!g->flying)
        return SHEEN_OK;
    g->flying = false;
    /* the core has not touched the buffer since the push */
    assert_memory_equal(g->copy, g->pixels, row_bytes(g, g->rect) * (size_t)(g->rect.y1 - g->rect.y0));
    int error = fault(g, &g->fail_wait);
    if (error == SHEEN_OK && g->late)
        show(g, g->rect, g->pixels);
    return error;
}

void glass_lock(void *ctx)
{
    struct glass *g = ctx;

    assert_false(g->locked);
    g->locked = true;
}

void glass_unlock(void *ctx)
{
    struct glass *g = ctx;

    assert_true(g->locked);
    g->locked = false;
}

void glass_make(struct glass *g, int width, int height, enum sheen_pixel pixel, bool waits)
{
    memset(g, 0, sizeof *g);
    g->noise = 1;
    g->target = (struct sheen_target){.ctx = g,
                                      .push = push,
                                      .wait = waits ? wait : NULL,
                                      .width = (uint16_t)width,
                                      .height = (uint16_t)height,
                                      .pixel = (uint8_t)pixel};
}

void glass_begin(struct glass *g, struct sheen_rect viewport)
{
    memset(g->times, 0, sizeof g->times);
    g->pushes = g->area = 0;
    g->broken = false;
    g->viewport = viewport;
}

void glass_scribble(struct glass *g)
{
    for (int i = 0; i < GLASS_PIXELS; i++) {
        g->noise = g->noise * 1664525u + 1013904223u;
        g->shown[i] = (uint16_t)(g->noise >> 16);
    }
}
