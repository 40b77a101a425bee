/*
 * canvas_items.h - 2D of a user's own that changes from frame to frame: areas, gradients, images and text that come,
 * move, change and leave, under and over the triangles, and things that only a canvas's entries allow.
 */
#ifndef CANVAS_ITEMS_H
#define CANVAS_ITEMS_H

#include <stdbool.h>

#include "sheen_canvas.h"

#define ITEMS 6
#define ITEM_LETTERS 14

enum item_kind {
    ITEM_FILL,
    ITEM_GRADIENT,
    ITEM_IMAGE,
    ITEM_TEXT,
    ITEM_INVERT, /* each pixel becomes its complement, so that drawing twice shows */
    ITEM_WALL,   /* an area with a depth of its own */
    ITEM_BEHIND, /* only where the depth is less than its own */
    ITEM_KINDS
};

struct item {
    enum item_kind kind;
    bool shown, under; /* under: in the underlay, else in the overlay */
    struct sheen_rect rect;
    struct sheen_gradient gradient; /* its first colour is that of areas as well */
    struct sheen_image image;
    struct sheen_text text;
    struct sheen_font font;
    char line[ITEM_LETTERS + 1];
    uint16_t depth;
};

/* The ctx of both callbacks. */
struct items {
    enum sheen_pixel pixel;
    int width, height; /* px, of the target */
    struct item item[ITEMS];
    struct sheen_rect mark[2 * ITEMS]; /* where an item that changed was and is */
    unsigned marks;
};

void items_make(struct items *items, uint32_t *seed, const struct sheen_target *target);

/* Change each item with a chance of 4 in `calm`, and note what has to be marked. */
void items_next(struct items *items, uint32_t *seed, unsigned calm);

void items_underlay(void *ctx, const struct sheen_canvas *canvas);
void items_overlay(void *ctx, const struct sheen_canvas *canvas);

#endif
