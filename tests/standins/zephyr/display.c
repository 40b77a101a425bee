/*
 * display.c - stands for a display under Zephyr: 240 x 240, with pixels in FORMAT. It is shown when main() ends, if
 * blanking is off by then.
 */
#include <stdio.h>
#include <string.h>

#include <zephyr/drivers/display.h>

const struct device standin_display = {"display"};
static uint8_t glass[240 * 240][2];
static int blanked = 1;

int display_write(const struct device *device, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor *d, const void *pixels)
{
    if (!device_is_ready(device) || d->pitch < d->width || x + d->width > 240 || y + d->height > 240 ||
        d->buf_size < (uint32_t)d->pitch * d->height * 2)
        return -22;
    for (unsigned row = 0; row < d->height; row++)
        memcpy(glass[(y + row) * 240 + x], (const uint8_t *)pixels + (size_t)row * d->pitch * 2, d->width * 2u);
    return 0;
}

void display_get_capabilities(const struct device *device, struct display_capabilities *caps)
{
    (void)device;
    *caps = (struct display_capabilities){240, 240, FORMAT, 0, FORMAT, DISPLAY_ORIENTATION_NORMAL};
}

int display_blanking_off(const struct device *device)
{
    (void)device;
    blanked = 0;
    return 0;
}

__attribute__((destructor)) static void standin_end(void)
{
    int low = FORMAT == PIXEL_FORMAT_RGB_565 ? 0 : 1;

    for (unsigned i = 0; i < 240 * 240 && !blanked; i++) { /* 565 values, low byte first */
        putchar(glass[i][low]);
        putchar(glass[i][1 - low]);
    }
    fflush(stdout);
}
