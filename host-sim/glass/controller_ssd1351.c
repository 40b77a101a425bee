/*
 * controller_ssd1351.c - the simulated colour OLED SSD1351, in its 65k-colour format.
 *
 * Remap bits as in the data sheet (A0h): 0: the address runs down the rows first, 1: columns are stored from the last
 * segment, 2: sub-pixels are C, B, A, 4: COM lines are scanned from the last. Column remap acts on what is written
 * after it, COM remap and start line on what is shown.
 */
#include "controller.h"

#define REMAP_VERTICAL 0x01
#define REMAP_COLUMN 0x02
#define REMAP_CBA 0x04
#define REMAP_COM 0x10

/* What A4..A7 show. */
enum mode {
    MODE_OFF = 0,
    MODE_ALL_ON = 1,
    MODE_NORMAL = 2,
    MODE_INVERSE = 3
};

/* The display offset starts as 0x60, so a driver that omits A2 is noticed. */
static void defaults(struct sheen_sim_controller *controller)
{
    const struct sheen_sim_module *module = controller->module;

    controller->on = controller->com_remap = controller->unlocked = 0;
    controller->scan = 0x40; /* 65k colours */
    controller->row_offset = 0x60;
    controller->start_line = 0;
    controller->mode = MODE_NORMAL;
    controller->multiplex = (uint8_t)(module->ram_h - 1);
    controller->x0 = controller->y0 = 0;
    controller->x1 = (uint16_t)(module->ram_w - 1);
    controller->y1 = (uint16_t)(module->ram_h - 1);
    sheen_sim_window_start(controller);
}

/* FD 12 unlocks the interface, which is its state after reset; FD B1 unlocks six registers, FD B0 locks them. */
static void lock(struct sheen_sim_controller *controller)
{
    if (controller->params[0] == 0xB1 || controller->params[0] == 0xB0)
        controller->unlocked = controller->params[0] & 1;
    else if (controller->params[0] != 0x12)
        sheen_sim_complain(controller, "command lock 0x%02X", controller->params[0]);
}

/* Registers that are accepted only after FD B1 (data sheet, command table, FDh). */
static void locked(struct sheen_sim_controller *controller)
{
    if (!controller->unlocked)
        sheen_sim_complain(controller, "command 0x%02X is locked", controller->command);
    else if (controller->command == 0xA2)
        controller->row_offset = controller->params[0] & 127;
}

static void remap(struct sheen_sim_controller *controller)
{
    controller->scan = controller->params[0];
    controller->com_remap = (controller->scan & REMAP_COM) != 0;
    if ((controller->scan & 0xC0) != 0x40)
        sheen_sim_complain(controller, "remap 0x%02X: only 65k colours are simulated", controller->scan);
}

static void start_line(struct sheen_sim_controller *controller)
{
    if (controller->params[0] > 127)
        sheen_sim_complain(controller, "start line %u", controller->params[0]);
    controller->start_line = controller->params[0] & 127;
}

static void multiplex(struct sheen_sim_controller *controller)
{
    if (controller->params[0] < 15 || controller->params[0] > 127)
        sheen_sim_complain(controller, "multiplex ratio %u", controller->params[0] + 1u);
    controller->multiplex = controller->params[0] & 127;
}

static void write_ram(struct sheen_sim_controller *controller)
{
    controller->streaming = 1;
}

static void pixels(struct sheen_sim_controller *controller, uint8_t byte)
{
    const struct sheen_sim_module *module = controller->module;

    controller->half_set ^= 1;
    if (controller->half_set) {
        controller->half = byte;
        return;
    }
    sheen_sim_check_window(controller, module->ram_w, module->ram_h);
    /* The RAM holds one value per segment, placed by the column remap that is set when the pixel is written. */
    sheen_sim_store(controller, controller->scan & REMAP_COLUMN ? module->ram_w - 1u - controller->x : controller->x,
                    controller->y, (uint16_t)(controller->half << 8 | byte));
    sheen_sim_next_address(controller, controller->scan & REMAP_VERTICAL);
}

static void stream_end(struct sheen_sim_controller *controller)
{
    if (controller->half_set)
        sheen_sim_complain(controller, "half a pixel before command");
}

/* A4 dark, A5 white, A6 the RAM, A7 its complement; then the order of the sub-pixels. */
static uint16_t shown(const struct sheen_sim_controller *controller, unsigned segment, unsigned com)
{
    const struct sheen_sim_module *module = controller->module;
    int row = sheen_sim_com_row(controller, com, controller->multiplex);

    if (!controller->on || row < 0 || controller->mode == MODE_OFF)
        return 0;
    if (controller->mode == MODE_ALL_ON)
        return 0xFFFF;
    uint16_t v = controller->ram[(size_t)row * module->ram_w + segment];
    if (controller->mode == MODE_INVERSE)
        v = (uint16_t)~v;
    if (((controller->scan & REMAP_CBA) != 0) != module->bgr)
        v = (uint16_t)((v & 0x07E0) | v >> 11 | v << 11);
    return v;
}

static const struct sheen_sim_command commands[] = {
    {0x15, 0x15, 2, sheen_sim_set_columns},
    {0x5C, 0x5C, 0, write_ram},
    {0x75, 0x75, 2, sheen_sim_set_rows},
    {0xA0, 0xA0, 1, remap},
    {0xA1, 0xA1, 1, start_line},
    {0xA2, 0xA2, 1, locked},
    {0xA4, 0xA7, 0, sheen_sim_set_mode},
    {0xAE, 0xAF, 0, sheen_sim_set_on},
    {0xB1, 0xB1, 1, locked},
    {0xB3, 0xB3, 1, locked},
    {0xBB, 0xBB, 1, locked},
    {0xBE, 0xBE, 1, locked},
    {0xC1, 0xC1, 3, locked},
    {0xCA, 0xCA, 1, multiplex},
    {0xFD, 0xFD, 1, lock},
};

static const struct sheen_sim_command vendor[] = {
    {0xAB, 0xAB, 1, NULL},
    {0xB4, 0xB4, 3, NULL},
    {0xB5, 0xB5, 1, NULL},
    {0xB6, 0xB6, 1, NULL},
    {0xC7, 0xC7, 1, sheen_sim_set_brightness},
};

/* Reset pulse: data sheet, "Power ON and OFF sequence", t1 and t2: 2 us each. */
const struct sheen_sim_chip sheen_sim_chip_ssd1351 = {.name = "SSD1351",
                                                      .commands = commands,
                                                      .command_count = sizeof commands / sizeof commands[0],
                                                      .vendor = vendor,
                                                      .vendor_count = sizeof vendor / sizeof vendor[0],
                                                      .defaults = defaults,
                                                      .pixels = pixels,
                                                      .stream_end = stream_end,
                                                      .shown = shown,
                                                      .reset_low_us = 2,
                                                      .reset_us = 2};
