/*
 * settings.c - brightness and the TE output, which each initialisation restores if they were asked for.
 *
 * The panel calls this file through pointers only, so that firmware which uses neither does not link it.
 */
#include "drivers/driver.h"

static void set_brightness(struct sheen_panel *panel)
{
    const struct sheen_panel_record *record = panel->record;
    const uint8_t *on = record->driver->brightness_on;
    uint8_t value = (uint8_t)(panel->brightness >> record->brightness_shift);

    if (on[0])
        record->driver->command(panel, on[0], &on[1], 1);
    record->driver->command(panel, record->brightness_command, &value, 1);
}

/* Runs after the driver's initialisation; the bus is held. */
static void apply_settings(struct sheen_panel *panel)
{
    static const uint8_t vertical_only = 0; /* one pulse per refresh, none per line */
    const struct sheen_panel_driver *driver = panel->record->driver;

    if (panel->te_on)
        driver->command(panel, driver->tearing_command, &vertical_only, 1);
    if (panel->has_brightness)
        set_brightness(panel);
}

int sheen_panel_brightness(struct sheen_panel *panel, unsigned level)
{
    if (!panel->record->brightness_command)
        return SHEEN_ERR_UNSUPPORTED;
    if (level > 255)
        return SHEEN_ERR_ARGUMENT;
    panel->brightness = (uint8_t)level;
    panel->has_brightness = 1;
    panel->apply_settings = apply_settings;
    if (!panel->ready)
        return SHEEN_OK; /* the next initialisation sends it */
    sheen_panel_take(panel);
    set_brightness(panel);
    return sheen_panel_give(panel);
}

int sheen_panel_tearing(struct sheen_panel *panel)
{
    if (!panel->record->driver->tearing_command)
        return SHEEN_ERR_UNSUPPORTED;
    panel->te_on = 1;
    panel->apply_settings = apply_settings;
    panel->ready = 0;
    return SHEEN_OK;
}

static void await_pulse(struct sheen_panel *panel)
{
    if (panel->error == SHEEN_OK)
        panel->error = panel->bus->tearing(panel->bus->ctx);
}

int sheen_panel_sync(struct sheen_panel *panel)
{
    if (!panel->bus->tearing || !panel->record->driver->tearing_command)
        return SHEEN_ERR_UNSUPPORTED;
    if (!panel->te_on)
        sheen_panel_tearing(panel);
    panel->before_push = await_pulse;
    return SHEEN_OK;
}
