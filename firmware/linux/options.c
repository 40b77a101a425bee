/*
 * options.c - getopt_long, the configuration file and the help text read the same two tables: the one
 * here for wiring and running, and the command's own (host-sim/options.h) for what the mesh looks like.
 */
#include "options.h"

#include "panel.h"

#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum kind {
    TEXT,
    WHOLE,
    NUMBER,
    SWITCH,
    ONLY_HERE
};

struct option_row {
    const char *name;
    enum kind kind; /* SWITCH takes no value on the command line; ONLY_HERE is a TEXT that no file may hold */
    size_t field;   /* offset in struct options */
    double min, max;
    const char *value, *help; /* as in the help text */
};

#define FIELD(name) offsetof(struct options, name)

static const struct option_row rows[] = {
    {NULL, TEXT, 0, 0, 0, NULL,
     "Wiring. A line is chip:offset (gpiochip0:25) or its name (GPIO25); --list shows them."},
    {"panel", TEXT, FIELD(panel), 0, 0, "NAME", "controller and glass, st7789-240x240; --panels shows them"},
    {"orientation", WHOLE, FIELD(orientation), 0, 7, "0..7", "quarter turns, 4..7 mirrored [landscape]"},
    {"spi", TEXT, FIELD(spi), 0, 0, "PATH", "SPI device, /dev/spidev0.0"},
    {"clock", WHOLE, FIELD(clock), 1000, 200e6, "HZ", "its clock [the panel's rated one]"},
    {"spi-mode", WHOLE, FIELD(spi_mode), 0, 3, "0..3", "its mode [the panel's; 3 for ST7789 modules without CS]"},
    {"sclk", TEXT, FIELD(sclk), 0, 0, "LINE", "in place of --spi: SPI by hand, its clock (SCL)"},
    {"mosi", TEXT, FIELD(mosi), 0, 0, "LINE", "and its data (SDA)"},
    {"cs", TEXT, FIELD(cs), 0, 0, "LINE", "chip select [the SPI device's; none by hand]"},
    {"dc", TEXT, FIELD(dc), 0, 0, "LINE", "data/command (also RS, A0)"},
    {"reset", TEXT, FIELD(reset), 0, 0, "LINE", "reset (RST) [reset by command]"},
    {"backlight", TEXT, FIELD(backlight), 0, 0, "LINE", "backlight (BL), on while the program runs"},
    {"te", TEXT, FIELD(te), 0, 0, "LINE", "tearing effect (TE), an input: frames begin at its rising edge"},
    {NULL, TEXT, 0, 0, 0, NULL, "Running."},
    {"first-light", SWITCH, FIELD(first_light), 0, 0, NULL, "a test picture: border, corner marks, colour bars"},
    {"frames", WHOLE, FIELD(frames), 1, 1000000000, "N", "end after N frames [never]"},
    {"fps", NUMBER, FIELD(fps), 0.01, 1000, "N", "at most N frames a second [as fast as it goes]"},
    {"buffers", WHOLE, FIELD(buffers), 1, 2, "1|2", "2: draw a band while the last one is sent [2]"},
    {"quiet", SWITCH, FIELD(quiet), 0, 0, NULL, "no statistics on standard error"},
    {"config", ONLY_HERE, 0, 0, 0, "FILE", "read options from a file first: lines of `name = value`"},
    {NULL, TEXT, 0, 0, 0, NULL, "Other."},
    {"list", SWITCH, FIELD(list), 0, 0, NULL, "show GPIO chips, their lines and who holds them"},
    {"panels", SWITCH, FIELD(panels), 0, 0, NULL, "show the panels"},
    {"help", SWITCH, FIELD(help), 0, 0, NULL, "show this"},
    {"version", SWITCH, FIELD(version), 0, 0, NULL, "show the version of sheen and of libgpiod"},
};
#define ROWS (sizeof rows / sizeof rows[0])

/* Of the command's table, what the panel itself, the file and the rows above decide. */
static int is_view(const struct sheen_option *option)
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
        if (strcmp(option->name, name) == 0 && is_view(option))
            return option;
    return NULL;
}

