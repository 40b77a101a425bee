/*
 * lvgl.c - stands for LVGL 9: a canvas of 240 x 240 with a stride, redrawing the invalidated part of the screen, and a
 * timer, which runs EXAMPLE_FRAMES times.
 */
#include "lvgl.h"

#include <stdio.h>

#define STRIDE 512

struct lv_timer_t {
    lv_timer_cb_t callback;
    void *user_data;
};

static lv_timer_t only_timer;

int sheen_on_canvas(lv_obj_t *canvas);

lv_timer_t *lv_timer_create(lv_timer_cb_t callback, uint32_t period_ms, void *user_data)
{
    (void)period_ms;
    only_timer = (lv_timer_t){callback, user_data};
    return &only_timer;
}

void *lv_timer_get_user_data(lv_timer_t *timer)
{
    return timer->user_data;
}

void lv_timer_delete(lv_timer_t *timer)
{
    timer->callback = NULL;
}

lv_draw_buf_t *lv_canvas_get_draw_buf(lv_obj_t *canvas)
{
    return canvas->buffer;
}

void *lv_draw_buf_goto_xy(const lv_draw_buf_t *buffer, uint32_t x, uint32_t y)
{
    return buffer->data + y * buffer->header.stride + 2 * x;
}

void lv_obj_get_coords(const lv_obj_t *object, lv_area_t *at)
{
    *at = object->at;
}

void lv_area_move(lv_area_t *area, int32_t x, int32_t y)
{
    *area = (lv_area_t){area->x1 + x, area->y1 + y, area->x2 + x, area->y2 + y};
}

void lv_obj_invalidate_area(const lv_obj_t *object, const lv_area_t *area)
{
    lv_area_t *all = &((lv_obj_t *)object)->invalid;

    all->x1 = area->x1 < all->x1 ? area->x1 : all->x1;
    all->y1 = area->y1 < all->y1 ? area->y1 : all->y1;
    all->x2 = area->x2 > all->x2 ? area->x2 : all->x2;
    all->y2 = area->y2 > all->y2 ? area->y2 : all->y2;
}

int main(void)
{
    static uint8_t bytes[240 * STRIDE];
    lv_draw_buf_t buffer = {{240, 240, STRIDE}, bytes};
    lv_obj_t canvas = {&buffer, {40, 20, 279, 259}, {9999, 9999, -1, -1}};

    if (sheen_on_canvas(&canvas) != 0)
        return 1;
    for (int i = 0; i < EXAMPLE_FRAMES && only_timer.callback; i++)
        only_timer.callback(&only_timer);
    if (canvas.invalid.x1 != 40 || canvas.invalid.y1 != 20 || canvas.invalid.x2 != 279 || canvas.invalid.y2 != 259) {
        fprintf(stderr, "lvgl: the first frame does not invalidate the canvas\n");
        return 1;
    }
    for (int y = 0; y < 240; y++)
        fwrite(bytes + y * STRIDE, 2, 240, stdout);
    return fflush(stdout) != 0;
}
