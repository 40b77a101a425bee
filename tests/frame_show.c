/*
 * frame_show.c - a stage on which objects move, leave and come back.
 */
#include "frame_show.h"

#include <string.h>

static void put(const struct show_painter *p, void *pixels, size_t at, unsigned value)
{
    uint8_t *byte = (uint8_t *)pixels + 2 * at;

    byte[p->pixel == SHEEN_RGB565_BE ? 0 : 1] = (uint8_t)(value >> 8);
    byte[p->pixel == SHEEN_RGB565_BE ? 1 : 0] = (uint8_t)value;
}

void show_underlay(void *ctx, const struct sheen_canvas *canvas)
{
    const struct sheen_rect rect = canvas->rect;
    struct show_painter *p = ctx;

    for (int y = rect.y0; y < rect.y1; y++) {
        for (int x = rect.x0; x < rect.x1; x++)
            put(p, canvas->pixels, (size_t)(y - rect.y0) * canvas->pitch + (size_t)(x - rect.x0),
                (unsigned)(x * 77 + y * 1021) & 0x39e7);
    }
}

void show_overlay(void *ctx, const struct sheen_canvas *canvas)
{
    const struct sheen_rect rect = canvas->rect;
    struct show_painter *p = ctx;

    for (int y = rect.y0; y < rect.y1; y++) {
        for (int x = rect.x0; x < rect.x1; x++) {
            if (x >= p->marker_x && x < p->marker_x + 9 && y >= p->marker_y && y < p->marker_y + 9)
                put(p, canvas->pixels, (size_t)(y - rect.y0) * canvas->pitch + (size_t)(x - rect.x0), 0xffff);
        }
    }
}

void show_enter(struct actor *a, uint32_t *seed)
{
    *a = (struct actor){(enum stage_mesh)(stage_random(seed) % STAGE_MESHES),
                        (int)(stage_random(seed) % 3),
                        (enum sheen_shading)(stage_random(seed) % 4),
                        stage_uniform(seed, -3, 3),
                        stage_uniform(seed, -2, 2),
                        stage_uniform(seed, 2, 9),
                        stage_uniform(seed, 0.2, 0.7),
                        stage_uniform(seed, 0, 360),
                        stage_uniform(seed, 0, 360)};
}

static void place_marker(struct show *s, int x, int y)
{
    s->marks[0] = s->marks[1];
    s->marks[1] = (struct sheen_rect){(int16_t)x, (int16_t)y, (int16_t)(x + 9), (int16_t)(y + 9)};
    s->painter.marker_x = x;
    s->painter.marker_y = y;
}

/* The whole target, or a rectangle on the target's alignment, as the core demands. */
static struct sheen_rect random_viewport(const struct show_settings *settings, uint32_t *seed)
{
    int ax = settings->align_x ? settings->align_x : 1, ay = settings->align_y ? settings->align_y : 1;
    int x = (int)(stage_random(seed) % 60) / ax * ax, y = (int)(stage_random(seed) % 40) / ay * ay;
    int width = (30 + (int)(stage_random(seed) % 70)) / ax * ax,
        height = (30 + (int)(stage_random(seed) % 50)) / ay * ay;

    if (stage_random(seed) % 2)
        return (struct sheen_rect){0, 0, 0, 0};
    return (struct sheen_rect){(int16_t)x, (int16_t)y, (int16_t)(x + width), (int16_t)(y + height)};
}

void show_change(struct show *s, const struct show_settings *settings, uint32_t *seed)
{
    for (int i = 0; i < SHOW_ACTORS; i++) {
        if (stage_random(seed) % 8 == 0)
            s->on[i] = !s->on[i];
        if (stage_random(seed) % 16 == 0)
            show_enter(&s->actors[i], seed);
        if (stage_random(seed) % 4 == 0) {
            s->actors[i].x += stage_uniform(seed, -0.3, 0.3);
            s->actors[i].yaw += 10;
        }
    }
    struct sheen_rect before = s->view.viewport;
    if (stage_random(seed) % 16 == 0)
        s->view.viewport = random_viewport(settings, seed);
    s->viewport_changed = memcmp(&before, &s->view.viewport, sizeof before) != 0;
    s->background_changed = stage_random(seed) % 16 == 0;
    if (s->background_changed)
        s->view.background[1] = (uint8_t)(s->view.background[1] + 64);
    place_marker(s, (int)(stage_random(seed) % (SHOW_WIDTH - 9)), (int)(stage_random(seed) % (SHOW_HEIGHT - 9)));
}

int show_play(struct sheen_frame *frame, const struct stage *stage, const struct show *s)
{
    int status = sheen_begin(frame, &s->view);

    for (int i = 0; i < SHOW_ACTORS && status == SHEEN_OK; i++) {
        struct sheen_object draw;
        if (!s->on[i])
            continue;
        stage_draw(stage, &s->actors[i], &draw);
        status = sheen_draw(frame, &draw);
    }
    for (int i = 0; i < 2 && status == SHEEN_OK && s->view.overlay; i++)
        status = sheen_mark(frame, s->marks[i]);
    return status == SHEEN_OK ? sheen_end(frame) : status;
}
