/*
 * wire.c - how drivers use their bus: commands, reset, init tables, windows.
 *
 * The bus may read the caller's memory after send has returned (DMA). So each call is
 * waited for before the next call, and before its bytes go out of scope. The exception
 * is the last call of a push, with its pixels: sheen_panel_launch leaves it under way.
 */
#include "driver.h"

#include <string.h>

/* A bus without wait has sent everything when send returns, so nothing is in flight then. */
void sheen_panel_launch(struct sheen_panel *panel, const uint8_t *command, size_t commands, const void *data,
                        size_t count)
{
    const struct sheen_bus *bus = panel->bus;

    if (panel->error != SHEEN_OK)
        return;
    panel->error = bus->send(bus->ctx, command, commands, data, count);
    panel->in_flight = panel->error == SHEEN_OK && bus->wait != NULL;
}

/* Whatever wait returns, the call is over and must not be waited for again. */
void sheen_panel_await(struct sheen_panel *panel)
{
    if (!panel->in_flight)
        return;
    panel->in_flight = 0;
    panel->error = panel->bus->wait(panel->bus->ctx);
}

void sheen_panel_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count)
{
    sheen_panel_launch(panel, &command, 1, data, count);
    sheen_panel_await(panel);
}

void sheen_panel_low_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count)
{
    uint8_t bytes[SHEEN_BUS_COMMANDS] = {command};

    if (count >= sizeof bytes && panel->error == SHEEN_OK)
        panel->error = SHEEN_ERR_ARGUMENT;
    for (size_t i = 0; i < count && i < sizeof bytes - 1; i++)
        bytes[i + 1] = data[i];
    sheen_panel_launch(panel, bytes, count + 1, NULL, 0);
    sheen_panel_await(panel);
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
 * Drives the line low first. If an earlier reset failed half-way and left it low, the
 * pulse is only longer.
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
        /* The power may have come up only now, which is a reset too and needs the same wait before any command. */
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

    if (sheen_panel_window_update(panel, axis, first << 16 | last))
        panel->record->driver->command(panel, command, bytes, sizeof bytes);
}

void sheen_panel_resynchronise(struct sheen_panel *panel, uint8_t harmless)
{
    uint8_t bytes[8]; /* as many as the most parameters of any command sent (B8, the SSD1325's grey table) */

    if (panel->bus->reset)
        return;
    memset(bytes, harmless, sizeof bytes);
    sheen_panel_launch(panel, bytes, sizeof bytes, NULL, 0);
    sheen_panel_await(panel);
}
