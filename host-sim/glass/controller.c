/*
 * controller.c - what all simulated controllers share: power, reset, the virtual clock, receiving commands.
 *
 * A command byte begins a command of the chip's list; its parameters follow, with D/C high (DCS, SSD1322, SSD1351) or
 * low (the other OLEDs). Unexpected bytes are reported and dropped.
 */
#include "controller.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "sheen_target.h"

void sheen_sim_complain(struct sheen_sim_controller *controller, const char *format, ...)
{
    va_list args;

    if (controller->complaints++)
        return;
    int used =
        snprintf(controller->first_complaint, sizeof controller->first_complaint, "%s: ", controller->module->name);
    va_start(args, format);
    vsnprintf(controller->first_complaint + used, sizeof controller->first_complaint - (size_t)used, format, args);
    va_end(args);
}

int sheen_sim_controller_open(struct sheen_sim_controller *controller, const struct sheen_sim_module *module)
{
    *controller = (struct sheen_sim_controller){.module = module};
    controller->ram = malloc(sizeof *controller->ram * module->ram_w * module->ram_h);
    if (!controller->ram)
        return SHEEN_ERR_MEMORY;
    sheen_sim_power_cycle(controller);
    return SHEEN_OK;
}

void sheen_sim_controller_close(struct sheen_sim_controller *controller)
{
    free(controller->ram);
    controller->ram = NULL;
}

/* Forgets the command under way, so that the interface is ready for the next one. */
static void forget_command(struct sheen_sim_controller *controller)
{
    controller->missing = controller->streaming = controller->count = controller->half_set = 0;
}

/* The RAM starts with noise, so that a pixel never written shows; it is always the same, so that tests repeat. */
void sheen_sim_power_cycle(struct sheen_sim_controller *controller)
{
    const struct sheen_sim_module *module = controller->module;
    uint32_t noise = 0x2545F491u;
    uint16_t top = module->chip->max_level ? module->chip->max_level : 0xFFFF;

    for (size_t i = 0; i < (size_t)module->ram_w * module->ram_h; i++) {
        noise = noise * 1664525u + 1013904223u;
        controller->ram[i] = (uint16_t)((noise >> 16) & top);
    }
    forget_command(controller);
    controller->reset_level = 1;
    controller->quiet_until_us = controller->now_us + module->chip->reset_us;
    module->chip->defaults(controller);
}

/* The registers are reset at the rising edge; while the line is low nothing is received. */
void sheen_sim_reset_line(struct sheen_sim_controller *controller, int level)
{
    const struct sheen_sim_chip *chip = controller->module->chip;

    if (controller->reset_level && !level) {
        controller->reset_since_us = controller->now_us + controller->reset_fall_us;
    } else if (!controller->reset_level && level) {
        uint64_t since_us = controller->reset_since_us;
        uint64_t low_us = controller->now_us > since_us ? controller->now_us - since_us : 0;

        if (low_us < chip->reset_low_us)
            sheen_sim_complain(controller, "reset low for %u us, needs %u", (unsigned)low_us, chip->reset_low_us);
        forget_command(controller);
        controller->quiet_until_us = controller->now_us + chip->reset_us;
        chip->defaults(controller);
    }
    controller->reset_level = level != 0;
}

void sheen_sim_advance(struct sheen_sim_controller *controller, uint32_t us)
{
    controller->now_us += us;
}

#define REFRESH_US 16667u /* 60 pictures per second */

int sheen_sim_tearing(struct sheen_sim_controller *controller)
{
    if (!controller->tearing || !controller->awake)
        return SHEEN_ERR_TIMEOUT;
    controller->now_us += REFRESH_US - controller->now_us % REFRESH_US;
    return SHEEN_OK;
}

static const struct sheen_sim_command *find(const struct sheen_sim_command *list, size_t count, uint8_t code)
{
    for (size_t i = 0; i < count; i++)
        if (list[i].first <= code && code <= list[i].last)
            return &list[i];
    return NULL;
}

static const struct sheen_sim_command *find_command(const struct sheen_sim_controller *controller, uint8_t code)
{
    const struct sheen_sim_chip *chip = controller->module->chip;
    const struct sheen_sim_command *found = find(chip->commands, chip->command_count, code);

    return found ? found : find(chip->vendor, chip->vendor_count, code);
}

/* Begins a new command, which ends whatever was under way. */
static void begin(struct sheen_sim_controller *controller, uint8_t code)
{
    const struct sheen_sim_command *command = find_command(controller, code);

    if (controller->streaming && controller->module->chip->stream_end)
        controller->module->chip->stream_end(controller);
    forget_command(controller);
    controller->command = code;
    if (!command) {
        sheen_sim_complain(controller, "unknown command 0x%02X", code);
        return;
    }
    controller->missing = command->params;
    if (command->params == 0 && command->run)
        command->run(controller);
}

/* count is below 16 here, because no command of a list has more than 16 parameters. */
static void parameter(struct sheen_sim_controller *controller, uint8_t byte)
{
    const struct sheen_sim_command *command = find_command(controller, controller->command);

    controller->params[controller->count++] = byte;
    if (--controller->missing == 0 && command->run)
        command->run(controller);
}

/* A byte with D/C low: a parameter if the chip takes parameters with D/C low, otherwise a new command. */
static void take_command(struct sheen_sim_controller *controller, uint8_t byte)
{
    if (controller->now_us < controller->quiet_until_us)
        sheen_sim_complain(controller, "command 0x%02X comes %u us too early", byte,
                           (unsigned)(controller->quiet_until_us - controller->now_us));
    if (controller->missing && controller->module->chip->params_are_commands) {
        parameter(controller, byte);
        return;
    }
    if (controller->missing && byte != controller->module->chip->reset_command)
        sheen_sim_complain(controller, "command 0x%02X misses %u of its parameters", controller->command,
                           controller->missing);
    begin(controller, byte);
}

/* A byte with D/C high: a parameter, or a byte of the picture. */
static void take_data(struct sheen_sim_controller *controller, uint8_t byte)
{
    const struct sheen_sim_chip *chip = controller->module->chip;

    if (controller->missing && !chip->params_are_commands)
        parameter(controller, byte);
    else if (controller->missing)
        sheen_sim_complain(controller, "data where command 0x%02X misses %u parameters", controller->command,
                           controller->missing);
    else if (chip->params_are_commands || controller->streaming)
        chip->pixels(controller, byte);
    else
        sheen_sim_complain(controller, "data 0x%02X, but command 0x%02X takes no more", byte, controller->command);
}

void sheen_sim_receive(struct sheen_sim_controller *controller, enum sheen_sim_dc dc, const uint8_t *bytes,
                       size_t count)
{
    if (!controller->reset_level) {
        sheen_sim_complain(controller, "%zu bytes while the reset line is low", count);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        if (dc == SHEEN_SIM_COMMAND)
            take_command(controller, bytes[i]);
        else
            take_data(controller, bytes[i]);
    }
}

void sheen_sim_window_start(struct sheen_sim_controller *controller)
{
    controller->x = controller->x0;
    controller->y = controller->y0;
    controller->wrapped = 0;
}

/* Pixels outside the RAM are lost and reported. */
void sheen_sim_store(struct sheen_sim_controller *controller, unsigned column, unsigned row, uint16_t value)
{
    const struct sheen_sim_module *module = controller->module;

    if (column >= module->ram_w || row >= module->ram_h)
        sheen_sim_complain(controller, "pixel outside the RAM: column %u, row %u", column, row);
    else
        controller->ram[(size_t)row * module->ram_w + column] = value;
}
