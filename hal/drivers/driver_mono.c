/*
 * driver_mono.c - black and white in pages: SSD1306 and SH1106.
 *
 * A byte is a column of 8 pixels, the top one in bit 0; a page is a row of bytes.
 * Commands and their parameters are sent with D/C low, pixels with D/C high:
 *
 *   SSD1306   21 c0 c1   columns, 22 p0 p1   pages (ends inclusive), then bytes
 *   SH1106    B0+page, 00+low nibble, 10+high nibble of the column: once per page
 *
 * The controllers always stay set up for the upright module (A1 and C8 of the init
 * table); for other orientations the driver rearranges the pixels. When a window is
 * full, the SSD1306 returns to its start (data sheet, "Horizontal addressing mode"):
 * pixels for the same window again need no command.
 */
#include "driver.h"

#define COLUMN_ADDRESS 0x21
#define SET_PAGE 0x22
#define COLUMN_LOW 0x00
#define COLUMN_HIGH 0x10
#define DISPLAY_OFF 0xAE
#define DISPLAY_ON 0xAF
#define PAGE_START 0xB0

static void mono_init(struct sheen_panel *panel)
{
    sheen_panel_reset(panel);
    sheen_panel_resynchronise(panel, DISPLAY_OFF);
    sheen_panel_steps(panel);
    sheen_panel_low_command(panel, DISPLAY_ON, NULL, 0);
}

/* The byte of 8 pixels from number `index` of the rectangle on, `down` apart; negative steps are modulo 2^32. */
static uint8_t column_of_8(const uint8_t *pixels, uint32_t index, uint32_t down)
{
    unsigned byte = 0;

    for (unsigned bit = 0; bit < 8; bit++, index += down)
        byte |= (unsigned)(pixels[index / 8] >> (7 - index % 8) & 1) << bit;
    return (uint8_t)byte;
}

/* Sends the bytes of one page, one pack buffer at a time; the last buffer may stay under way. */
static void send_page(struct sheen_panel *panel, const struct sheen_turn *turn, const uint8_t *pixels, int16_t row)
{
    int32_t index = turn->start + row * turn->down;
    unsigned used = 0;

    sheen_panel_await(panel);
    for (int16_t column = 0; column < turn->w; column++, index += turn->right) {
        if (used == sizeof panel->pack) {
            sheen_panel_launch(panel, NULL, 0, panel->pack, used);
            sheen_panel_await(panel);
            used = 0;
        }
        panel->pack[used++] = column_of_8(pixels, (uint32_t)index, (uint32_t)turn->down);
    }
    sheen_panel_launch(panel, NULL, 0, panel->pack, used);
}

static void push_ssd1306(struct sheen_panel *panel, const struct sheen_rect *rect, const uint8_t *pixels)
{
    const struct sheen_panel_record *record = panel->record;
    struct sheen_turn turn;

    sheen_turn_of(panel, rect, &turn);
    unsigned column = record->gap_x + (unsigned)turn.x, page = (record->gap_y + (unsigned)turn.y) / 8;
    sheen_panel_set_window(panel, 0, COLUMN_ADDRESS, column, column + (unsigned)turn.w - 1);
    sheen_panel_set_window(panel, 1, SET_PAGE, page, page + (unsigned)turn.h / 8 - 1);
    for (int16_t row = 0; row < turn.h; row = (int16_t)(row + 8))
        send_page(panel, &turn, pixels, row);
}

static void push_sh1106(struct sheen_panel *panel, const struct sheen_rect *rect, const uint8_t *pixels)
{
    const struct sheen_panel_record *record = panel->record;
    struct sheen_turn turn;

    sheen_turn_of(panel, rect, &turn);
    unsigned column = record->gap_x + (unsigned)turn.x, page = (record->gap_y + (unsigned)turn.y) / 8;
    for (int16_t row = 0; row < turn.h; row = (int16_t)(row + 8), page++) {
        const uint8_t place[3] = {(uint8_t)(PAGE_START | page), (uint8_t)(COLUMN_LOW | (column & 15)),
                                  (uint8_t)(COLUMN_HIGH | column >> 4)};

        sheen_panel_await(panel);
        sheen_panel_launch(panel, place, sizeof place, NULL, 0);
        send_page(panel, &turn, pixels, row);
    }
}

const struct sheen_panel_driver sheen_driver_ssd1306 = {.init = mono_init,
                                                        .push = push_ssd1306,
                                                        .command = sheen_panel_low_command,
                                                        .reset_command = -1,
                                                        .off = {DISPLAY_OFF},
                                                        .off_count = 1,
                                                        .pixel = SHEEN_GREY2,
                                                        .align = 8};

const struct sheen_panel_driver sheen_driver_sh1106 = {.init = mono_init,
                                                       .push = push_sh1106,
                                                       .command = sheen_panel_low_command,
                                                       .reset_command = -1,
                                                       .off = {DISPLAY_OFF},
                                                       .off_count = 1,
                                                       .pixel = SHEEN_GREY2,
                                                       .align = 8};
