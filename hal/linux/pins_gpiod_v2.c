/*
 * pins_gpiod_v2.c - libgpiod 2 (Debian 13, bookworm-backports).
 */
#include "pins_gpiod.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>

static const char *or_empty(const char *text)
{
    return text ? text : "";
}

int sheen_gpiod_describe(struct gpiod_chip *chip, char *label, size_t size, unsigned *lines)
{
    struct gpiod_chip_info *info;
    int tries = SHEEN_TRIES;

    do
        info = gpiod_chip_get_info(chip);
    while (!info && sheen_again(errno, &tries));
    if (!info)
        return -1;
    snprintf(label, size, "%s", or_empty(gpiod_chip_info_get_label(info)));
    *lines = (unsigned)gpiod_chip_info_get_num_lines(info);
    gpiod_chip_info_free(info);
    return 0;
}

int sheen_gpiod_info(struct gpiod_chip *chip, unsigned offset, struct sheen_pin_info *info)
{
    struct gpiod_line_info *line;
    int tries = SHEEN_TRIES;

    do
        line = gpiod_chip_get_line_info(chip, offset);
    while (!line && sheen_again(errno, &tries));
    if (!line)
        return -1;
    snprintf(info->name, sizeof info->name, "%s", or_empty(gpiod_line_info_get_name(line)));
    snprintf(info->consumer, sizeof info->consumer, "%s", or_empty(gpiod_line_info_get_consumer(line)));
    info->used = gpiod_line_info_is_used(line);
    info->output = gpiod_line_info_get_direction(line) == GPIOD_LINE_DIRECTION_OUTPUT;
    gpiod_line_info_free(line);
    return 0;
}

static int request(struct sheen_pin *pin, unsigned offset, struct gpiod_line_settings *settings)
{
    struct gpiod_line_config *lines = gpiod_line_config_new();
    struct gpiod_request_config *config = gpiod_request_config_new();
    int tries = SHEEN_TRIES, kept;

    if (lines && config && !gpiod_line_config_add_line_settings(lines, &offset, 1, settings)) {
        gpiod_request_config_set_consumer(config, SHEEN_CONSUMER);
        do
            pin->request = gpiod_chip_request_lines(pin->chip, config, lines);
        while (!pin->request && sheen_again(errno, &tries));
    }
    kept = errno; /* the calls below may change errno */
    gpiod_request_config_free(config);
    gpiod_line_config_free(lines);
    errno = kept;
    return pin->request ? 0 : -1;
}

int sheen_gpiod_output(struct sheen_pin *pin, unsigned offset)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    int error = settings ? 0 : -1;

    if (!error)
        error = gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT);
    if (!error)
        error = gpiod_line_settings_set_output_value(settings,
                                                     pin->level ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE);
    if (!error)
        error = request(pin, offset, settings);
    gpiod_line_settings_free(settings);
    return error;
}

int sheen_gpiod_rising(struct sheen_pin *pin, unsigned offset)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    int error = settings ? 0 : -1;

    if (!error)
        error = gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_INPUT);
    if (!error)
        error = gpiod_line_settings_set_edge_detection(settings, GPIOD_LINE_EDGE_RISING);
    if (!error)
        error = request(pin, offset, settings);
    gpiod_line_settings_free(settings);
    return error;
}

/* The request has one line only, so set_values needs no offset. */
int sheen_gpiod_set(struct sheen_pin *pin, int level)
{
    const enum gpiod_line_value value = level ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
    int tries = SHEEN_TRIES, error;

    do
        error = gpiod_line_request_set_values(pin->request, &value);
    while (error && sheen_again(errno, &tries));
    return error;
}

int sheen_gpiod_edge(struct sheen_pin *pin, uint32_t timeout_us)
{
    struct gpiod_edge_event_buffer *buffer = gpiod_edge_event_buffer_new(1);

    if (!buffer)
        return -1;
    int found = gpiod_line_request_wait_edge_events(pin->request, (int64_t)timeout_us * 1000);
    if (found > 0)
        found = gpiod_line_request_read_edge_events(pin->request, buffer, 1);
    gpiod_edge_event_buffer_free(buffer);
    return found;
}

void sheen_gpiod_release(struct sheen_pin *pin)
{
    if (pin->request)
        gpiod_line_request_release(pin->request);
}

const char *sheen_pins_version(void)
{
    return gpiod_api_version();
}
