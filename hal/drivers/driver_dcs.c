/*
 * driver_dcs.c - every MIPI-DCS colour panel on a 4-wire SPI: one driver, a record a module.
 *
 * On the wire, a call of the bus a line, D/C low for its first byte:
 *
 *   2A  x0h x0l x1h x1l     CASET, columns, ends inclusive
 *   2B  y0h y0l y1h y1l     RASET, rows
 *   2C  hi lo hi lo ...     RAMWR, from the window's top left, RGB565 high byte first;
 *                           or, where a record has bits_18, 3 bytes a pixel of which the
 *                           upper 6 bits count, a few at a time: the rest by 3C, RAMWRC
 *
 * Columns and rows are the picture's: MADCTL turns them, so the offset of the
 * glass turns too. CASET and RASET are sent where they differ from the last.
 * Command codes: MIPI Alliance, Display Command Set 1.3, chapter 6.
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

#define MADCTL_BGR 0x08 /* beside scan's bits: sub-pixels of the glass are blue, green, red */

/* MADCTL without the colour order. Mirrored left to right: the other end of the axis that x runs along. */
static uint8_t dcs_scan_of(const struct sheen_panel *panel)
{
    uint8_t scan = panel->record->scan[panel->orientation & 3];

    if (panel->orientation & 4)
        scan ^= scan & SHEEN_SCAN_MV ? SHEEN_SCAN_MY : SHEEN_SCAN_MX;
    return scan;
}

static int dcs_orient(struct sheen_panel *panel)
{
    uint8_t madctl = (uint8_t)(dcs_scan_of(panel) | (panel->record->bgr ? MADCTL_BGR : 0));

    return sheen_panel_command(panel, MADCTL, &madctl, 1);
}

static int dcs_init(struct sheen_panel *panel)
{
    int error = sheen_panel_reset(panel);

    if (error == SHEEN_OK)
        error = sheen_panel_steps(panel);
    if (error == SHEEN_OK)
        error = dcs_orient(panel);
    if (error == SHEEN_OK)
        error = sheen_panel_command(panel, panel->record->inverted ? INVON : INVOFF, NULL, 0);
    if (error == SHEEN_OK)
        error = sheen_panel_command(panel, NORON, NULL, 0);
    return error < 0 ? error : sheen_panel_command(panel, DISPON, NULL, 0);
}

/* An axis (0 x, 1 y) of the window, first..last in the picture's own coordinates. */
static int set_axis(struct sheen_panel *panel, unsigned axis, unsigned offset, int first, int last)
{
    unsigned start = (unsigned)first + offset, end = (unsigned)last + offset;
    uint8_t data[4] = {(uint8_t)(start >> 8), (uint8_t)start, (uint8_t)(end >> 8), (uint8_t)end};

    if (!sheen_panel_window_moves(panel, axis, start, end))
        return SHEEN_OK;
    return sheen_panel_command(panel, axis ? RASET : CASET, data, sizeof data);
}

/* 5 or 6 bits to the upper 6 of a byte: the low bits repeat the high ones, so that white stays white. */
static uint8_t *expand(uint8_t *to, const uint8_t *pixel)
{
    unsigned v = (unsigned)pixel[0] << 8 | pixel[1], r = v >> 11, g = v >> 5 & 63, b = v & 31;

    *to++ = (uint8_t)(r << 3 | r >> 2);
    *to++ = (uint8_t)(g << 2 | g >> 4);
    *to++ = (uint8_t)(b << 3 | b >> 2);
    return to;
}

/* Pixels as 3 bytes each, a pack buffer at a time; the last one flies. */
static int send_18(struct sheen_panel *panel, const uint8_t *pixels, size_t count)
{
    uint8_t command = RAMWR;
    int error = SHEEN_OK;

    while (count && error == SHEEN_OK) {
        size_t part = count < sizeof panel->pack / 3 ? count : sizeof panel->pack / 3;
        uint8_t *end = panel->pack;

        error = sheen_panel_landed(panel);
        for (size_t i = 0; i < part; i++, pixels += 2)
            end = expand(end, pixels);
        if (error == SHEEN_OK)
            error = sheen_panel_launch(panel, &command, 1, panel->pack, 3 * part);
        command = RAMWRC;
        count -= part;
    }
    return error;
}

static int dcs_push(struct sheen_panel *panel, struct sheen_rect rect, const uint8_t *pixels)
{
    const struct sheen_panel_record *record = panel->record;
    uint8_t scan = dcs_scan_of(panel);
    uint16_t columns = sheen_panel_offset(record->ram_w, record->glass_w, record->gap_x, scan & SHEEN_SCAN_MX);
    uint16_t rows = sheen_panel_offset(record->ram_h, record->glass_h, record->gap_y, scan & SHEEN_SCAN_MY);
    const uint8_t write = RAMWR;
    int swap = scan & SHEEN_SCAN_MV;
    size_t count = (size_t)(rect.x1 - rect.x0) * (size_t)(rect.y1 - rect.y0);
    int error = set_axis(panel, 0, swap ? rows : columns, rect.x0, rect.x1 - 1);

    if (error == SHEEN_OK)
        error = set_axis(panel, 1, swap ? columns : rows, rect.y0, rect.y1 - 1);
    if (error < 0)
        return error;
    return record->bits_18 ? send_18(panel, pixels, count) : sheen_panel_launch(panel, &write, 1, pixels, 2 * count);
}

const struct sheen_panel_driver sheen_driver_dcs = {.init = dcs_init,
                                                    .orient = dcs_orient,
                                                    .push = dcs_push,
                                                    .reset_command = SWRESET,
                                                    .off = {DISPOFF, SLPIN},
                                                    .off_count = 2,
                                                    .tearing_command = TEON,
                                                    .brightness_on = {WRCTRLD, WRCTRLD_ON},
                                                    .align_x = 1,
                                                    .align_y = 1};
