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
void sheen_panel_launch(struct sheen_panel *panel, const uint8_t *command, size_t commands, const void *data,
                        size_t count)
{
    const struct sheen_bus *bus = panel->bus;

    if (panel->error != SHEEN_OK)
        return;
    panel->error = bus->send(bus->ctx, command, commands, data, count);
    panel->flying = panel->error == SHEEN_OK && bus->wait != NULL;
}

/* Whatever wait answers, the call is over: a second wait for it would be for the next one. */
void sheen_panel_landed(struct sheen_panel *panel)
{
    if (!panel->flying)
        return;
    panel->flying = 0;
    panel->error = panel->bus->wait(panel->bus->ctx);
}

void sheen_panel_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count)
{
    sheen_panel_launch(panel, &command, 1, data, count);
    sheen_panel_landed(panel);
}

void sheen_panel_low_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count)
{
    uint8_t bytes[SHEEN_BUS_COMMANDS] = {command};

    if (count >= sizeof bytes && panel->error == SHEEN_OK)
        panel->error = SHEEN_ERR_ARGUMENT;
    for (size_t i = 0; i < count && i < sizeof bytes - 1; i++)
        bytes[i + 1] = data[i];
    sheen_panel_launch(panel, bytes, count + 1, NULL, 0);
    sheen_panel_landed(panel);
}

static void rest(struct sheen_panel *panel, uint32_t us)
{
    if (panel->error == SHEEN_OK)
        panel->error = panel->bus->delay(panel->bus->ctx, us);
}

static void drive_reset(struct sheen_panel *panel, int level)
{
    if (panel->error == SHEEN_OK)
        panel->error = panel->bus->reset(panel->bus->ctx, level);
}

/*
 * Starts with the falling edge, since the line may have been left low by a reset
 * that failed half-way: the pulse then is only longer.
 */
void sheen_panel_reset(struct sheen_panel *panel)
{
    const struct sheen_panel_record *record = panel->record;
    uint32_t rest_us = record->reset_ms * 1000u;

    if (panel->bus->reset) {
        drive_reset(panel, 0);
        rest(panel, record->reset_low_us);
        drive_reset(panel, 1);
    } else if (record->driver->reset_command >= 0) {
        /* The power may have come up just now: that is a reset too, with its own rest. */
        rest(panel, rest_us);
        sheen_panel_command(panel, (uint8_t)record->driver->reset_command, NULL, 0);
    }
    rest(panel, rest_us);
}

void sheen_panel_steps(struct sheen_panel *panel)
{
    const struct sheen_panel_record *record = panel->record;
    const struct sheen_panel_step *step = record->init;

    for (unsigned left = record->steps; left; left--, step++) {
        record->driver->command(panel, step->command, step->data, step->count);
        if (step->wait_ms)
            rest(panel, step->wait_ms * 1000u);
    }
}

void sheen_panel_set_window(struct sheen_panel *panel, unsigned axis, uint8_t command, unsigned first, unsigned last)
{
    const uint8_t bytes[2] = {(uint8_t)first, (uint8_t)last};

    if (sheen_panel_window_moves(panel, axis, first << 16 | last))
        panel->record->driver->command(panel, command, bytes, sizeof bytes);
}

void sheen_panel_resynchronise(struct sheen_panel *panel, uint8_t harmless)
{
    uint8_t bytes[8]; /* parameters at most, of any command that is sent (B8, the SSD1325's grey table) */

    if (panel->bus->reset)
        return;
    memset(bytes, harmless, sizeof bytes);
    sheen_panel_launch(panel, bytes, sizeof bytes, NULL, 0);
    sheen_panel_landed(panel);
}
