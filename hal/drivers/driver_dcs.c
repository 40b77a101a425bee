/*
 * driver_dcs.c - the driver of all MIPI-DCS colour panels on 4-wire SPI; modules differ by their records.
 *
 * What is sent, one call of the bus per line, D/C low for the first byte:
 *
 *   2A  x0h x0l x1h x1l     CASET, columns, ends inclusive
 *   2B  y0h y0l y1h y1l     RASET, rows
 *   2C  hi lo hi lo ...     RAMWR, from the window's top left, RGB565 high byte first;
 *                           or, if the record has bits_18, 3 bytes per pixel whose upper 6
 *                           bits count, a few pixels per call: 2C, then 3C (RAMWRC)
 *
 * Columns and rows are those of the picture, because MADCTL turns them; so the offset
 * of the glass depends on the orientation. CASET and RASET are sent only if they differ
 * from the last ones. Command codes: MIPI Alliance, Display Command Set 1.3, chapter 6.
 */
#include "driver.h"

#define SWRESET 0x01
#define SLPIN 0x10
#define NORON 0x13
#define INVOFF 0x20
#define INVON 0x21
#define DISPOFF 0x28
#define DISPON 0x29
#define CASET 0x2A
#define RASET 0x2B
#define RAMWR 0x2C
#define RAMWRC 0x3C
#define TEON 0x35
#define MADCTL 0x36
#define WRCTRLD 0x53

#define WRCTRLD_ON 0x2C /* brightness block, dimming and backlight on */

#define MADCTL_BGR 0x08 /* sub-pixels of the glass are blue, green, red; SHEEN_SCAN_ are its other bits */

/* MADCTL without the colour order. A mirrored picture's x counts from the other end of its RAM axis. */
static uint8_t dcs_scan_of(const struct sheen_panel *panel)
{
    uint8_t scan = panel->record->scan[panel->orientation & 3];

    if (panel->orientation & 4)
        scan ^= scan & SHEEN_SCAN_MV ? SHEEN_SCAN_MY : SHEEN_SCAN_MX;
    return scan;
}

static void dcs_orient(struct sheen_panel *panel)
{
    uint8_t madctl = (uint8_t)(dcs_scan_of(panel) | (panel->record->bgr ? MADCTL_BGR : 0));

    sheen_panel_command(panel, MADCTL, &madctl, 1);
}

static void dcs_init(struct sheen_panel *panel)
{
    sheen_panel_reset(panel);
    sheen_panel_steps(panel);
    dcs_orient(panel);
    sheen_panel_command(panel, panel->record->inverted ? INVON : INVOFF, NULL, 0);
    sheen_panel_command(panel, NORON, NULL, 0);
    sheen_panel_command(panel, DISPON, NULL, 0);
}

/*
 * RAM pixels before the glass on an axis: the gap if the axis counts upwards, the
 * RAM's remainder beyond the glass if it counts downwards.
 */
static unsigned offset_of(unsigned ram, unsigned glass, unsigned gap, int downwards)
{
    return downwards ? ram - glass - gap : gap;
}

/* Sets one axis (0 x, 1 y) of the window to first..end - 1, in the picture's coordinates. */
static void set_axis(struct sheen_panel *panel, unsigned axis, int first, int end)
{
    const struct sheen_panel_record *record = panel->record;
    uint8_t scan = dcs_scan_of(panel);
    unsigned offset = axis == !(scan & SHEEN_SCAN_MV) /* the axis selects RAM rows */
                          ? offset_of(record->ram_h, record->glass_h, record->gap_y, scan & SHEEN_SCAN_MY)
                          : offset_of(record->ram_w, record->glass_w, record->gap_x, scan & SHEEN_SCAN_MX);
    uint32_t window = ((unsigned)first + offset) << 16 | ((unsigned)end + offset - 1);
    uint8_t data[4] = {(uint8_t)(window >> 24), (uint8_t)(window >> 16), (uint8_t)(window >> 8), (uint8_t)window};

    if (sheen_panel_window_update(panel, axis, window))
        sheen_panel_command(panel, axis ? RASET : CASET, data, sizeof data);
}

/* RGB565 to three bytes whose upper 6 bits count. 5 bits become 6 by repeating the high ones, so white stays white. */
static void expand(uint8_t *to, const uint8_t *pixel)
{
    unsigned g = (pixel[0] & 7u) << 3 | pixel[1] >> 5, b = pixel[1] & 31u;

    to[0] = (uint8_t)((pixel[0] & 0xF8) | pixel[0] >> 5);
    to[1] = (uint8_t)(g << 2 | g >> 4);
    to[2] = (uint8_t)(b << 3 | b >> 2);
}

/* Sends pixels as 3 bytes each, one pack buffer at a time; the last buffer may stay under way. */
static void send_18(struct sheen_panel *panel, const uint8_t *pixels, const uint8_t *end)
{
    for (uint8_t command = RAMWR; pixels != end; command = RAMWRC) {
        unsigned used = 0;

        sheen_panel_await(panel);
        for (; pixels != end && used < sizeof panel->pack / 3 * 3; pixels += 2, used += 3)
            expand(&panel->pack[used], pixels);
        sheen_panel_launch(panel, &command, 1, panel->pack, used);
    }
}

static void dcs_push(struct sheen_panel *panel, const struct sheen_rect *rect, const uint8_t *pixels)
{
    const uint8_t write = RAMWR;
    size_t bytes = (size_t)(rect->x1 - rect->x0) * (size_t)(rect->y1 - rect->y0) * 2;

    set_axis(panel, 0, rect->x0, rect->x1);
    set_axis(panel, 1, rect->y0, rect->y1);
    if (panel->record->bits_18)
        send_18(panel, pixels, pixels + bytes);
    else
        sheen_panel_launch(panel, &write, 1, pixels, bytes);
}

const struct sheen_panel_driver sheen_driver_dcs = {.init = dcs_init,
                                                    .orient = dcs_orient,
                                                    .push = dcs_push,
                                                    .command = sheen_panel_command,
                                                    .reset_command = SWRESET,
                                                    .off = {DISPOFF, SLPIN},
                                                    .off_count = 2,
                                                    .tearing_command = TEON,
                                                    .brightness_on = {WRCTRLD, WRCTRLD_ON},
                                                    .pixel = SHEEN_RGB565_BE,
                                                    .align = 1};
