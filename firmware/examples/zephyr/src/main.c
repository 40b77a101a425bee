/*
 * main.c - sheen with Zephyr: draws with display_write() on whatever display the board's devicetree chooses.
 *
 * sheen is a Zephyr module (zephyr/module.yml). Set CONFIG_SHEEN=y and CONFIG_DISPLAY=y.
 */
#include <zephyr/device.h>
#include <zephyr/drivers/display.h>

#include "example.h"

#ifndef PANEL_PIXEL_FORMAT_RGB_565X /* before Zephyr 4.4 */
#define PIXEL_FORMAT_RGB_565X PIXEL_FORMAT_BGR_565
#endif

static int push(void *ctx, struct sheen_rect r, const void *pixels)
{
    const struct display_buffer_descriptor descriptor = {
        .buf_size = (uint32_t)((r.x1 - r.x0) * (r.y1 - r.y0) * 2),
        .width = (uint16_t)(r.x1 - r.x0),
        .height = (uint16_t)(r.y1 - r.y0),
        .pitch = (uint16_t)(r.x1 - r.x0),
    };

    return display_write(ctx, (uint16_t)r.x0, (uint16_t)r.y0, &descriptor, pixels) < 0 ? SHEEN_ERR_BUS : SHEEN_OK;
}

int main(void)
{
    const struct device *display = DEVICE_DT_GET(DT_CHOSEN(zephyr_display));
    struct display_capabilities caps;
    struct sheen_target target = {.push = push};
    struct sheen_frame *frame;
    int error;

    if (!device_is_ready(display))
        return SHEEN_ERR_BUS;
    display_get_capabilities(display, &caps);
    target.ctx = (void *)display;
    target.width = caps.x_resolution;
    target.height = caps.y_resolution;
    /* Before Zephyr 4.3, most drivers exchange the two formats: if the colours are wrong, exchange them here. */
    if (caps.current_pixel_format == PIXEL_FORMAT_RGB_565)
        target.pixel = SHEEN_RGB565_LE;
    else if (caps.current_pixel_format == PIXEL_FORMAT_RGB_565X)
        target.pixel = SHEEN_RGB565_BE;
    else
        return SHEEN_ERR_UNSUPPORTED;
    error = example_init(&frame, &target);
    for (unsigned i = 0; !error && i < EXAMPLE_FRAMES; i++) {
        error = example_draw(frame, i);
        if (i == 0)
            (void)display_blanking_off(display); /* fails if the driver cannot blank: then nothing was blanked */
    }
    return error;
}
