/*
 * demo.h - one scene for every board and the simulator: a teapot that turns, and a line of text.
 *
 * The scene knows a target and keys, nothing of boards. Held, it stands still and
 * shows the frame's number: the same keys then give the same picture everywhere.
 */
#ifndef DEMO_H
#define DEMO_H

#include "sheen_canvas.h"

#define DEMO_YAW_STEP SHEEN_DEGREES(6) /* a frame */

/* Another core. */
struct demo_crew {
    void (*start)(void (*work)(void *ctx), void *ctx); /* runs work(ctx) there, once */
    void (*join)(void);                                /* waits until it has ended */
    void (*lock)(void *ctx);                           /* of a sheen_config, with its lock_ctx */
    void (*unlock)(void *ctx);
};

struct demo {
    const struct sheen_target *target;
    const struct demo_crew *crew;
    struct sheen_frame *frame;
    struct sheen_view view;
    struct sheen_material material;
    struct sheen_object draw;
    struct sheen_text text;
    char line[16];   /* of text */
    uint16_t number; /* of the next frame, 0..59 */
    uint8_t shading; /* which of the shadings */
    uint8_t light;   /* which of the lightings */
    uint8_t held;
    uint8_t step; /* held: frames still to draw */
};

/*
 * target is borrowed. arena: aligned to 8, of *size bytes; *size becomes the size
 * that is needed. buffers: 1, or 2 where the bus sends by itself. crew: who draws bands
 * beside the caller, borrowed too, or NULL.
 */
int demo_open(struct demo *demo, const struct sheen_target *target, void *arena, size_t *size, unsigned buffers,
              const struct demo_crew *crew);

/*
 * h: hold or go on. n: held, the next frame. s: the next shading. l: the next
 * lighting. 0: back to frame 0. Held, each but h draws a frame. Anything else: nothing.
 */
void demo_key(struct demo *demo, int key);

/* 0: held, and nothing to draw. */
int demo_due(const struct demo *demo);

/*
 * Draws the next frame and sends it; held, also waits for its last band. On an
 * error the same frame is due again. tenths: frames a second, times ten, shown
 * unless held.
 */
int demo_frame(struct demo *demo, unsigned tenths);

/* "phong", say. */
const char *demo_shading_name(const struct demo *demo);

#endif
