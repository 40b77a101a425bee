/*
 * panel.c - what all panels share: opening, the target's push and wait, off and on, turning.
 *
 * After any error the controller's state counts as unknown, and the next push resets
 * and initialises it: a write-only bus cannot find out whether the controller missed
 * bytes or lost its power.
 */
#include "drivers/driver.h"

/* Releases the bus, unless pixels are still under way. Codes above 0, as vendors' libraries use, are errors too. */
int sheen_panel_give(struct sheen_panel *panel)
{
    if (panel->error > 0)
        panel->error = SHEEN_ERR_BUS;
    if (panel->error < 0)
        panel->ready = 0;
    if (panel->held && !panel->in_flight) {
        panel->held = 0;
        if (panel->bus->release)
            panel->bus->release(panel->bus->ctx);
    }
    return panel->error;
}

/* Clears the error of earlier calls, then waits for the push under way, if any; returns its error. */
static int end_push(struct sheen_panel *panel)
{
    panel->error = SHEEN_OK;
    sheen_panel_await(panel);
    return sheen_panel_give(panel);
}

int sheen_panel_take(struct sheen_panel *panel)
{
    if (end_push(panel) == SHEEN_OK) {
        if (panel->bus->acquire)
            panel->error = panel->bus->acquire(panel->bus->ctx);
        panel->held = panel->error == SHEEN_OK;
    }
    return panel->error;
}

/* Forgets the window that was last sent, so that the next push sends both of its axes. */
static void forget_window(struct sheen_panel *panel)
{
    panel->window[0] = panel->window[1] = UINT32_MAX;
}

/* Brings the panel from any state to lit; the bus is held. After an error sheen_panel_give() clears `ready` again. */
static void initialise(struct sheen_panel *panel)
{
    forget_window(panel);
    panel->lit = 1; /* even if it fails: the glass may have been lit by then, or before */
    panel->record->driver->init(panel);
    if (panel->apply_settings)
        panel->apply_settings(panel);
    panel->ready = 1;
}

int sheen_panel_init(struct sheen_panel *panel)
{
    sheen_panel_take(panel);
    initialise(panel);
    return sheen_panel_give(panel);
}

/*
 * Makes a controller in an unknown state take commands again, as an initialisation does. A reset darkens the glass;
 * without one, a command that was cut off would swallow the one that does.
 */
static void regain(struct sheen_panel *panel)
{
    const struct sheen_panel_driver *driver = panel->record->driver;

    sheen_panel_reset(panel);
    if (driver->command == sheen_panel_low_command)
        sheen_panel_resynchronise(panel, driver->off[0]);
}

/* Sends nothing to a panel that was never lit. An error of the push under way is returned, but leaves no panel lit. */
int sheen_panel_off(struct sheen_panel *panel)
{
    const struct sheen_panel_driver *driver = panel->record->driver;
    int earlier = end_push(panel);

    if (panel->lit && sheen_panel_take(panel) == SHEEN_OK) {
        if (!panel->ready)
            regain(panel);
        for (unsigned i = 0; i < driver->off_count; i++)
            driver->command(panel, driver->off[i], NULL, 0);
        panel->lit = sheen_panel_give(panel) != SHEEN_OK;
    }
    panel->ready = 0;
    return earlier != SHEEN_OK ? earlier : panel->error;
}

int sheen_panel_turn(struct sheen_panel *panel, unsigned orientation)
{
    const struct sheen_panel_driver *driver = panel->record->driver;

    if (orientation > 7)
        return SHEEN_ERR_ARGUMENT;
    panel->error = SHEEN_OK;
    if (panel->ready)
        sheen_panel_take(panel);
    panel->orientation = (uint8_t)orientation;
    forget_window(panel);
    if (panel->ready && driver->orient)
        driver->orient(panel);
    return sheen_panel_give(panel);
}

/* Not empty, inside the picture, edges on multiples of the driver's align. A negative edge becomes huge as unsigned. */
static int rect_fits(const struct sheen_panel *panel, const struct sheen_rect *rect)
{
    unsigned x0 = (unsigned)rect->x0, x1 = (unsigned)rect->x1, y0 = (unsigned)rect->y0, y1 = (unsigned)rect->y1;
    uint16_t width, height;

    sheen_panel_size(panel->record, panel->orientation, &width, &height);
    return x0 < x1 && x1 <= width && y0 < y1 && y1 <= height &&
           ((x0 | x1 | y0 | y1) & (panel->record->driver->align - 1u)) == 0;
}

/* Waits for the previous push first, as it may use the same buffer. A bad rectangle leaves the panel as it is. */
static int panel_push(void *ctx, struct sheen_rect rect, const void *pixels)
{
    struct sheen_panel *panel = ctx;

    if (!pixels || !rect_fits(panel, &rect))
        return SHEEN_ERR_ARGUMENT;
    if (sheen_panel_take(panel) == SHEEN_OK) {
        if (!panel->ready)
            initialise(panel);
        if (panel->before_push)
            panel->before_push(panel);
        panel->before_push = NULL;
        panel->record->driver->push(panel, &rect, pixels);
    }
    return sheen_panel_give(panel);
}

static int panel_wait(void *ctx)
{
    return end_push(ctx);
}

void sheen_panel_size(const struct sheen_panel_record *record, unsigned orientation, uint16_t *width, uint16_t *height)
{
    *width = orientation & 1 ? record->glass_h : record->glass_w;
    *height = orientation & 1 ? record->glass_w : record->glass_h;
}

/* Most boards mount tall glass sideways. */
unsigned sheen_panel_default_orientation(const struct sheen_panel_record *record)
{
    return record->glass_h > record->glass_w;
}

/*
 * The glass lies inside the RAM, the pixel format is the driver's, and no rectangle splits a
 * byte or address: width and height are multiples of align in every orientation, and so is the
 * gap, along x if a byte's pixels are side by side, along y if they are 8 on top of each other.
 */
static int record_fits(const struct sheen_panel_record *record)
{
    unsigned align = record->driver->align, gap = align == 8 ? record->gap_y : record->gap_x;

    return record->pixel == record->driver->pixel && record->glass_w && record->glass_h &&
           record->gap_x + record->glass_w <= record->ram_w && record->gap_y + record->glass_h <= record->ram_h &&
           ((record->glass_w | record->glass_h | gap) & (align - 1)) == 0; /* align is a power of 2 */
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
    target->ctx = panel;
    target->push = panel_push;
    target->wait = panel_wait;
    target->pixel = panel->record->pixel;
    target->align_x = target->align_y = panel->record->driver->align;
    sheen_panel_size(panel->record, panel->orientation, &target->width, &target->height);
    return SHEEN_OK;
}
