/*
 * panel.c - what all panels share: opening, the target's push and wait, off and on, turning.
 *
 * After any error the panel counts as unknown: its next push resets and
 * initialises it, since a controller that missed bytes (or its power) shows
 * nothing that a write-only bus could notice.
 */
#include "drivers/driver.h"

/* The bus is given back, unless pixels still fly. */
int sheen_panel_give(struct sheen_panel *panel, int error)
{
    if (error < 0)
        panel->ready = 0;
    if (panel->held && !panel->flying) {
        panel->held = 0;
        if (panel->bus->release)
            panel->bus->release(panel->bus->ctx);
    }
    return error;
}

int sheen_panel_take(struct sheen_panel *panel)
{
    int error = sheen_panel_give(panel, sheen_panel_landed(panel));

    if (error == SHEEN_OK && panel->bus->acquire)
        error = panel->bus->acquire(panel->bus->ctx);
    panel->held = error == SHEEN_OK;
    return error < 0 ? sheen_panel_give(panel, error) : error;
}

/* From any state to a lit panel; the bus is held. */
static int initialise(struct sheen_panel *panel)
{
    int error;

    panel->ready = 0;
    panel->window_known = 0;
    error = panel->record->driver->init(panel);
    if (error == SHEEN_OK && panel->settings)
        error = panel->settings(panel);
    panel->ready = error == SHEEN_OK;
    return error;
}

int sheen_panel_init(struct sheen_panel *panel)
{
    int error = sheen_panel_take(panel);

    return error < 0 ? error : sheen_panel_give(panel, initialise(panel));
}

/* A panel that was never lit, or is in an unknown state, is not spoken to. */
int sheen_panel_off(struct sheen_panel *panel)
{
    const struct sheen_panel_driver *driver = panel->record->driver;
    int error = panel->ready ? sheen_panel_take(panel) : sheen_panel_give(panel, sheen_panel_landed(panel));

    for (unsigned i = 0; panel->ready && error == SHEEN_OK && i < driver->off_count; i++)
        error = sheen_panel_command(panel, driver->off[i], NULL, 0);
    error = sheen_panel_give(panel, error);
    panel->ready = 0;
    return error;
}

int sheen_panel_turn(struct sheen_panel *panel, unsigned orientation)
{
    const struct sheen_panel_driver *driver = panel->record->driver;
    int error;

    if (orientation > 7)
        return SHEEN_ERR_ARGUMENT;
    error = panel->ready ? sheen_panel_take(panel) : SHEEN_OK;
    panel->orientation = (uint8_t)orientation;
    panel->window_known = 0;
    if (error == SHEEN_OK && panel->ready && driver->orient)
        error = driver->orient(panel);
    return sheen_panel_give(panel, error);
}

/* Edges on multiples of align (a power of 2), or on the target's own edge. */
static int axis_fits(int first, int end, int size, int align)
{
    return first >= 0 && first < end && end <= size && (first & (align - 1)) == 0 &&
           ((end & (align - 1)) == 0 || end == size);
}

/* Collects the push before, whose buffer may be this one's; a bad rectangle leaves the panel as it is. */
static int panel_push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    struct sheen_panel *panel = ctx;
    const struct sheen_panel_driver *driver = panel->record->driver;
    uint16_t width, height;
    int error;

    sheen_panel_size(panel->record, panel->orientation, &width, &height);
    if (!pixels || !axis_fits(rect.x0, rect.x1, width, driver->align_x) ||
        !axis_fits(rect.y0, rect.y1, height, driver->align_y))
        return SHEEN_ERR_ARGUMENT;
    error = sheen_panel_take(panel);
    if (error < 0)
        return error;
    if (!panel->ready)
        error = initialise(panel);
    if (error == SHEEN_OK && panel->due)
        error = panel->due(panel);
    panel->due = NULL;
    if (error == SHEEN_OK)
        error = driver->push(panel, rect, pixels);
    return sheen_panel_give(panel, error);
}

static int panel_wait(void *ctx)
{
    struct sheen_panel *panel = ctx;

    return sheen_panel_give(panel, sheen_panel_landed(panel));
}

void sheen_panel_size(const struct sheen_panel_record *record, unsigned orientation, uint16_t *width, uint16_t *height)
{
    *width = orientation & 1 ? record->glass_h : record->glass_w;
    *height = orientation & 1 ? record->glass_w : record->glass_h;
}

/* Most boards hold tall glass sideways. */
unsigned sheen_panel_default_orientation(const struct sheen_panel_record *record)
{
    return record->glass_h > record->glass_w;
}

/* Pixels in a byte, by enum sheen_pixel; 0 where one has 16 bits. */
static const uint8_t byte_pixels[] = {0, 0, 8, 2, 1};

/*
 * The glass lies inside the RAM, and no driver ever meets half a byte: rows and
 * columns of whole bytes in every orientation, and the gap on a byte's edge (2 px
 * side by side, or 8 on top of each other), on an address's where that is more.
 */
static int record_fits(const struct sheen_panel_record *record)
{
    unsigned per_byte = byte_pixels[record->pixel];
    unsigned align = record->driver->align_x > per_byte ? record->driver->align_x : per_byte;
    unsigned gap = per_byte == 8 ? record->gap_y : record->gap_x;

    if ((record->glass_w | record->glass_h | gap) & (align - 1)) /* align is a power of 2 */
        return 0;
    return record->glass_w && record->glass_h && record->gap_x + record->glass_w <= record->ram_w &&
           record->gap_y + record->glass_h <= record->ram_h;
}

int sheen_panel_open(struct sheen_panel *panel, const struct sheen_panel_record *record, const struct sheen_bus *bus,
                     unsigned orientation)
{
    if (!panel || !record || !bus || !bus->send || !bus->delay || orientation > 7)
        return SHEEN_ERR_ARGUMENT;
    if (!record->driver || !record_fits(record))
        return SHEEN_ERR_ARGUMENT;
    *panel = (struct sheen_panel){.record = record, .bus = bus, .orientation = (uint8_t)orientation};
    return SHEEN_OK;
}

int sheen_panel_target(struct sheen_panel *panel, struct sheen_target *target)
{
    if (!panel || !panel->record || !target)
        return SHEEN_ERR_ARGUMENT;
    *target = (struct sheen_target){.ctx = panel,
                                    .push = panel_push,
                                    .wait = panel_wait,
                                    .pixel = panel->record->pixel,
                                    .align_x = panel->record->driver->align_x,
                                    .align_y = panel->record->driver->align_y};
    sheen_panel_size(panel->record, panel->orientation, &target->width, &target->height);
    return SHEEN_OK;
}
