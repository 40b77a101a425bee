/*
 * semphr.h - stands for FreeRTOS's binary semaphore. Taking it completes the transfer under way, which calls the
 * interrupt's callback.
 */
#ifndef SEMPHR_H
#define SEMPHR_H

#include "FreeRTOS.h"
#include "esp_lcd_panel_io.h"

typedef int *SemaphoreHandle_t;

static inline SemaphoreHandle_t xSemaphoreCreateBinary(void)
{
    static int given;

    return &given;
}

static inline void xSemaphoreGiveFromISR(SemaphoreHandle_t semaphore, BaseType_t *woken)
{
    *semaphore = 1;
    *woken = pdTRUE;
}

static inline BaseType_t xSemaphoreTake(SemaphoreHandle_t semaphore, TickType_t ticks)
{
    (void)ticks;
    if (wire_flying) {
        wire_land();
        standin_io.on_color_trans_done(NULL, NULL, standin_io.user_ctx);
    }
    int was = *semaphore;

    *semaphore = 0;
    return was ? pdTRUE : pdFALSE;
}

#endif