static const struct option_row *row_of(const char *name)
{
    for (size_t i = 0; i < ROWS; i++)
        if (rows[i].name && strcmp(rows[i].name, name) == 0)
            return &rows[i];
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

/* value: NULL for a switch on the command line. */
static int set(struct options *options, const struct option_row *row, const char *value, struct sheen_failure *why)
{
    switch (row->kind) {
    case TEXT:
        return set_text(options, row, value, why);
    case WHOLE:
    case NUMBER:
        return set_number(options, row, value, why);
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

static int set_view(struct options *options, const struct sheen_option *option, const char *value,
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
        return set(options, row, value, why);
    if (!view)
        return sheen_failed(why, -1, "there is no option '%.60s'", name);
    if (view->argument)
        return set_view(options, view, value, why);
    if (strcmp(value, "yes") != 0)
        return strcmp(value, "no") == 0 ? 0 : sheen_failed(why, -1, "%s: '%s' is neither yes nor no", name, value);
    return set_view(options, view, NULL, why);
}

#define VIEW 1000 /* getopt_long's value of an option: its row, or VIEW and its place in the command's table */
#define MAX_OPTIONS 96

static void long_options(struct option table[MAX_OPTIONS])
{
    size_t count = 0;

    for (size_t i = 0; i < ROWS; i++)
        if (rows[i].name)
            table[count++] =
                (struct option){rows[i].name, rows[i].kind == SWITCH ? no_argument : required_argument, NULL, (int)i};
    for (int i = 0; sheen_option_table[i].name && count < MAX_OPTIONS - 1; i++)
        if (is_view(&sheen_option_table[i]))
            table[count++] =
                (struct option){sheen_option_table[i].name,
                                sheen_option_table[i].argument ? required_argument : no_argument, NULL, VIEW + i};
    table[count] = (struct option){0};
}

/* After getopt_long returned '?': optopt is a letter, the value of an option that takes no argument, or 0. */
static int unknown(char **argv, struct sheen_failure *why)
{
    if (optopt < VIEW && isgraph(optopt))
        return sheen_failed(why, 2, "unknown option -%c", optopt);
    if (optopt > 0)
        return sheen_failed(why, 2, "--%s takes no value",
                            optopt >= VIEW ? sheen_option_table[optopt - VIEW].name : rows[optopt].name);
    return sheen_failed(why, 2, "unknown or ambiguous option %s", argv[optind - 1]);
}

/* The whole command line; of --config the value is left in *config. */
static int read_arguments(struct options *options, int argc, char **argv, const char **config,
                          struct sheen_failure *why)
{
    struct option table[MAX_OPTIONS];
    struct sheen_failure what;
    int value, error;

    long_options(table);
    optind = 0; /* GNU: start anew, so that it can be read twice */
    opterr = 0;
    while ((value = getopt_long(argc, argv, ":", table, NULL)) != -1) {
        if (value == ':')
            return sheen_failed(why, 2, "%s needs a value", argv[optind - 1]);
        if (value == '?')
            return unknown(argv, why);
        if (value < VIEW && rows[value].kind == ONLY_HERE) {
            *config = optarg;
            continue;
        }
        error = value < VIEW ? set(options, &rows[value], optarg, &what)
                             : set_view(options, &sheen_option_table[value - VIEW], optarg, &what);
        if (error)
            return sheen_failed(why, 2, "--%s", what.text);
    }
    if (optind < argc - 1)
        return sheen_failed(why, 2, "one mesh, not '%s' and '%s'", argv[optind], argv[optind + 1]);
    if (optind < argc)
        snprintf(options->mesh, sizeof options->mesh, "%s", argv[optind]);
    return 0;
}

static int set_defaults(struct options *options, struct sheen_failure *why)
{
    static const struct sheen_command render = {.bit = SHEEN_RENDER};
    static char name[] = "sheen-panel", mesh[] = "builtin:teapot";
    char *arguments[] = {name, mesh, NULL};
    struct sheen_problem problem;

    *options = (struct options){.spi_mode = -1, .orientation = -1, .buffers = 2};
    strcpy(options->mesh, mesh);
    if (sheen_options_parse(&options->view, &render, 2, arguments, &problem) < 0)
        return sheen_failed(why, 1, "%s", problem.text);
    return 0;
}

/* What belongs to the view and is written elsewhere. */
static void complete(struct options *options)
{
    options->view.mesh = options->mesh;
    options->view.buffers = (int)options->buffers;
}

int options_read(struct options *options, int argc, char **argv, struct sheen_failure *why)
{
    const char *config = NULL;
    int error = set_defaults(options, why);

    /* Once for --config and for faults, then over what the file says. */
    if (!error)
        error = read_arguments(options, argc, argv, &config, why);
    if (!error && config) {
        error = set_defaults(options, why);
        if (!error)
            error = options_read_file(options, config, why);
        if (!error)
            error = read_arguments(options, argc, argv, &config, why);
    }
    complete(options);
    return error;
}

int options_check(const struct options *options, struct sheen_failure *why)
{
    const struct sheen_panel_record *record = sheen_panel_find(options->panel);
    uint16_t width, height;

    if (!options->panel[0])
        return sheen_failed(why, 2, "--panel is missing; --panels shows which there are");
    if (!record)
        return sheen_failed(why, 2, "there is no panel '%s'; --panels shows which there are", options->panel);
    if (!options->dc[0])
        return sheen_failed(why, 2, "--dc is missing: the line that tells data from commands");
    if (!options->spi[0] == !(options->sclk[0] && options->mosi[0]))
        return sheen_failed(why, 2, "either --spi, or --sclk and --mosi");
    sheen_panel_size(record, options_orientation(options), &width, &height);
    if (options->view.band > height)
        return sheen_failed(why, 2, "--band %d: the panel has %u rows", options->view.band, height);
    return 0;
}

unsigned options_orientation(const struct options *options)
{
    if (options->orientation >= 0)
        return (unsigned)options->orientation;
    return sheen_panel_default_orientation(sheen_panel_find(options->panel));
}

static void help_line(const char *name, const char *value, const char *text, const char *standard)
{
    char left[64];

    snprintf(left, sizeof left, "--%s%s%s", name, value ? " " : "", value ? value : "");
    printf("  %-30s %s", left, text);
    if (standard)
        printf("%s[%s]", *text ? " " : "", standard);
    putchar('\n');
}

void options_help(void)
{
    printf("Usage: sheen-panel [MESH] --panel NAME [OPTION]...\n"
           "Shows a turning mesh on a small panel that is wired to this board.\n");
    for (size_t i = 0; i < ROWS; i++) {
        if (rows[i].name)
            help_line(rows[i].name, rows[i].value, rows[i].help, NULL);
        else
            printf("\n%s\n", rows[i].help);
    }
    printf("\nWhat the mesh looks like, as for `sheen render`.\n");
    for (const struct sheen_option *option = sheen_option_table; option->name; option++)
        if (is_view(option))
            help_line(option->name, option->argument, option->help, option->value);
    printf("\nMESH is a file or builtin:teapot (the default), builtin:sphere, builtin:torus.\n");
}
