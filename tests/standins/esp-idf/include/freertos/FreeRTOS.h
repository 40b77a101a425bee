/*
 * FreeRTOS.h - stands for FreeRTOS's types, with a tick of one millisecond.
 */
#ifndef FREERTOS_H
#define FREERTOS_H

#include "wire.h"

typedef int BaseType_t;
typedef uint32_t TickType_t;
#define pdTRUE 1
#define pdFALSE 0
#define pdMS_TO_TICKS(ms) ((TickType_t)(ms))

#endif
