/*
 * controller_grey.c - simulated SSD0323, SSD1325 and SSD1327: 16 levels, two pixels per byte.
 *
 * Remap (A0), as the data sheets draw it: bit 0 counts the pairs of segments from the last, bit 1 gives the high nibble
 * to the lower segment of a pair, bit 2 makes the address run down the rows first, bit 4 counts COM lines from the
 * last.
 */
#include "controller.h"

static void defaults(struct sheen_sim_controller *controller)
{
    const struct sheen_sim_module *module = controller->module;

    controller->on = controller->scan = controller->com_remap = controller->mode = 0;
    controller->row_offset = controller->start_line = 0;
    controller->multiplex = (uint8_t)(module->ram_h - 1);
    controller->x0 = controller->y0 = 0;
    controller->x1 = (uint16_t)(module->ram_w / 2 - 1);
    controller->y1 = (uint16_t)(module->ram_h - 1);
    sheen_sim_window_start(controller);
}

static void remap(struct sheen_sim_controller *controller)
{
    controller->scan = controller->params[0];
    controller->com_remap = (controller->scan & 0x10) != 0;
    if (controller->scan & 0xA8)
        sheen_sim_complain(controller, "remap 0x%02X sets reserved bits", controller->scan);
}

static void start_line(struct sheen_sim_controller *controller)
{
    controller->start_line = controller->params[0];
}

static void row_offset(struct sheen_sim_controller *controller)
{
    controller->row_offset = controller->params[0];
}

static void multiplex(struct sheen_sim_controller *controller)
{
    if (controller->params[0] < 15 || controller->params[0] >= controller->module->ram_h)
        sheen_sim_complain(controller, "multiplex ratio %u", controller->params[0] + 1u);
    controller->multiplex = controller->params[0];
}

/* The segment of the high (0) or low (1) nibble of a byte column. */
static unsigned segment(const struct sheen_sim_controller *controller, unsigned column, unsigned low)
{
    unsigned pair = controller->scan & 1 ? controller->module->ram_w / 2u - 1 - column : column;

    return 2 * pair + (controller->scan & 2 ? low : !low);
}

/* The RAM holds one value per segment, placed by the column remap that is set when the byte is written. */
static void pixels(struct sheen_sim_controller *controller, uint8_t byte)
{
    sheen_sim_check_window(controller, controller->module->ram_w / 2u, controller->module->ram_h);
    sheen_sim_store(controller, segment(controller, controller->x, 0), controller->y, byte >> 4);
    sheen_sim_store(controller, segment(controller, controller->x, 1), controller->y, byte & 15);
    sheen_sim_next_address(controller, controller->scan & 4);
}

/* A4 shows the RAM, A5 all on, A6 all off, A7 the RAM's complement. */
static uint16_t shown(const struct sheen_sim_controller *controller, unsigned segment_line, unsigned com)
{
    const struct sheen_sim_module *module = controller->module;
    /* The SSD1327 counts a remapped COM from its multiplex ratio, the older two from their last line. */
    unsigned top = module->chip == &sheen_sim_chip_ssd1327 ? controller->multiplex : module->ram_h - 1u;
    int row = sheen_sim_com_row(controller, com, top);

    if (!controller->on || row < 0 || controller->mode == 2)
        return 0;
    if (controller->mode == 1)
        return 15;
    uint16_t level = controller->ram[(size_t)row * module->ram_w + segment_line];
    return controller->mode == 3 ? (uint16_t)(15 - level) : level;
}

static const struct sheen_sim_command commands[] = {
    {0x15, 0x15, 2, sheen_sim_set_columns},
    {0x75, 0x75, 2, sheen_sim_set_rows},
    {0xA0, 0xA0, 1, remap},
    {0xA1, 0xA1, 1, start_line},
    {0xA2, 0xA2, 1, row_offset},
    {0xA4, 0xA7, 0, sheen_sim_set_mode},
    {0xA8, 0xA8, 1, multiplex},
    {0xAE, 0xAF, 0, sheen_sim_set_on},
};

/* Brightness, drive and clocks. SSD0323 and SSD1325 are the same chip. */
static const struct sheen_sim_command vendor_ssd1325[] = {
    {0x81, 0x81, 1, sheen_sim_set_brightness},
    {0x84, 0x86, 0, NULL},
    {0xAD, 0xAD, 1, NULL},
    {0xB1, 0xB3, 1, NULL},
    {0xB8, 0xB8, 8, NULL},
    {0xBC, 0xBC, 1, NULL},
    {0xBE, 0xBF, 1, NULL},
    {0xE3, 0xE3, 0, NULL},
};

static const struct sheen_sim_command vendor_ssd1327[] = {
    {0x81, 0x81, 1, sheen_sim_set_brightness},
    {0xAB, 0xAB, 1, NULL},
    {0xB1, 0xB1, 1, NULL},
    {0xB3, 0xB3, 1, NULL},
    {0xB6, 0xB6, 1, NULL},
    {0xB9, 0xB9, 0, NULL},
    {0xBC, 0xBC, 1, NULL},
    {0xBE, 0xBE, 1, NULL},
    {0xD5, 0xD5, 1, NULL},
    {0xFD, 0xFD, 1, NULL},
};

#define GREY(label, extra)                                                                                             \
    .name = label, .commands = commands, .command_count = sizeof commands / sizeof commands[0], .vendor = extra,       \
    .vendor_count = sizeof extra / sizeof extra[0], .defaults = defaults, .pixels = pixels, .shown = shown,            \
    .max_level = 15, .params_are_commands = 1

/* Reset pulse: SSD1325 data sheet 3 us, SSD1327 100 us ("Power ON and OFF sequence", t1); the same wait after it. */
const struct sheen_sim_chip sheen_sim_chip_ssd0323 = {GREY("SSD0323", vendor_ssd1325), .reset_low_us = 3,
                                                      .reset_us = 3};
const struct sheen_sim_chip sheen_sim_chip_ssd1325 = {GREY("SSD1325", vendor_ssd1325), .reset_low_us = 3,
                                                      .reset_us = 3};
const struct sheen_sim_chip sheen_sim_chip_ssd1327 = {GREY("SSD1327", vendor_ssd1327), .reset_low_us = 100,
                                                      .reset_us = 100};
