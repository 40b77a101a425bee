/*
 * wire.c - what drivers say to their bus: calls that are waited for, reset, init tables, windows.
 *
 * The bus may send from the caller's memory while it goes on (DMA), so each call
 * is waited for before the next and before its bytes leave scope. The one
 * exception is a push's last, its pixels: sheen_panel_launch leaves it under way.
 */
#include "driver.h"

#include <string.h>

/* A bus without wait has sent everything when send returns: then nothing is in flight. */
int sheen_panel_launch(struct sheen_panel *panel, const uint8_t *command, size_t commands, const void *data,
                       size_t count)
{
    int error = panel->bus->send(panel->bus->ctx, command, commands, data, count);

    panel->flying = error == SHEEN_OK && panel->bus->wait != NULL;
    return error;
}

/* Whatever wait answers, the call is over: a second wait for it would be for the next one. */
int sheen_panel_landed(struct sheen_panel *panel)
{
    if (!panel->flying)
        return SHEEN_OK;
    panel->flying = 0;
    return panel->bus->wait(panel->bus->ctx);
}

int sheen_panel_send(struct sheen_panel *panel, const uint8_t *command, size_t commands, const void *data, size_t count)
{
    int error = sheen_panel_launch(panel, command, commands, data, count);

    return error < 0 ? error : sheen_panel_landed(panel);
}

int sheen_panel_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count)
{
    uint8_t bytes[SHEEN_BUS_COMMANDS] = {command};

    if (!panel->record->driver->low_parameters)
        return sheen_panel_send(panel, bytes, 1, data, count);
    if (count >= sizeof bytes)
        return SHEEN_ERR_ARGUMENT;
    for (size_t i = 0; i < count; i++)
        bytes[i + 1] = data[i];
    return sheen_panel_send(panel, bytes, count + 1, NULL, 0);
}

/*
 * Starts with the falling edge, since the line may have been left low by a reset
 * that failed half-way: the pulse then is only longer.
 */
int sheen_panel_reset(struct sheen_panel *panel)
{
    const struct sheen_panel_record *record = panel->record;
    const struct sheen_bus *bus = panel->bus;
    int error = SHEEN_OK;

    if (bus->reset) {
        error = bus->reset(bus->ctx, 0);
        if (error == SHEEN_OK)
            error = bus->delay(bus->ctx, record->reset_low_us);
        if (error == SHEEN_OK)
            error = bus->reset(bus->ctx, 1);
    } else if (record->driver->reset_command >= 0) {
        /* The power may have come up just now: that is a reset too, with its own rest. */
        error = bus->delay(bus->ctx, record->reset_ms * 1000u);
        if (error == SHEEN_OK)
            error = sheen_panel_command(panel, (uint8_t)record->driver->reset_command, NULL, 0);
    }
    return error < 0 ? error : bus->delay(bus->ctx, record->reset_ms * 1000u);
}

int sheen_panel_steps(struct sheen_panel *panel)
{
    const struct sheen_panel_record *record = panel->record;

    for (unsigned i = 0; i < record->steps; i++) {
        const struct sheen_panel_step *step = &record->init[i];
        int error = sheen_panel_command(panel, step->command, step->data, step->count);

        if (error == SHEEN_OK && step->wait_ms)
            error = panel->bus->delay(panel->bus->ctx, step->wait_ms * 1000u);
        if (error < 0)
            return error;
    }
    return SHEEN_OK;
}

int sheen_panel_window_moves(struct sheen_panel *panel, unsigned axis, unsigned first, unsigned last)
{
    uint16_t *held = &panel->window[2 * axis];
    uint8_t known = (uint8_t)(1u << axis);

    if ((panel->window_known & known) && held[0] == first && held[1] == last)
        return 0;
    held[0] = (uint16_t)first;
    held[1] = (uint16_t)last;
    panel->window_known |= known; /* an error on the way makes all unknown again */
    return 1;
}

int sheen_panel_set_window(struct sheen_panel *panel, unsigned axis, uint8_t command, unsigned first, unsigned last)
{
    const uint8_t bytes[2] = {(uint8_t)first, (uint8_t)last};

    if (!sheen_panel_window_moves(panel, axis, first, last))
        return SHEEN_OK;
    return sheen_panel_command(panel, command, bytes, sizeof bytes);
}

int sheen_panel_resynchronise(struct sheen_panel *panel, uint8_t harmless)
{
    uint8_t bytes[8]; /* parameters at most, of any command that is sent (B8, the SSD1325's grey table) */

    if (panel->bus->reset)
        return SHEEN_OK;
    memset(bytes, harmless, sizeof bytes);
    return sheen_panel_send(panel, bytes, sizeof bytes, NULL, 0);
}
