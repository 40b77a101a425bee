/*
 * panel.c - what all panels share: opening, the target's two callbacks, reset, init tables.
 *
 * After any error the panel counts as unknown: its next push resets and
 * initialises it, since a controller that missed bytes (or its power) shows
 * nothing that a write-only bus could notice.
 */
#include "panel_driver.h"

int sheen_panel_launch(struct sheen_panel *panel, enum sheen_dc dc, const uint8_t *bytes, size_t count)
{
    int error = panel->bus->write(panel->bus->ctx, dc, bytes, count);

    panel->flying = error == SHEEN_OK && panel->bus->wait != NULL;
    return error;
}

int sheen_panel_landed(struct sheen_panel *panel)
{
    if (!panel->flying)
        return SHEEN_OK;
    panel->flying = 0;
    return panel->bus->wait(panel->bus->ctx);
}

int sheen_panel_write(struct sheen_panel *panel, enum sheen_dc dc, const uint8_t *bytes, size_t count)
{
    int error = sheen_panel_launch(panel, dc, bytes, count);

    return error < 0 ? error : sheen_panel_landed(panel);
}

int sheen_panel_command(struct sheen_panel *panel, uint8_t command, const uint8_t *data, size_t count)
{
    int error = sheen_panel_write(panel, SHEEN_COMMAND, &command, 1);

    if (error < 0 || count == 0)
        return error;
    return sheen_panel_write(panel, SHEEN_DATA, data, count);
}

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

int sheen_panel_steps(struct sheen_panel *panel, enum sheen_dc dc)
{
    const struct sheen_panel_record *record = panel->record;

    for (unsigned i = 0; i < record->steps; i++) {
        const struct sheen_panel_step *step = &record->init[i];
        int error = sheen_panel_write(panel, SHEEN_COMMAND, &step->command, 1);

        if (error == SHEEN_OK && step->count)
            error = sheen_panel_write(panel, dc, step->data, step->count);
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
    const uint8_t bytes[3] = {command, (uint8_t)first, (uint8_t)last};

    if (!sheen_panel_window_moves(panel, axis, first, last))
        return SHEEN_OK;
    return sheen_panel_write(panel, SHEEN_COMMAND, bytes, sizeof bytes);
}

int sheen_panel_resynchronise(struct sheen_panel *panel, uint8_t harmless)
{
    const uint8_t bytes[8] = {harmless, harmless, harmless, harmless, harmless, harmless, harmless, harmless};

    /* 8 parameters is the most of any command we send (B8, the SSD1325's grey table). */
    return panel->bus->reset ? SHEEN_OK : sheen_panel_write(panel, SHEEN_COMMAND, bytes, sizeof bytes);
}

int sheen_panel_init(struct sheen_panel *panel)
{
    static const uint8_t vertical_only = 0; /* a pulse a refresh, none a line */
    int error = sheen_panel_landed(panel);

    panel->ready = 0;
    panel->window_known = 0;
    if (error == SHEEN_OK)
        error = panel->record->driver->init(panel);
    if (error == SHEEN_OK && panel->tearing)
        error = sheen_panel_command(panel, panel->record->driver->tearing_command, &vertical_only, 1);
    panel->ready = error == SHEEN_OK;
    return error;
}

int sheen_panel_off(struct sheen_panel *panel)
{
    const struct sheen_panel_driver *driver = panel->record->driver;
    int error = sheen_panel_landed(panel);

    for (unsigned i = 0; panel->ready && error == SHEEN_OK && i < driver->off_count; i++)
        error = sheen_panel_command(panel, driver->off[i], NULL, 0);
    panel->ready = 0;
    return error;
}

int sheen_panel_tearing(struct sheen_panel *panel)
{
    if (!panel->record->driver->tearing_command)
        return SHEEN_ERR_UNSUPPORTED;
    panel->tearing = 1;
    panel->ready = 0;
    return SHEEN_OK;
}

/* Edges on multiples of align, or on the target's own edge. */
static int axis_fits(int first, int end, int size, int align)
{
    return first >= 0 && first < end && end <= size && first % align == 0 && (end % align == 0 || end == size);
}

static int push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    struct sheen_panel *panel = ctx;
    const struct sheen_panel_driver *driver = panel->record->driver;
    uint16_t width, height;
    int error;

    sheen_panel_size(panel->record, panel->orientation, &width, &height);
    if (!pixels || !axis_fits(rect.x0, rect.x1, width, driver->align_x) ||
        !axis_fits(rect.y0, rect.y1, height, driver->align_y))
        return SHEEN_ERR_ARGUMENT;
    error = sheen_panel_landed(panel);
    if (error == SHEEN_OK && !panel->ready)
        error = sheen_panel_init(panel);
    if (error == SHEEN_OK)
        error = driver->push(panel, rect, pixels);
    panel->ready = error == SHEEN_OK;
    return error;
}

static int wait(void *ctx)
{
    struct sheen_panel *panel = ctx;
    int error = sheen_panel_landed(panel);

    if (error < 0)
        panel->ready = 0;
    return error;
}

void sheen_panel_size(const struct sheen_panel_record *record, unsigned orientation, uint16_t *width, uint16_t *height)
{
    *width = orientation & 1 ? record->glass_h : record->glass_w;
    *height = orientation & 1 ? record->glass_w : record->glass_h;
}

unsigned sheen_panel_default_orientation(const struct sheen_panel_record *record)
{
    return record->glass_h > record->glass_w;
}

int sheen_panel_open(struct sheen_panel *panel, const struct sheen_panel_record *record, const struct sheen_bus *bus,
                     unsigned orientation)
{
    if (!panel || !record || !bus || !bus->write || !bus->delay || orientation > 7)
        return SHEEN_ERR_ARGUMENT;
    /* A row or column of whole bytes in every orientation: no driver meets half a byte. */
    unsigned per_byte = 8 / sheen_pixel_bits((enum sheen_pixel)record->pixel);
    if (per_byte && (record->glass_w % per_byte || record->glass_h % per_byte))
        return SHEEN_ERR_ARGUMENT;
    if (record->glass_w == 0 || record->glass_h == 0 || record->gap_x + record->glass_w > record->ram_w ||
        record->gap_y + record->glass_h > record->ram_h)
        return SHEEN_ERR_ARGUMENT;

    *panel = (struct sheen_panel){.record = record, .bus = bus, .orientation = (uint8_t)orientation};
    return SHEEN_OK;
}

int sheen_panel_target(struct sheen_panel *panel, struct sheen_target *target)
{
    if (!panel || !panel->record || !target)
        return SHEEN_ERR_ARGUMENT;
    *target = (struct sheen_target){.ctx = panel,
                                    .push = push,
                                    .wait = wait,
                                    .pixel = panel->record->pixel,
                                    .align_x = panel->record->driver->align_x,
                                    .align_y = panel->record->driver->align_y};
    sheen_panel_size(panel->record, panel->orientation, &target->width, &target->height);
    return SHEEN_OK;
}
