/*
 * options_module.c - makes the module's record: that of --panel, with what other options change in it.
 */
#include "options.h"

#include "../../host-sim/import/nearest.h"

/* Where pixels share a byte or an address, the gap in columns (axis 0) or rows (1) must be a multiple of this. */
static unsigned gap_step(const struct sheen_panel_record *record, unsigned axis)
{
    if (record->pixel == SHEEN_GREY16 && axis == 0)
        return record->driver == &sheen_driver_ssd1322 ? 4 : 2;
    return record->pixel == SHEEN_GREY2 && axis == 1 ? 8 : 1;
}

static int set_gap(const struct options *options, struct sheen_panel_record *record, struct sheen_failure *why)
{
    const long most[2] = {record->ram_w - record->glass_w, record->ram_h - record->glass_h};

    if (options->gap[0] < 0)
        return 0;
    if (record->driver == &sheen_driver_ssd1351)
        return sheen_failed(why, 2, "--gap: %s has none", record->name);
    for (unsigned axis = 0; axis < 2; axis++) {
        if (options->gap[axis] > most[axis])
            return sheen_failed(why, 2, "--gap %ld,%ld: %s shows %ux%u of %ux%u pixels of memory: at most %ld,%ld",
                                options->gap[0], options->gap[1], record->name, record->glass_w, record->glass_h,
                                record->ram_w, record->ram_h, most[0], most[1]);
        if (options->gap[axis] % gap_step(record, axis))
            return sheen_failed(why, 2, "--gap %ld,%ld: on %s the %s must be a multiple of %u", options->gap[0],
                                options->gap[1], record->name, axis ? "second" : "first", gap_step(record, axis));
    }
    record->gap_x = (uint16_t)options->gap[0];
    record->gap_y = (uint16_t)options->gap[1];
    return 0;
}

static int set_colours(const struct options *options, struct sheen_panel_record *record, struct sheen_failure *why)
{
    int dcs = record->driver == &sheen_driver_dcs;

    if (options->order >= 0 && !dcs && record->driver != &sheen_driver_ssd1351)
        return sheen_failed(why, 2, "--order: %s has no colours", record->name);
    if (options->invert >= 0 && !dcs)
        return sheen_failed(why, 2, "--invert: for LCDs; %s is an OLED, which needs none", record->name);
    if (options->order >= 0)
        record->bgr = (uint8_t)options->order;
    if (options->invert >= 0)
        record->inverted = (uint8_t)options->invert;
    return 0;
}

static int set_address(const struct options *options, struct sheen_panel_record *record, struct sheen_failure *why)
{
    if (options->i2c[0] && !record->i2c_address)
        return sheen_failed(why, 2, "--i2c: %s speaks SPI only", record->name);
    const long half = options->address >> 1;
    if (options->address > 0x77 && options->address % 2 == 0 && half <= 0x77)
        return sheen_failed(
            why, 2, "--address: 0x%02lx is 0x%02lx with a bit for writing, as some boards print it; give 0x%02lx",
            options->address, half, half);
    if (options->address && (options->address < 0x08 || options->address > 0x77))
        return sheen_failed(why, 2, "--address: 0x%02lx is not in 0x08..0x77", options->address);
    if (options->address)
        record->i2c_address = (uint8_t)options->address;
    return 0;
}

int options_record(const struct options *options, struct sheen_panel_record *record, struct sheen_failure *why)
{
    const struct sheen_panel_record *known = sheen_panel_find(options->panel);
    int error;

    if (!options->panel[0])
        return sheen_failed(why, 2, "--panel is missing; --panels shows which there are");
    if (!known) {
        struct sheen_nearest nearest = {.word = options->panel};
        sheen_nearest_panel(&nearest);
        return sheen_failed(why, 2, "there is no panel '%s'; --panels shows which there are, the nearest is %.*s",
                            options->panel, nearest.length, nearest.name);
    }
    *record = *known;
    if (options->clock)
        record->clock_hz = (uint32_t)options->clock;
    if (options->spi_mode >= 0)
        record->spi_mode = (uint8_t)options->spi_mode;
    if (options->brightness >= 0 && !record->brightness_command)
        return sheen_failed(why, 2, "--brightness: %s has none", record->name);
    if (options->te[0] && record->driver != &sheen_driver_dcs)
        return sheen_failed(why, 2, "--te: %s has no such output", record->name);
    error = set_gap(options, record, why);
    if (error == 0)
        error = set_colours(options, record, why);
    return error ? error : set_address(options, record, why);
}
