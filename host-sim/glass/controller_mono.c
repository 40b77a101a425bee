/*
 * controller_mono.c - simulated SSD1306 and SH1106: one bit per pixel, eight rows per page.
 *
 * A1 stores columns, if written after it, from the last segment on; C8 counts COM lines from the multiplex ratio down.
 * Neither chip shows anything before its supply is switched on: 8D 14 (charge pump), AD 8B (DC-DC). A module without a
 * resistor for the segments' current shows nothing before AD 30, the SSD1306B's own reference (a real one is dim).
 */
#include "controller.h"

/* Address modes of the SSD1306 (command 20); the SH1106 knows only pages. */
enum mode {
    MODE_HORIZONTAL = 0,
    MODE_VERTICAL = 1,
    MODE_PAGE = 2
};

static void defaults(struct sheen_sim_controller *controller)
{
    const struct sheen_sim_module *module = controller->module;

    controller->on = controller->inverted = controller->all_on = controller->pump = controller->own_current = 0;
    controller->scan = controller->com_remap = controller->row_offset = controller->start_line = 0;
    controller->mode = MODE_PAGE;
    controller->multiplex = (uint8_t)(module->ram_h - 1);
    controller->x0 = controller->y0 = 0;
    controller->x1 = (uint16_t)(module->ram_w - 1);
    controller->y1 = (uint16_t)(module->ram_h / 8 - 1);
    sheen_sim_window_start(controller);
}

static void column_low(struct sheen_sim_controller *controller)
{
    controller->x = (uint16_t)((controller->x & 0xF0) | (controller->command & 15));
}

static void column_high(struct sheen_sim_controller *controller)
{
    controller->x = (uint16_t)((controller->x & 0x0F) | (controller->command & 15) << 4);
}

static void page(struct sheen_sim_controller *controller)
{
    controller->y = controller->command & 7;
}

static void address_mode(struct sheen_sim_controller *controller)
{
    if (controller->params[0] > MODE_PAGE)
        sheen_sim_complain(controller, "address mode %u", controller->params[0]);
    controller->mode = controller->params[0];
}

static void start_line(struct sheen_sim_controller *controller)
{
    controller->start_line = controller->command & 63;
}

static void pump(struct sheen_sim_controller *controller)
{
    controller->pump = controller->params[0] == (controller->command == 0x8D ? 0x14 : 0x8B);
}

static void own_current(struct sheen_sim_controller *controller)
{
    controller->own_current = (controller->params[0] & 0x10) != 0;
}

static void segment_remap(struct sheen_sim_controller *controller)
{
    controller->scan = controller->command & 1;
}

/* A4 shows the RAM, A5 lights every pixel. */
static void all_on(struct sheen_sim_controller *controller)
{
    controller->all_on = controller->command & 1;
}

static void inversion(struct sheen_sim_controller *controller)
{
    controller->inverted = controller->command & 1;
}

static void multiplex(struct sheen_sim_controller *controller)
{
    if (controller->params[0] < 15 || controller->params[0] > 63)
        sheen_sim_complain(controller, "multiplex ratio %u", controller->params[0] + 1u);
    controller->multiplex = controller->params[0] & 63;
}

static void com_scan(struct sheen_sim_controller *controller)
{
    controller->com_remap = (controller->command & 8) != 0;
}

static void row_offset(struct sheen_sim_controller *controller)
{
    controller->row_offset = controller->params[0] & 63;
}

static void pixels(struct sheen_sim_controller *controller, uint8_t byte)
{
    const struct sheen_sim_module *module = controller->module;
    unsigned column = controller->scan ? module->ram_w - 1u - controller->x : controller->x;

    for (unsigned bit = 0; bit < 8; bit++)
        sheen_sim_store(controller, column, controller->y * 8u + bit, byte >> bit & 1);
    if (controller->mode == MODE_PAGE) {
        controller->rectangles += !controller->streaming;
        controller->streaming = 1; /* until the next command, so that a run of bytes counts as one rectangle */
        controller->x++;
        return;
    }
    sheen_sim_check_window(controller, module->ram_w, module->ram_h / 8u);
    sheen_sim_next_address(controller, controller->mode == MODE_VERTICAL);
}

static uint16_t shown(const struct sheen_sim_controller *controller, unsigned segment, unsigned com)
{
    const struct sheen_sim_module *module = controller->module;
    int row = sheen_sim_com_row(controller, com, controller->multiplex);

    if (!controller->on || !controller->pump || row < 0 || (module->no_current && !controller->own_current))
        return 0;
    return controller->all_on || controller->ram[(size_t)row * module->ram_w + segment] != controller->inverted;
}

#define COMMON                                                                                                         \
    {0x00, 0x0F, 0, column_low}, {0x10, 0x1F, 0, column_high}, {0x40, 0x7F, 0, start_line},                            \
        {0x81, 0x81, 1, sheen_sim_set_brightness}, {0xA0, 0xA1, 0, segment_remap}, {0xA4, 0xA5, 0, all_on},            \
        {0xA6, 0xA7, 0, inversion}, {0xA8, 0xA8, 1, multiplex}, {0xAE, 0xAF, 0, sheen_sim_set_on},                     \
        {0xB0, 0xB7, 0, page}, {0xC0, 0xC0, 0, com_scan}, {0xC8, 0xC8, 0, com_scan}, {0xD3, 0xD3, 1, row_offset},      \
        {0xD5, 0xD5, 1, NULL}, {0xD9, 0xDB, 1, NULL},                                                                  \
    {                                                                                                                  \
        0xE3, 0xE3, 0, NULL                                                                                            \
    }

static const struct sheen_sim_command commands_ssd1306[] = {
    COMMON,
    {0x20, 0x20, 1, address_mode},
    {0x21, 0x21, 2, sheen_sim_set_columns},
    {0x22, 0x22, 2, sheen_sim_set_rows},
    {0x2E, 0x2F, 0, NULL},
    {0x8D, 0x8D, 1, pump},
    {0xAD, 0xAD, 1, own_current}, /* SSD1306B: internal current reference */
};

static const struct sheen_sim_command commands_sh1106[] = {
    COMMON,
    {0x30, 0x33, 0, NULL}, /* pump voltage */
    {0xAD, 0xAD, 1, pump},
};

#define MONO(label, list)                                                                                              \
    .name = label, .commands = list, .command_count = sizeof list / sizeof list[0], .defaults = defaults,              \
    .pixels = pixels, .shown = shown, .max_level = 1, .params_are_commands = 1

/* Reset pulse: SSD1306 data sheet 8.9 (t1) 3 us; SH1106 data sheet, "Reset timing", 10 us; the same wait after it. */
const struct sheen_sim_chip sheen_sim_chip_ssd1306 = {MONO("SSD1306", commands_ssd1306), .reset_low_us = 3,
                                                      .reset_us = 3};
const struct sheen_sim_chip sheen_sim_chip_sh1106 = {MONO("SH1106", commands_sh1106), .reset_low_us = 10,
                                                     .reset_us = 10};
