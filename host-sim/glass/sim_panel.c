/*
 * sim_panel.c - puts driver, bus, controller and glass together under a panel's name.
 */
#include "sim_panel.h"

#include <stdlib.h>

#include "glass.h"
#include "sim_panel_ideal.h"

struct sheen_sim_panel {
    struct sheen_sim_choice choice;
    struct sheen_sim_module ideal_module; /* of the size asked for */
    struct sheen_sim_controller controller;
    struct sheen_sim_bus bus;
    struct sheen_i2c i2c; /* the layer around bus, if choice.i2c */
    struct sheen_panel driver;
    struct sheen_sim_ideal ideal;
    struct sheen_target target;
};

/* Opens the driver anew, because a driver knows nothing of its controller when it starts. */
int sheen_sim_panel_restart(struct sheen_sim_panel *panel)
{
    const struct sheen_sim_choice *choice = &panel->choice;

    if (!choice->record) {
        sheen_sim_ideal_target(&panel->ideal, &panel->bus.bus, choice->width, choice->height, &panel->target);
        return SHEEN_OK;
    }
    const struct sheen_bus *bus = choice->i2c ? &panel->i2c.layer.bus : &panel->bus.bus;
    int error = sheen_panel_open(&panel->driver, choice->record, bus, choice->orientation);

    return error < 0 ? error : sheen_panel_target(&panel->driver, &panel->target);
}

/* The simulated hardware is found by the record's name alone; the record's other fields are not used. */
int sheen_sim_panel_open(struct sheen_sim_panel **out, const struct sheen_sim_choice *choice)
{
    struct sheen_sim_panel *panel = calloc(1, sizeof *panel);
    const struct sheen_sim_module *module;
    int error;

    *out = NULL;
    if (!panel)
        return SHEEN_ERR_MEMORY;
    panel->choice = *choice;
    panel->ideal_module = (struct sheen_sim_module){.name = "ideal",
                                                    .chip = &sheen_sim_chip_ideal,
                                                    .ram_w = choice->width,
                                                    .ram_h = choice->height,
                                                    .glass_w = choice->width,
                                                    .glass_h = choice->height};
    module = choice->record ? sheen_sim_module_find(choice->record->name) : &panel->ideal_module;
    error = module ? sheen_sim_controller_open(&panel->controller, module) : SHEEN_ERR_ARGUMENT;
    if (error == SHEEN_OK) {
        sheen_sim_bus_open(&panel->bus, &panel->controller, 1);
        sheen_sim_bus_i2c(&panel->bus, choice->i2c);
        error = choice->i2c ? sheen_i2c_open(&panel->i2c, &panel->bus.bus, 0) : SHEEN_OK;
    }
    if (error == SHEEN_OK) {
        error = sheen_sim_panel_restart(panel);
    }
    if (error < 0) {
        sheen_sim_panel_close(panel);
        return error;
    }
    *out = panel;
    return SHEEN_OK;
}

void sheen_sim_panel_close(struct sheen_sim_panel *panel)
{
    if (!panel)
        return;
    sheen_sim_controller_close(&panel->controller);
    free(panel);
}

const struct sheen_target *sheen_sim_panel_target(struct sheen_sim_panel *panel)
{
    return &panel->target;
}

int sheen_sim_panel_init(struct sheen_sim_panel *panel)
{
    return panel->choice.record ? sheen_panel_init(&panel->driver) : SHEEN_OK;
}

/* Finds the viewer's pixel on the glass. The ideal glass is turned with the viewer. */
static void place(const struct sheen_sim_panel *panel, unsigned x, unsigned y, unsigned *column, unsigned *row)
{
    unsigned orientation = panel->choice.record ? panel->choice.orientation : 0;

    sheen_sim_glass_place(panel->controller.module, orientation, x, y, column, row);
}

/* Reads the glass, not the RAM, so that pixels are unlit, inverted or masked as the viewer sees them. */
int sheen_sim_panel_picture(struct sheen_sim_panel *panel, uint16_t *values)
{
    if (panel->bus.flying)
        return SHEEN_ERR_STATE;
    for (unsigned y = 0; y < panel->choice.height; y++) {
        for (unsigned x = 0; x < panel->choice.width; x++) {
            unsigned column, row;

            place(panel, x, y, &column, &row);
            *values++ = sheen_sim_glass(&panel->controller, column, row);
        }
    }
    return SHEEN_OK;
}

unsigned sheen_sim_panel_levels(const struct sheen_sim_panel *panel)
{
    return panel->controller.module->chip->max_level;
}

int sheen_sim_panel_has(const struct sheen_sim_panel *panel, unsigned x, unsigned y)
{
    unsigned column, row;

    place(panel, x, y, &column, &row);
    return sheen_sim_glass_has(panel->controller.module, column, row);
}

unsigned sheen_sim_panel_complaints(const struct sheen_sim_panel *panel)
{
    return panel->controller.complaints;
}

const char *sheen_sim_panel_complaint(const struct sheen_sim_panel *panel)
{
    return panel->controller.first_complaint;
}

struct sheen_panel *sheen_sim_panel_driver(struct sheen_sim_panel *panel)
{
    return panel->choice.record ? &panel->driver : NULL;
}

struct sheen_sim_bus *sheen_sim_panel_bus(struct sheen_sim_panel *panel)
{
    return &panel->bus;
}
