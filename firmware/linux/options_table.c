/*
 * options_table.c - the table of options, and storing a value in its field.
 */
#include "options_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FIELD(name) offsetof(struct options, name)

const struct option_row option_rows[] = {
    {NULL, TEXT, 0, 0, 0, NULL,
     "Wiring. A GPIO line is given as chip:offset (gpiochip0:25) or by name (GPIO25); --list shows them."},
    {"panel", TEXT, FIELD(panel), 0, 0, "NAME", "controller and glass, as st7789-240x240; --panels lists them"},
    {"orientation", WHOLE, FIELD(orientation), 0, 7, "0..7",
     "0..3: quarter turns, 4..7: the same mirrored [landscape]"},
    {"spi", TEXT, FIELD(spi), 0, 0, "PATH", "SPI device, as /dev/spidev0.0"},
    {"clock", WHOLE, FIELD(clock), 1000, 200e6, "HZ", "clock of the SPI device [the panel's rated clock]"},
    {"spi-mode", WHOLE, FIELD(spi_mode), 0, 3, "0..3", "SPI mode [the panel's; 3 for ST7789 modules without CS]"},
    {"i2c", TEXT, FIELD(i2c), 0, 0, "PATH", "I2C bus, as /dev/i2c-1, instead of --spi and --dc: for OLEDs"},
    {"address", WHOLE, FIELD(address), 1, 255, "N", "I2C address, 0x3c or 0x3d [the panel's: 0x3c]"},
    {"sclk", TEXT, FIELD(sclk), 0, 0, "LINE", "clock (SCL) of a bit-banged SPI, instead of --spi"},
    {"mosi", TEXT, FIELD(mosi), 0, 0, "LINE", "data (SDA) of a bit-banged SPI"},
    {"cs", TEXT, FIELD(cs), 0, 0, "LINE", "chip select [the SPI device's; none if bit-banged]"},
    {"dc", TEXT, FIELD(dc), 0, 0, "LINE", "data/command (also RS, A0)"},
    {"reset", TEXT, FIELD(reset), 0, 0, "LINE", "reset (RST) [reset by a command]"},
    {"backlight", TEXT, FIELD(backlight), 0, 0, "LINE", "backlight (BL), on while the program runs"},
    {"te", TEXT, FIELD(te), 0, 0, "LINE", "tearing effect (TE), an input: frames begin at its rising edge"},
    {NULL, TEXT, 0, 0, 0, NULL, "How the module differs from --panel's record; defaults are the record's."},
    {"gap", PAIR, FIELD(gap), 0, 1000, "X,Y",
     "columns and rows of the controller's memory before the glass, held upright"},
    {"invert", WORD, FIELD(invert), 0, 0, "off|on", "on if the colours look like a negative without it"},
    {"order", WORD, FIELD(order), 0, 0, "rgb|bgr", "take the other one if red and blue are swapped"},
    {"brightness", WHOLE, FIELD(brightness), 0, 255, "0..255", "if the controller has it"},
    {NULL, TEXT, 0, 0, 0, NULL, "Running."},
    {"first-light", SWITCH, FIELD(first_light), 0, 0, NULL, "show a test picture: border, corner marks, colour bars"},
    {"frames", WHOLE, FIELD(frames), 1, 1000000000, "N", "end after N frames [never]"},
    {"fps", NUMBER, FIELD(fps), 0.01, 1000, "N", "at most N frames a second [as fast as it goes]"},
    {"buffers", WHOLE, FIELD(buffers), 1, 2, "1|2", "2: draw a band while the last one is sent [2]"},
    {"quiet", SWITCH, FIELD(quiet), 0, 0, NULL, "no statistics on standard error"},
    {"config", ONLY_HERE, 0, 0, 0, "FILE", "first read options from a file with lines `name = value`"},
    {NULL, TEXT, 0, 0, 0, NULL, "Other."},
    {"list", SWITCH, FIELD(list), 0, 0, NULL, "list GPIO chips, their lines and who uses them"},
    {"panels", SWITCH, FIELD(panels), 0, 0, NULL, "list the panels"},
    {"help", SWITCH, FIELD(help), 0, 0, NULL, "show this help"},
    {"man", SWITCH, FIELD(man), 0, 0, NULL, "print a manual page in roff"},
    {"version", SWITCH, FIELD(version), 0, 0, NULL, "show the versions of sheen and libgpiod"},
    {NULL, TEXT, 0, 0, 0, NULL, NULL},
};

/* All options of `sheen render`, except those that the panel or the rows above decide. */
int option_is_view(const struct sheen_option *option)
{
    static const char *const others[] = {"output", "panel", "size", "orientation", "buffers", "frames", "stats"};

    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        if (strcmp(option->name, others[i]) == 0)
            return 0;
    return (option->commands & SHEEN_RENDER) != 0;
}

