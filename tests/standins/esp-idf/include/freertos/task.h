/*
 * task.h - stands for FreeRTOS's tasks: vTaskDelay(), with a tick of one millisecond.
 */
#ifndef TASK_H
#define TASK_H

#include "FreeRTOS.h"

static inline void vTaskDelay(TickType_t ticks)
{
    wire_number('T', ticks * 1000u);
}

#endif
