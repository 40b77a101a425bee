/*
 * canvas_items.c - 2D of a user's own that changes from frame to frame.
 */
#include "canvas_items.h"

#include <string.h>

#include "frame_stage.h"

static unsigned below(uint32_t *seed, unsigned n)
{
    return (stage_random(seed) >> 8) % n;
}

static bool one_in(uint32_t *seed, unsigned n)
{
    return below(seed, n) == 0;
}

/* ---- drawing ---- */

static bool is_wide(enum sheen_pixel pixel)
{
    return pixel <= SHEEN_RGB565_LE;
}

static void invert(const struct sheen_canvas *canvas, size_t at)
{
    uint16_t *wide = (uint16_t *)canvas->pixels + at;
    uint8_t *level = (uint8_t *)canvas->pixels + at;

    if (is_wide(canvas->pixel))
        *wide = (uint16_t) ~*wide;
    else
        *level = (uint8_t)((1u << sheen_pixel_bits(canvas->pixel)) - 1u - *level);
}

static void put(const struct sheen_canvas *canvas, size_t at, uint16_t entry)
{
    if (is_wide(canvas->pixel))
        ((uint16_t *)canvas->pixels)[at] = entry;
    else
        ((uint8_t *)canvas->pixels)[at] = (uint8_t)entry;
}

/* What no function of the canvas draws: entry by entry. */
static void draw_entries(const struct item *item, const struct sheen_canvas *canvas)
{
    const struct sheen_rect c = canvas->rect, r = item->rect;
    const uint16_t entry = sheen_canvas_colour(canvas->pixel, item->gradient.first);

    for (int y = r.y0 > c.y0 ? r.y0 : c.y0; y < r.y1 && y < c.y1; y++)
        for (int x = r.x0 > c.x0 ? r.x0 : c.x0; x < r.x1 && x < c.x1; x++) {
            const size_t at = (size_t)(y - c.y0) * canvas->pitch + (size_t)(x - c.x0);
            if (item->kind == ITEM_INVERT)
                invert(canvas, at);
            else if (item->kind == ITEM_WALL || canvas->depth[at] < item->depth)
                put(canvas, at, entry);
            if (item->kind == ITEM_WALL)
                canvas->depth[at] = item->depth;
        }
}

static void draw_item(const struct item *item, const struct sheen_canvas *canvas)
{
    struct sheen_gradient gradient = item->gradient;
    struct sheen_text text = item->text;

    switch (item->kind) {
    case ITEM_FILL:
        sheen_canvas_fill(canvas, canvas->pixel, item->rect, item->gradient.first);
        break;
    case ITEM_GRADIENT:
        gradient.rect = item->rect;
        sheen_canvas_gradient(canvas, canvas->pixel, &gradient);
        break;
    case ITEM_IMAGE:
        sheen_canvas_image(canvas, canvas->pixel, &item->image);
        break;
    case ITEM_TEXT:
        text.line = item->line;
        text.font = item->font.rows != NULL ? &item->font : NULL;
        sheen_canvas_text(canvas, canvas->pixel, &text);
        break;
    default:
        draw_entries(item, canvas);
        break;
    }
}

static void draw_items(const struct items *items, const struct sheen_canvas *canvas, bool under)
{
    for (int i = 0; i < ITEMS; i++)
        if (items->item[i].shown && items->item[i].under == under)
            draw_item(&items->item[i], canvas);
}

void items_underlay(void *ctx, const struct sheen_canvas *canvas)
{
    const struct items *items = ctx;
    const struct sheen_gradient sky = {
        {0, 0, (int16_t)items->width, (int16_t)items->height}, {10, 30, 90}, {240, 200, 120}};

    sheen_canvas_gradient(canvas, canvas->pixel, &sky);
    draw_items(items, canvas, true);
}

void items_overlay(void *ctx, const struct sheen_canvas *canvas)
{
    draw_items(ctx, canvas, false);
}

/* ---- changing ---- */

static int16_t last(int first, int size)
{
    return (int16_t)(first + size > INT16_MAX ? INT16_MAX : first + size);
}

static struct sheen_rect rect_of(const struct item *item)
{
    const struct sheen_image *image = &item->image;
    struct sheen_text text = item->text;

    if (item->kind == ITEM_IMAGE)
        return (struct sheen_rect){image->x, image->y, last(image->x, image->width), last(image->y, image->height)};
    text.font = item->font.rows != NULL ? &item->font : NULL;
    return item->kind == ITEM_TEXT ? sheen_text_rect(&text, item->line) : item->rect;
}

