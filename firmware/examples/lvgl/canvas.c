/*
 * canvas.c - sheen on an LVGL 9 canvas: copies each rectangle into the canvas's draw buffer and invalidates its area.
 *
 * Call sheen_on_canvas() once, from the task that runs LVGL; from then on a timer of LVGL draws picture after picture.
 * The draw buffer must be in LV_COLOR_FORMAT_RGB565.
 */
#include <string.h>

#include "example.h"
#include "lvgl.h"

#define PERIOD_MS 33 /* how often LVGL refreshes its screen by default (LV_DEF_REFR_PERIOD) */

static int push(void *ctx, struct sheen_rect r, const void *pixels)
{
    lv_obj_t *canvas = ctx;
    lv_draw_buf_t *buffer = lv_canvas_get_draw_buf(canvas);
    size_t bytes = (size_t)(r.x1 - r.x0) * 2;
    lv_area_t area = {r.x0, r.y0, r.x1 - 1, r.y1 - 1}, at;

    for (int32_t y = r.y0; y < r.y1; y++)
        memcpy(lv_draw_buf_goto_xy(buffer, (uint32_t)r.x0, (uint32_t)y),
               (const uint8_t *)pixels + bytes * (size_t)(y - r.y0), bytes);
    lv_obj_get_coords(canvas, &at);
    lv_area_move(&area, at.x1, at.y1);
    lv_obj_invalidate_area(canvas, &area);
    return SHEEN_OK;
}

static void draw(lv_timer_t *timer)
{
    static unsigned i;

    if (example_draw(lv_timer_get_user_data(timer), i++) != SHEEN_OK)
        lv_timer_delete(timer);
}

int sheen_on_canvas(lv_obj_t *canvas)
{
    static struct sheen_target target;
    lv_draw_buf_t *buffer = lv_canvas_get_draw_buf(canvas);
    struct sheen_frame *frame;
    int error;

    target = (struct sheen_target){.ctx = canvas,
                                   .push = push,
                                   .width = (uint16_t)buffer->header.w,
                                   .height = (uint16_t)buffer->header.h,
                                   .pixel = SHEEN_RGB565_LE};
    error = example_init(&frame, &target);
    if (!error && lv_timer_create(draw, PERIOD_MS, frame) == NULL)
        error = SHEEN_ERR_MEMORY;
    return error;
}
