/*
 * driver_dcs.c - every MIPI-DCS colour panel on a 4-wire SPI: one driver, a record a module.
 *
 * On the wire, D/C low for the first byte of each line:
 *
 *   2A  x0h x0l x1h x1l     CASET, columns, ends inclusive
 *   2B  y0h y0l y1h y1l     RASET, rows
 *   2C  hi lo hi lo ...     RAMWR, from the window's top left, RGB565 high byte first
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
#define TEON 0x35
#define MADCTL 0x36

#define MADCTL_MY 0x80  /* rows downwards from the last */
#define MADCTL_MX 0x40  /* columns likewise */
#define MADCTL_MV 0x20  /* the picture's x runs along RAM rows */
#define MADCTL_BGR 0x08 /* sub-pixels of the glass are blue, green, red */

/* MADCTL without the colour order. Mirrored left to right: the other end of the axis that x runs along. */
static uint8_t scan_of(const struct sheen_panel *panel)
{
    uint8_t scan = panel->record->scan[panel->orientation & 3];

    if (panel->orientation & 4)
        scan ^= scan & MADCTL_MV ? MADCTL_MY : MADCTL_MX;
    return scan;
}

static int init(struct sheen_panel *panel)
{
    const struct sheen_panel_record *record = panel->record;
    uint8_t madctl = (uint8_t)(scan_of(panel) | (record->bgr ? MADCTL_BGR : 0));
    int error = sheen_panel_reset(panel);

    if (error == SHEEN_OK)
        error = sheen_panel_steps(panel, SHEEN_DATA);
    if (error == SHEEN_OK)
        error = sheen_panel_command(panel, MADCTL, &madctl, 1);
    if (error == SHEEN_OK)
        error = sheen_panel_command(panel, record->inverted ? INVON : INVOFF, NULL, 0);
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

static int push(struct sheen_panel *panel, struct sheen_rect rect, const uint8_t *pixels)
{
    const struct sheen_panel_record *record = panel->record;
    uint8_t scan = scan_of(panel);
    uint16_t columns = sheen_panel_offset(record->ram_w, record->glass_w, record->gap_x, scan & MADCTL_MX);
    uint16_t rows = sheen_panel_offset(record->ram_h, record->glass_h, record->gap_y, scan & MADCTL_MY);
    int swap = scan & MADCTL_MV;
    size_t count = (size_t)(rect.x1 - rect.x0) * (size_t)(rect.y1 - rect.y0) * 2;
    int error = set_axis(panel, 0, swap ? rows : columns, rect.x0, rect.x1 - 1);

    if (error == SHEEN_OK)
        error = set_axis(panel, 1, swap ? columns : rows, rect.y0, rect.y1 - 1);
    if (error == SHEEN_OK)
        error = sheen_panel_command(panel, RAMWR, NULL, 0);
    return error < 0 ? error : sheen_panel_launch(panel, SHEEN_DATA, pixels, count);
}

const struct sheen_panel_driver sheen_driver_dcs = {.init = init,
                                                    .push = push,
                                                    .reset_command = SWRESET,
                                                    .off = {DISPOFF, SLPIN},
                                                    .off_count = 2,
                                                    .tearing_command = TEON,
                                                    .align_x = 1,
                                                    .align_y = 1};
