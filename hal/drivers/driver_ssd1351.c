/*
 * driver_ssd1351.c - the colour OLED SSD1351: RGB565, not DCS.
 *
 * What is sent, one call of the bus per line, D/C low for the first byte only:
 *
 *   15  x0 x1        columns, ends inclusive
 *   75  y0 y1        rows
 *   5C  hi lo ...    pixels, high byte first
 *
 * Columns and rows are the RAM's in every orientation. Remap bit 0 makes the RAM
 * address count rows first, so that in a quarter turn the picture's x is the row. 5C
 * does not move the address to the window's start, but filling the window does (data
 * sheet, 8.4 "Address increment"), and so do 15 and 75.
 */
#include "driver.h"

#define SET_COLUMN 0x15
#define WRITE_RAM 0x5C
#define SET_ROW 0x75
#define SET_REMAP 0xA0
#define SET_START_LINE 0xA1
#define DISPLAY_OFF 0xAE
#define DISPLAY_ON 0xAF

#define REMAP_VERTICAL 0x01 /* the address counts rows first */
#define REMAP_COLUMN 0x02   /* columns count from the last */
#define REMAP_CBA 0x04      /* sub-pixels are blue, green, red */
#define REMAP_COM 0x10      /* rows count from the last */

/* The remap byte of the orientation, without the colour order. */
static uint8_t ssd1351_scan_of(const struct sheen_panel *panel)
{
    uint8_t scan = panel->record->scan[panel->orientation & 3];

    if (panel->orientation & 4)
        scan ^= scan & REMAP_VERTICAL ? REMAP_COM : REMAP_COLUMN;
    return scan;
}

static void ssd1351_orient(struct sheen_panel *panel)
{
    const struct sheen_panel_record *record = panel->record;
    uint8_t scan = ssd1351_scan_of(panel), remap = (uint8_t)(scan | (record->bgr ? REMAP_CBA : 0));
    /*
     * Only the first glass_h rows of the RAM are behind the glass. If they are scanned
     * from the last, start line glass_h (mod 128) puts the RAM's row 0 at the glass's top.
     */
    uint8_t start_line = (uint8_t)(scan & REMAP_COM ? record->glass_h % record->ram_h : 0);

    sheen_panel_command(panel, SET_REMAP, &remap, 1);
    sheen_panel_command(panel, SET_START_LINE, &start_line, 1);
}

static void ssd1351_init(struct sheen_panel *panel)
{
    sheen_panel_reset(panel);
    sheen_panel_steps(panel);
    ssd1351_orient(panel);
    sheen_panel_command(panel, DISPLAY_ON, NULL, 0);
}

static void ssd1351_push(struct sheen_panel *panel, const struct sheen_rect *rect, const uint8_t *pixels)
{
    unsigned x_axis = ssd1351_scan_of(panel) & REMAP_VERTICAL; /* the picture's x selects: 0 columns, 1 rows */
    size_t count = (size_t)(rect->x1 - rect->x0) * (size_t)(rect->y1 - rect->y0) * 2;
    static const uint8_t set[2] = {SET_COLUMN, SET_ROW}, write = WRITE_RAM;

    sheen_panel_set_window(panel, x_axis, set[x_axis], (unsigned)rect->x0, (unsigned)rect->x1 - 1);
    sheen_panel_set_window(panel, !x_axis, set[!x_axis], (unsigned)rect->y0, (unsigned)rect->y1 - 1);
    sheen_panel_launch(panel, &write, 1, pixels, count);
}

const struct sheen_panel_driver sheen_driver_ssd1351 = {.init = ssd1351_init,
                                                        .orient = ssd1351_orient,
                                                        .push = ssd1351_push,
                                                        .command = sheen_panel_command,
                                                        .reset_command = -1,
                                                        .off = {DISPLAY_OFF},
                                                        .off_count = 1,
                                                        .pixel = SHEEN_RGB565_BE,
                                                        .align = 1};
