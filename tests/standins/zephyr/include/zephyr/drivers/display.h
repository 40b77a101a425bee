/*
 * display.h - stands for Zephyr's display interface, that of 4.4; with STANDIN_BEFORE_4_4, the older name of a format.
 */
#ifndef ZEPHYR_DISPLAY_H
#define ZEPHYR_DISPLAY_H

#include <zephyr/device.h>

enum display_pixel_format {
    PIXEL_FORMAT_RGB_565 = 1 << 4,
#ifdef STANDIN_BEFORE_4_4
    PIXEL_FORMAT_BGR_565 = 1 << 5
#else
#define PANEL_PIXEL_FORMAT_RGB_565X (1 << 5) /* for devicetrees */
    PIXEL_FORMAT_RGB_565X = 1 << 5
#endif
};

enum display_orientation {
    DISPLAY_ORIENTATION_NORMAL
};

struct display_capabilities {
    uint16_t x_resolution, y_resolution;
    uint32_t supported_pixel_formats, screen_info;
    enum display_pixel_format current_pixel_format;
    enum display_orientation current_orientation;
};

struct display_buffer_descriptor {
    uint32_t buf_size;
    uint16_t width, height, pitch;
    bool frame_incomplete;
};

int display_write(const struct device *device, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor *descriptor, const void *pixels);
void display_get_capabilities(const struct device *device, struct display_capabilities *caps);
int display_blanking_off(const struct device *device);

#endif
