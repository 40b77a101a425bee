/*
 * lvgl.h - stands for LVGL 9: a canvas with a draw buffer of RGB565, areas that are invalidated, a timer.
 */
#ifndef LVGL_H
#define LVGL_H

#include <stdint.h>

typedef struct {
    int32_t x1, y1, x2, y2;
} lv_area_t;

typedef struct {
    struct {
        uint32_t w, h, stride;
    } header;
    uint8_t *data;
} lv_draw_buf_t;

typedef struct {
    lv_draw_buf_t *buffer;
    lv_area_t at, invalid; /* place on the screen; the union of all invalidated areas */
} lv_obj_t;

typedef struct lv_timer_t lv_timer_t;
typedef void (*lv_timer_cb_t)(lv_timer_t *timer);

lv_draw_buf_t *lv_canvas_get_draw_buf(lv_obj_t *canvas);
void *lv_draw_buf_goto_xy(const lv_draw_buf_t *buffer, uint32_t x, uint32_t y);
void lv_obj_get_coords(const lv_obj_t *object, lv_area_t *at);
void lv_area_move(lv_area_t *area, int32_t x, int32_t y);
void lv_obj_invalidate_area(const lv_obj_t *object, const lv_area_t *area);
lv_timer_t *lv_timer_create(lv_timer_cb_t callback, uint32_t period_ms, void *user_data);
void *lv_timer_get_user_data(lv_timer_t *timer);
void lv_timer_delete(lv_timer_t *timer);

#endif
