/*
 * display.h - stands for Zephyr's display interface.
 */
#ifndef ZEPHYR_DISPLAY_H
#define ZEPHYR_DISPLAY_H

#include <zephyr/device.h>

enum display_pixel_format {
    PIXEL_FORMAT_RGB_565 = 1 << 4,
    PIXEL_FORMAT_RGB_565X = 1 << 5
};

struct display_capabilities {
    uint16_t x_resolution, y_resolution;
    enum display_pixel_format current_pixel_format;
};

struct display_buffer_descriptor {
    uint32_t buf_size;
    uint16_t width, height, pitch;
    bool frame_incomplete;
};

int display_write(const struct device *device, uint16_t x, uint16_t y,
                  const struct display_buffer_descriptor *descriptor, const void *pixels);
void display_get_capabilities(const struct device *device, struct display_capabilities *caps);
int display_blanking_off(const struct device *device);

#endif
