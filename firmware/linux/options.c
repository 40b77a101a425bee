/*
 * options.c - the command line: defaults, getopt_long, checks of what is missing, the help text.
 */
#include "options.h"

#include "options_table.h"
#include "sheen_panel.h"

#include <ctype.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define VIEW 1000 /* getopt_long returns an option's row, or VIEW + its place in the command's table */

/* Both tables as getopt_long takes them, to be freed; NULL: not enough memory. */
static struct option *long_options(void)
{
    size_t rows = 0, views = 0;

    while (option_rows[rows].help)
        rows++;
    while (sheen_option_table[views].name)
        views++;
    struct option *table = calloc(rows + views + 1, sizeof *table), *next = table;
    for (size_t i = 0; table && i < rows; i++)
        if (option_rows[i].name)
            *next++ = (struct option){option_rows[i].name,
                                      option_rows[i].kind == SWITCH ? no_argument : required_argument, NULL, (int)i};
    for (size_t i = 0; table && i < views; i++)
        if (option_is_view(&sheen_option_table[i]))
            *next++ =
                (struct option){sheen_option_table[i].name,
                                sheen_option_table[i].argument ? required_argument : no_argument, NULL, VIEW + (int)i};
    return table;
}

/* After getopt_long has returned '?', optopt is a letter, the value of an option that accepts no argument, or 0. */
static int unknown(char **argv, struct sheen_failure *why)
{
    if (optopt < VIEW && isgraph(optopt))
        return sheen_failed(why, 2, "unknown option -%c", optopt);
    if (optopt > 0)
        return sheen_failed(why, 2, "--%s takes no value",
                            optopt >= VIEW ? sheen_option_table[optopt - VIEW].name : option_rows[optopt].name);
    return sheen_failed(why, 2, "unknown or ambiguous option %s", argv[optind - 1]);
}

static int read_by(const struct option *table, struct options *options, int argc, char **argv, const char **config,
                   struct sheen_failure *why)
{
    struct sheen_failure what;
    int value, error;

    optind = 0; /* GNU: start again, because the command line is read twice */
    opterr = 0;
    while ((value = getopt_long(argc, argv, ":", table, NULL)) != -1) {
        if (value == ':')
            return sheen_failed(why, 2, "%s needs a value", argv[optind - 1]);
        if (value == '?')
            return unknown(argv, why);
        if (value < VIEW && option_rows[value].kind == ONLY_HERE) {
            *config = optarg;
            continue;
        }
        error = value < VIEW ? option_set_row(options, &option_rows[value], optarg, &what)
                             : option_set_view(options, &sheen_option_table[value - VIEW], optarg, &what);
        if (error)
            return sheen_failed(why, 2, "--%s", what.text);
    }
    if (optind < argc - 1)
        return sheen_failed(why, 2, "one mesh, not '%s' and '%s'", argv[optind], argv[optind + 1]);
    if (optind < argc)
        snprintf(options->mesh, sizeof options->mesh, "%s", argv[optind]);
    return 0;
}

/* Reads the whole command line; puts the value of --config into *config. */
static int read_arguments(struct options *options, int argc, char **argv, const char **config,
                          struct sheen_failure *why)
{
    struct option *table = long_options();
    int error = table ? read_by(table, options, argc, argv, config, why) : sheen_failed(why, 1, "not enough memory");

    free(table);
    return error;
}

static int set_defaults(struct options *options, struct sheen_failure *why)
{
    static const struct sheen_command render = {.bit = SHEEN_RENDER};
    static char name[] = "sheen-panel", mesh[] = "builtin:teapot";
    char *arguments[] = {name, mesh, NULL};
    struct sheen_problem problem;

    *options = (struct options){
        .spi_mode = -1, .orientation = -1, .gap = {-1, -1}, .invert = -1, .order = -1, .brightness = -1, .buffers = 2};
    strcpy(options->mesh, mesh);
    if (sheen_options_parse(&options->view, &render, 2, arguments, &problem) < 0)
        return sheen_failed(why, 1, "%s", problem.text);
    return 0;
}

/* Copies the values that the view has too but that are stored elsewhere. */
static void complete(struct options *options)
{
    options->view.mesh = options->mesh;
    options->view.buffers = (int)options->buffers;
}

int options_read(struct options *options, int argc, char **argv, struct sheen_failure *why)
{
    const char *config = NULL;
    int error = set_defaults(options, why);

    /* First read it to find --config and mistakes; then once more, to override what the file says. */
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

/* Checks that exactly one bus is named, with the options it needs. */
static int check_bus(const struct options *options, struct sheen_failure *why)
{
    if (options->i2c[0]) {
        if (options->spi[0] || options->sclk[0] || options->mosi[0] || options->cs[0] || options->dc[0])
            return sheen_failed(why, 2, "--i2c takes the place of --spi, --sclk, --mosi, --cs and --dc");
        if (options->clock || options->spi_mode >= 0)
            return sheen_failed(why, 2, "--clock and --spi-mode are for SPI; the kernel sets the clock of --i2c");
        return 0;
    }
    if (options->address)
        return sheen_failed(why, 2, "--address is for --i2c");
    if (!options->dc[0])
        return sheen_failed(why, 2, "--dc is missing: the line that tells data from commands");
    const int lines = (options->sclk[0] != 0) + (options->mosi[0] != 0);
    if (lines != (options->spi[0] ? 0 : 2))
        return sheen_failed(why, 2, "either --spi, or --sclk and --mosi, or --i2c");
    if (options->clock && !options->spi[0])
        return sheen_failed(why, 2, "--clock is for --spi; lines are set as fast as they can be");
    return 0;
}

int options_check(const struct options *options, struct sheen_failure *why)
{
    struct sheen_panel_record record;
    uint16_t width, height;
    int error = options_record(options, &record, why);

    if (error == 0)
        error = check_bus(options, why);
    if (error)
        return error;
    sheen_panel_size(&record, options_orientation(options), &width, &height);
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

const char options_what[] = "Shows a turning mesh on a small panel that is wired to this board.";
const char options_mesh[] =
    "MESH is a file or builtin:teapot (the default), builtin:teapot-fine, builtin:sphere, builtin:torus, builtin:cube.";
const char options_look[] = "What the mesh looks like, as for `sheen render`.";

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
           "%s\n",
           options_what);
    for (const struct option_row *row = option_rows; row->help; row++) {
        if (row->name)
            help_line(row->name, row->value, row->help, NULL);
        else
            printf("\n%s\n", row->help);
    }
    printf("\n%s\n", options_look);
    for (const struct sheen_option *option = sheen_option_table; option->name; option++)
        if (option_is_view(option))
            help_line(option->name, option->argument, option->help, option->value);
    printf("\n%s\n", options_mesh);
}
