/*
 * esp_log.h - stands for ESP-IDF's log, which is the standard error here.
 */
#ifndef ESP_LOG_H
#define ESP_LOG_H

#include <stdio.h>

#define ESP_LOGI(tag, format, ...) fprintf(stderr, "%s: " format "\n", tag, __VA_ARGS__)

#endif
