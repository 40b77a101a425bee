/*
 * controller_ideal.c - plain RGB565 memory behind a bus: the panel `ideal`.
 *
 * It is lit from the start and never turned, inverted or asleep. Its three commands are those of a DCS controller (2A
 * columns, 2B rows, 2C pixels), so that byte counts compare. It shares no code with the simulated controllers, because
 * it is compared with them.
 */
#include <string.h>

#include "controller.h"

static void defaults(struct sheen_sim_controller *controller)
{
    const struct sheen_sim_module *module = controller->module;

    controller->x0 = controller->y0 = 0;
    controller->x1 = (uint16_t)(module->ram_w - 1);
    controller->y1 = (uint16_t)(module->ram_h - 1);
    sheen_sim_window_start(controller);
    memset(controller->ram, 0, sizeof *controller->ram * module->ram_w * module->ram_h);
}

/* Start and end, 16 bits each, high byte first, end inclusive. */
static void range(struct sheen_sim_controller *controller)
{
    const uint8_t *p = controller->params;
    uint16_t first = (uint16_t)(p[0] << 8 | p[1]), last = (uint16_t)(p[2] << 8 | p[3]);
    int rows = controller->command == 0x2B;

    if (first > last || last >= (rows ? controller->module->ram_h : controller->module->ram_w))
        sheen_sim_complain(controller, "%s %u..%u", rows ? "rows" : "columns", first, last);
    *(rows ? &controller->y0 : &controller->x0) = first;
    *(rows ? &controller->y1 : &controller->x1) = last;
}

static void write_memory(struct sheen_sim_controller *controller)
{
    sheen_sim_window_start(controller);
    controller->streaming = 1;
    controller->rectangles++;
}

static void pixels(struct sheen_sim_controller *controller, uint8_t byte)
{
    controller->half_set ^= 1;
    if (controller->half_set) {
        controller->half = byte;
        return;
    }
    if (controller->y > controller->y1) {
        sheen_sim_complain(controller, "more pixels than the window holds");
        return;
    }
    sheen_sim_store(controller, controller->x, controller->y, (uint16_t)(controller->half << 8 | byte));
    if (controller->x++ == controller->x1) {
        controller->x = controller->x0;
        controller->y++;
    }
}

static void stream_end(struct sheen_sim_controller *controller)
{
    if (controller->half_set)
        sheen_sim_complain(controller, "half a pixel before command");
}

static uint16_t shown(const struct sheen_sim_controller *controller, unsigned column, unsigned row)
{
    return controller->ram[(size_t)row * controller->module->ram_w + column];
}

static const struct sheen_sim_command commands[] = {
    {0x2A, 0x2B, 4, range},
    {0x2C, 0x2C, 0, write_memory},
};

const struct sheen_sim_chip sheen_sim_chip_ideal = {.name = "ideal",
                                                    .commands = commands,
                                                    .command_count = sizeof commands / sizeof commands[0],
                                                    .defaults = defaults,
                                                    .pixels = pixels,
                                                    .stream_end = stream_end,
                                                    .shown = shown};