static const struct sheen_option *view_of(const char *name)
{
    for (const struct sheen_option *option = sheen_option_table; option->name; option++)
        if (strcmp(option->name, name) == 0 && option_is_view(option))
            return option;
    return NULL;
}

static const struct option_row *row_of(const char *name)
{
    for (const struct option_row *row = option_rows; row->help; row++)
        if (row->name && strcmp(row->name, name) == 0)
            return row;
    return NULL;
}

static int set_text(struct options *options, const struct option_row *row, const char *value, struct sheen_failure *why)
{
    if (value[0] == '\0' || strlen(value) >= OPTIONS_TEXT)
        return sheen_failed(why, -1, "%s: from 1 to %d characters", row->name, OPTIONS_TEXT - 1);
    strcpy((char *)options + row->field, value);
    return 0;
}

static int set_number(struct options *options, const struct option_row *row, const char *value,
                      struct sheen_failure *why)
{
    char *end;
    double number = strtod(value, &end);

    if (end == value || *end != '\0' || !isfinite(number) || (row->kind == WHOLE && number != floor(number)))
        return sheen_failed(why, -1, "%s: '%s' is not a %snumber", row->name, value,
                            row->kind == WHOLE ? "whole " : "");
    if (number < row->min || number > row->max)
        return sheen_failed(why, -1, "%s: %s is not in %.12g..%.12g", row->name, value, row->min, row->max);
    if (row->kind == WHOLE)
        *(long *)(void *)((char *)options + row->field) = (long)number;
    else
        *(double *)(void *)((char *)options + row->field) = number;
    return 0;
}

static int set_pair(struct options *options, const struct option_row *row, const char *value, struct sheen_failure *why)
{
    long *pair = (long *)(void *)((char *)options + row->field);
    char *end, *last;

    pair[0] = strtol(value, &end, 10);
    pair[1] = *end == ',' ? strtol(end + 1, &last, 10) : 0;
    if (end == value || *end != ',' || last == end + 1 || *last != '\0')
        return sheen_failed(why, -1, "%s: '%s' is not of the form %s", row->name, value, row->value);
    for (int i = 0; i < 2; i++)
        if (pair[i] < row->min || pair[i] > row->max)
            return sheen_failed(why, -1, "%s: %s is not in %.12g..%.12g", row->name, value, row->min, row->max);
    return 0;
}

static int set_word(struct options *options, const struct option_row *row, const char *value, struct sheen_failure *why)
{
    size_t length = strlen(value);
    const char *word = row->value;

    for (long number = 0; word; number++) {
        if (length && strncmp(word, value, length) == 0 && (word[length] == '|' || word[length] == '\0')) {
            *(long *)(void *)((char *)options + row->field) = number;
            return 0;
        }
        word = strchr(word, '|');
        word = word ? word + 1 : NULL;
    }
    return sheen_failed(why, -1, "%s '%s': not one of %s", row->name, value, row->value);
}

int option_set_row(struct options *options, const struct option_row *row, const char *value, struct sheen_failure *why)
{
    switch (row->kind) {
    case TEXT:
        return set_text(options, row, value, why);
    case WHOLE:
    case NUMBER:
        return set_number(options, row, value, why);
    case PAIR:
        return set_pair(options, row, value, why);
    case WORD:
        return set_word(options, row, value, why);
    case SWITCH:
        if (value && strcmp(value, "yes") != 0 && strcmp(value, "no") != 0)
            return sheen_failed(why, -1, "%s: '%s' is neither yes nor no", row->name, value);
        *(long *)(void *)((char *)options + row->field) = !value || value[0] == 'y';
        return 0;
    case ONLY_HERE:
        break;
    }
    return 0;
}

int option_set_view(struct options *options, const struct sheen_option *option, const char *value,
                    struct sheen_failure *why)
{
    struct sheen_problem problem;

    if (sheen_option_set(&options->view, option, value, &problem) == 0)
        return 0;
    return sheen_failed(why, -1, "%s", problem.text + strspn(problem.text, "-"));
}

int options_set(struct options *options, const char *name, const char *value, struct sheen_failure *why)
{
    const struct option_row *row = row_of(name);
    const struct sheen_option *view = view_of(name);

    if (strcmp(name, "mesh") == 0) {
        snprintf(options->mesh, sizeof options->mesh, "%s", value);
        return 0;
    }
    if (row && row->kind != ONLY_HERE)
        return option_set_row(options, row, value, why);
    if (!view)
        return sheen_failed(why, -1, "there is no option '%.60s'", name);
    if (view->argument)
        return option_set_view(options, view, value, why);
    if (strcmp(value, "yes") != 0)
        return strcmp(value, "no") == 0 ? 0 : sheen_failed(why, -1, "%s: '%s' is neither yes nor no", name, value);
    return option_set_view(options, view, NULL, why);
}
