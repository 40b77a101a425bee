/*
 * controller_ssd1322.c - the simulated SSD1322: 16 levels, four pixels per column address.
 *
 * Parameters and pixels come with D/C high. Remap (A0, two bytes), as public drivers
 * use it upright (06 11) and upside down (14 11): bit 1 counts segments from the last,
 * bit 2 gives an address's first nibble to the segment that comes first, bit 4 counts
 * COM lines from the last; bit 4 of the second byte pairs COM lines (dual COM).
 */
#include "controller.h"

#define REMAP_VERTICAL 0x01
#define REMAP_COLUMN 0x02
#define REMAP_NIBBLE 0x04
#define REMAP_COM 0x10

static void defaults(struct sheen_sim_controller *controller)
{
    const struct sheen_sim_module *module = controller->module;

    controller->on = controller->scan = controller->com_remap = 0;
    controller->mode = 2; /* A6 */
    controller->row_offset = controller->start_line = 0;
    controller->multiplex = (uint8_t)(module->ram_h - 1);
    controller->x0 = controller->y0 = 0;
    controller->x1 = (uint16_t)(module->ram_w / 4 - 1);
    controller->y1 = (uint16_t)(module->ram_h - 1);
    sheen_sim_window_start(controller);
}

static void lock(struct sheen_sim_controller *controller)
{
    if (controller->params[0] != 0x12)
        sheen_sim_complain(controller, "command lock 0x%02X", controller->params[0]);
}

static void remap(struct sheen_sim_controller *controller)
{
    controller->scan = controller->params[0];
    controller->com_remap = (controller->scan & REMAP_COM) != 0;
    if ((controller->scan & 0xE8) || (controller->params[1] & ~0x10) != 0x01)
        sheen_sim_complain(controller, "remap 0x%02X 0x%02X", controller->params[0], controller->params[1]);
}

static void start_line(struct sheen_sim_controller *controller)
{
    controller->start_line = controller->params[0] & 127;
}

static void row_offset(struct sheen_sim_controller *controller)
{
    controller->row_offset = controller->params[0] & 127;
}

static void multiplex(struct sheen_sim_controller *controller)
{
    if (controller->params[0] < 15 || controller->params[0] > 127)
        sheen_sim_complain(controller, "multiplex ratio %u", controller->params[0] + 1u);
    controller->multiplex = controller->params[0] & 127;
}

/* Begins picture data at the present address. */
static void write_ram(struct sheen_sim_controller *controller)
{
    controller->streaming = 1;
}

/* Stores nibble i (0..3, in the order of arrival) of a column address at its segment. */
static void store(struct sheen_sim_controller *controller, unsigned i, unsigned level)
{
    unsigned position = 4u * controller->x + (controller->scan & REMAP_NIBBLE ? i : 3 - i);

    sheen_sim_store(controller, controller->scan & REMAP_COLUMN ? controller->module->ram_w - 1u - position : position,
                    controller->y, (uint16_t)level);
}

static void pixels(struct sheen_sim_controller *controller, uint8_t byte)
{
    unsigned first = 2u * controller->half_set;

    sheen_sim_check_window(controller, controller->module->ram_w / 4u, controller->module->ram_h);
    controller->rectangles -= first && controller->x == controller->x0 && controller->y == controller->y0;
    store(controller, first, byte >> 4);
    store(controller, first + 1, byte & 15);
    controller->half_set ^= 1;
    if (!controller->half_set)
        sheen_sim_next_address(controller, controller->scan & REMAP_VERTICAL);
}

static void stream_end(struct sheen_sim_controller *controller)
{
    if (controller->half_set)
        sheen_sim_complain(controller, "half a column before command");
}

/* A4 dark, A5 all on, A6 the RAM, A7 its complement. */
static uint16_t shown(const struct sheen_sim_controller *controller, unsigned segment, unsigned com)
{
    int row = sheen_sim_com_row(controller, com, controller->multiplex);

    if (!controller->on || row < 0 || controller->mode == 0)
        return 0;
    if (controller->mode == 1)
        return 15;
    uint16_t level = controller->ram[(size_t)row * controller->module->ram_w + segment];
    return controller->mode == 3 ? (uint16_t)(15 - level) : level;
}

static const struct sheen_sim_command commands[] = {
    {0x15, 0x15, 2, sheen_sim_set_columns},
    {0x5C, 0x5C, 0, write_ram},
    {0x75, 0x75, 2, sheen_sim_set_rows},
    {0xA0, 0xA0, 2, remap},
    {0xA1, 0xA1, 1, start_line},
    {0xA2, 0xA2, 1, row_offset},
    {0xA4, 0xA7, 0, sheen_sim_set_mode},
    {0xAE, 0xAF, 0, sheen_sim_set_on},
    {0xC1, 0xC1, 1, sheen_sim_set_brightness},
    {0xCA, 0xCA, 1, multiplex},
    {0xFD, 0xFD, 1, lock},
};

/* Supply, clocks, grey table; A9 ends the partial display. */
static const struct sheen_sim_command vendor[] = {
    {0x00, 0x00, 0, NULL}, {0xA9, 0xA9, 0, NULL}, {0xAB, 0xAB, 1, NULL},  {0xB1, 0xB1, 1, NULL}, {0xB3, 0xB3, 1, NULL},
    {0xB4, 0xB4, 2, NULL}, {0xB5, 0xB6, 1, NULL}, {0xB8, 0xB8, 15, NULL}, {0xB9, 0xB9, 0, NULL}, {0xBB, 0xBB, 1, NULL},
    {0xBE, 0xBE, 1, NULL}, {0xC7, 0xC7, 1, NULL}, {0xD1, 0xD1, 2, NULL},
};

/* Reset pulse: 2 us, which u8g2 has from the data sheet; the same wait after it. */
const struct sheen_sim_chip sheen_sim_chip_ssd1322 = {.name = "SSD1322",
                                                      .commands = commands,
                                                      .command_count = sizeof commands / sizeof commands[0],
                                                      .vendor = vendor,
                                                      .vendor_count = sizeof vendor / sizeof vendor[0],
                                                      .defaults = defaults,
                                                      .pixels = pixels,
                                                      .stream_end = stream_end,
                                                      .shown = shown,
                                                      .max_level = 15,
                                                      .reset_low_us = 2,
                                                      .reset_us = 2};
