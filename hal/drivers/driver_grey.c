/*
 * driver_grey.c - 16 grey levels, two pixels per byte: SSD0323, SSD1325, SSD1327; and SSD1322.
 *
 * What is sent, one call of the bus per line:
 *
 *   15 c0 c1         columns, ends inclusive, 2 px per address; on the SSD1322 4 px
 *   75 r0 r1         rows
 *   high|low ...     pixels from the window's top left, left pixel in the high nibble
 *
 * Parameters are sent with D/C low, like their commands, and pixels have no command.
 * On the SSD1322 parameters are sent with D/C high, and pixels follow command 5C.
 *
 * Setting the columns or rows moves the RAM address to the window's start, and filling
 * the window returns it there (SSD1325 data sheet, "Set Column Address" and "Set Row
 * Address"): pixels for the same window again need no command at all.
 *
 * The controller's remap is always that of the upright module; for other orientations
 * the driver rearranges the pixels.
 */
#include "driver.h"

#define SET_COLUMN 0x15
#define WRITE_RAM 0x5C
#define SET_ROW 0x75
#define SET_REMAP 0xA0
#define DISPLAY_OFF 0xAE
#define DISPLAY_ON 0xAF

static void grey_init(struct sheen_panel *panel)
{
    const struct sheen_panel_driver *driver = panel->record->driver;
    int low = driver->write_command == 0; /* parameters are sent with D/C low */

    sheen_panel_reset(panel);
    if (low)
        sheen_panel_resynchronise(panel, DISPLAY_OFF);
    sheen_panel_steps(panel);
    driver->command(panel, SET_REMAP, panel->record->scan, low ? 1 : 2);
    driver->command(panel, DISPLAY_ON, NULL, 0);
}

/* Sends pixels in the controller's order; they may stay under way. */
static void launch(struct sheen_panel *panel, const uint8_t *bytes, size_t count)
{
    const uint8_t *write = &panel->record->driver->write_command;

    sheen_panel_launch(panel, write, *write != 0, bytes, count);
}

/* The 4 bits of the rectangle's pixel number `index`. */
static unsigned nibble(const uint8_t *pixels, int32_t index)
{
    unsigned byte = pixels[(uint32_t)index / 2];

    return index & 1 ? byte & 15u : byte >> 4;
}

/* Sends the rectangle in the glass's order, one pack buffer at a time; the last buffer may stay under way. */
static void send_turned(struct sheen_panel *panel, const struct sheen_turn *turn, const uint8_t *pixels)
{
    unsigned used = 0;

    for (int16_t row = 0; row < turn->h; row++) {
        int32_t index = turn->start + row * turn->down;

        for (int16_t column = 0; column < turn->w; column += 2, index += 2 * turn->right) {
            if (used == sizeof panel->pack) {
                launch(panel, panel->pack, used);
                sheen_panel_await(panel);
                used = 0;
            }
            panel->pack[used++] = (uint8_t)(nibble(pixels, index) << 4 | nibble(pixels, index + turn->right));
        }
    }
    launch(panel, panel->pack, used);
}

static void grey_push(struct sheen_panel *panel, const struct sheen_rect *rect, const uint8_t *pixels)
{
    const struct sheen_panel_record *record = panel->record;
    unsigned shift = record->driver->align / 2u; /* 1 or 2: a column address is 2 or 4 px */
    struct sheen_turn turn;

    sheen_turn_of(panel, rect, &turn);
    unsigned column = (record->gap_x + (unsigned)turn.x) >> shift, row = record->gap_y + (unsigned)turn.y;
    sheen_panel_set_window(panel, 0, SET_COLUMN, column, column + ((unsigned)turn.w >> shift) - 1);
    sheen_panel_set_window(panel, 1, SET_ROW, row, row + (unsigned)turn.h - 1);
    if (panel->orientation == 0) /* the core's order is the controller's */
        launch(panel, pixels, (size_t)turn.w * (size_t)turn.h / 2);
    else
        send_turned(panel, &turn, pixels);
}

const struct sheen_panel_driver sheen_driver_grey = {.init = grey_init,
                                                     .push = grey_push,
                                                     .command = sheen_panel_low_command,
                                                     .reset_command = -1,
                                                     .off = {DISPLAY_OFF},
                                                     .off_count = 1,
                                                     .pixel = SHEEN_GREY16,
                                                     .align = 2};

const struct sheen_panel_driver sheen_driver_ssd1322 = {.init = grey_init,
                                                        .push = grey_push,
                                                        .command = sheen_panel_command,
                                                        .reset_command = -1,
                                                        .off = {DISPLAY_OFF},
                                                        .off_count = 1,
                                                        .write_command = WRITE_RAM,
                                                        .pixel = SHEEN_GREY16,
                                                        .align = 4};