/* A place on the target or partly beside it. */
static int place(uint32_t *seed, int size)
{
    return (int)below(seed, (unsigned)size + 24) - 20;
}

/* Any coordinate, often the first or the last. */
static int16_t any(uint32_t *seed)
{
    return one_in(seed, 3) ? INT16_MIN : one_in(seed, 3) ? INT16_MAX : (int16_t)((int)below(seed, 65536) - 32768);
}

static void move(struct item *item, const struct items *items, uint32_t *seed)
{
    int x = place(seed, items->width), y = place(seed, items->height);

    item->rect = (struct sheen_rect){(int16_t)x, (int16_t)y, (int16_t)(x + (int)below(seed, 40)),
                                     (int16_t)(y + (int)below(seed, 30))};
    if (one_in(seed, 16)) { /* any rectangle, and images and text far beside the target */
        x = any(seed);
        y = one_in(seed, 2) ? any(seed) : y;
        item->rect = (struct sheen_rect){any(seed), any(seed), any(seed), any(seed)};
    }
    item->image.x = item->text.x = (int16_t)x;
    item->image.y = item->text.y = (int16_t)y;
}

static void change_line(struct item *item, uint32_t *seed)
{
    const unsigned letters = below(seed, ITEM_LETTERS + 1);

    for (unsigned i = 0; i < letters; i++)
        item->line[i] = (char)(' ' + below(seed, 96)); /* some of them are in no font */
    item->line[letters] = '\0';
}

static void change_image(struct item *item, enum sheen_pixel pixel, uint32_t *seed)
{
    static uint16_t wide[24 * 24];
    static uint8_t level[3][24 * 24];
    const bool narrow = !is_wide(pixel);

    for (unsigned i = 0; i < 24 * 24; i++) {
        wide[i] = (uint16_t)(i % 5 * 0x9e37u);
        level[0][i] = (uint8_t)(i / 3 % 2);
        level[1][i] = (uint8_t)(i * 7 % 16);
        level[2][i] = (uint8_t)(i * 37);
    }
    item->image = (struct sheen_image){.pixels = narrow ? (const void *)level[pixel - SHEEN_GREY2] : wide,
                                       .pitch = 24,
                                       .width = (uint16_t)(1 + below(seed, 24)),
                                       .height = (uint16_t)(1 + below(seed, 24)),
                                       .x = item->image.x,
                                       .y = item->image.y,
                                       .keyed = one_in(seed, 2),
                                       .key = (uint16_t)(narrow ? below(seed, 2) : 0x9e37u)};
    if (one_in(seed, 4))
        item->image.pitch = 0;
}

static void change_look(struct item *item, enum sheen_pixel pixel, uint32_t *seed)
{
    for (int k = 0; k < 3; k++) {
        item->gradient.first[k] = (uint8_t)below(seed, 256);
        item->gradient.last[k] = (uint8_t)below(seed, 256);
        item->text.rgb[k] = (uint8_t)below(seed, 256);
    }
    item->text.scale = (uint8_t)below(seed, 4);
    item->font = sheen_font_5x7;
    item->font.advance = (uint8_t)(3 + below(seed, 6));
    if (one_in(seed, 2))
        item->font.rows = NULL;
    item->depth = (uint16_t)(257 + below(seed, 65020));
    change_image(item, pixel, seed);
    change_line(item, seed);
}

static void mark(struct items *items, const struct item *item)
{
    if (item->shown)
        items->mark[items->marks++] = rect_of(item);
}

void items_make(struct items *items, uint32_t *seed, const struct sheen_target *target)
{
    memset(items, 0, sizeof *items);
    items->pixel = (enum sheen_pixel)target->pixel;
    items->width = target->width;
    items->height = target->height;
    for (int i = 0; i < ITEMS; i++) {
        struct item *item = &items->item[i];
        item->kind = (enum item_kind)below(seed, ITEM_KINDS);
        item->under = item->kind == ITEM_WALL || (item->kind != ITEM_BEHIND && one_in(seed, 2));
        item->shown = one_in(seed, 2);
        move(item, items, seed);
        change_look(item, items->pixel, seed);
    }
}

void items_next(struct items *items, uint32_t *seed, unsigned calm)
{
    items->marks = 0;
    for (int i = 0; i < ITEMS; i++) {
        struct item *item = &items->item[i];
        const unsigned what = below(seed, calm);
        if (what > 3)
            continue;
        mark(items, item);
        if (what == 0)
            item->shown = !item->shown;
        else if (what == 1)
            move(item, items, seed);
        else if (what == 2)
            change_look(item, items->pixel, seed);
        else
            change_line(item, seed);
        mark(items, item);
    }
}
