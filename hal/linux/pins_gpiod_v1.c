/*
 * pins_gpiod_v1.c - libgpiod 1.6 (Debian 12, Raspberry Pi OS of 2023).
 *
 * A line's handle is part of its chip, so the chip must stay open as long as the
 * line is used; gpiod_chip_close would release the line.
 */
#include "pins_gpiod.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <time.h>

static const char *or_empty(const char *text)
{
    return text ? text : "";
}

int sheen_gpiod_describe(struct gpiod_chip *chip, char *label, size_t size, unsigned *lines)
{
    snprintf(label, size, "%s", or_empty(gpiod_chip_label(chip)));
    *lines = gpiod_chip_num_lines(chip);
    return 0;
}

/* The first call for a line asks the kernel about it, so it can be interrupted. */
static struct gpiod_line *line_of(struct gpiod_chip *chip, unsigned offset)
{
    struct gpiod_line *line;
    int tries = SHEEN_TRIES;

    do
        line = gpiod_chip_get_line(chip, offset);
    while (!line && sheen_again(errno, &tries));
    return line;
}

int sheen_gpiod_info(struct gpiod_chip *chip, unsigned offset, struct sheen_pin_info *info)
{
    struct gpiod_line *line = line_of(chip, offset);

    if (!line)
        return -1;
    snprintf(info->name, sizeof info->name, "%s", or_empty(gpiod_line_name(line)));
    snprintf(info->consumer, sizeof info->consumer, "%s", or_empty(gpiod_line_consumer(line)));
    info->used = gpiod_line_is_used(line);
    info->output = gpiod_line_direction(line) == GPIOD_LINE_DIRECTION_OUTPUT;
    return 0;
}

static int request(struct sheen_pin *pin, unsigned offset, int type)
{
    const struct gpiod_line_request_config config = {.consumer = SHEEN_CONSUMER, .request_type = type};
    struct gpiod_line *line = line_of(pin->chip, offset);
    int tries = SHEEN_TRIES, error;

    if (!line)
        return -1;
    do
        error = gpiod_line_request(line, &config, pin->level);
    while (error && sheen_again(errno, &tries));
    pin->line = error ? NULL : line;
    return error;
}

int sheen_gpiod_output(struct sheen_pin *pin, unsigned offset)
{
    return request(pin, offset, GPIOD_LINE_REQUEST_DIRECTION_OUTPUT);
}

int sheen_gpiod_rising(struct sheen_pin *pin, unsigned offset)
{
    return request(pin, offset, GPIOD_LINE_REQUEST_EVENT_RISING_EDGE);
}

int sheen_gpiod_set(struct sheen_pin *pin, int level)
{
    int tries = SHEEN_TRIES, error;

    do
        error = gpiod_line_set_value(pin->line, level);
    while (error && sheen_again(errno, &tries));
    return error;
}

int sheen_gpiod_edge(struct sheen_pin *pin, uint32_t timeout_us)
{
    const struct timespec timeout = {.tv_sec = timeout_us / 1000000, .tv_nsec = timeout_us % 1000000 * 1000L};
    struct gpiod_line_event event;
    int found = gpiod_line_event_wait(pin->line, &timeout);

    return found > 0 && gpiod_line_event_read(pin->line, &event) ? -1 : found;
}

void sheen_gpiod_release(struct sheen_pin *pin)
{
    if (pin->line)
        gpiod_line_release(pin->line);
}

const char *sheen_pins_version(void)
{
    return gpiod_version_string();
}
