/*
 * demo.h - one scene for every board and the simulator: a teapot that turns, and a line of text.
 *
 * The scene knows a target and keys, but nothing about boards. While it is held, it
 * stands still and shows the frame's number instead of the frame rate, so that the
 * same keys give the same picture everywhere.
 */
#ifndef DEMO_H
#define DEMO_H

#include "sheen_canvas.h"

#define DEMO_YAW_STEP SHEEN_DEGREES(6) /* per frame */

/* Another core, which helps to draw. */
struct demo_crew {
    void (*start)(void (*work)(void *ctx), void *ctx); /* runs work(ctx) on that core, once */
    void (*join)(void);                                /* waits until the work has ended */
    void (*lock)(void *ctx);                           /* lock and unlock for a sheen_config, which calls */
    void (*unlock)(void *ctx);                         /* them with its lock_ctx */
};

struct demo {
    const struct sheen_target *target;
    const struct demo_crew *crew;
    struct sheen_frame *frame;
    struct sheen_view view;
    struct sheen_material material;
    struct sheen_object draw;
    struct sheen_text text;
    char line[16];   /* the text's characters */
    uint16_t number; /* of the next frame, 0..59 */
    uint8_t shading; /* index of the shading */
    uint8_t light;   /* index of the lighting */
    uint8_t held;
    uint8_t step; /* while held: frames still to draw */
};

/*
 * target is borrowed. arena: aligned to 8, *size bytes; *size becomes the size that is
 * needed. buffers: 1, or 2 if the bus sends by DMA. crew: another core that draws bands
 * beside the caller, borrowed too; NULL: none.
 */
int demo_open(struct demo *demo, const struct sheen_target *target, void *arena, size_t *size, unsigned buffers,
              const struct demo_crew *crew);

/*
 * h: hold or go on. n: the next frame, while held. s: the next shading. l: the next
 * lighting. 0: back to frame 0. While held, each of these except h draws one frame.
 * Other keys do nothing.
 */
void demo_key(struct demo *demo, int key);

/* Whether there is a frame to draw; 0: held, and no key has asked for one. */
int demo_due(const struct demo *demo);

/*
 * Draws the next frame and sends it; while held, it also waits until the last band has
 * been sent. After an error the same frame is due again. tenths: frames per second,
 * times ten, shown unless held.
 */
int demo_frame(struct demo *demo, unsigned tenths);

/* Such as "phong". */
const char *demo_shading_name(const struct demo *demo);

#endif
