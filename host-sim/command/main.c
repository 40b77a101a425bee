/*
 * main.c - the command `sheen`: finds the subcommand and hands over.
 */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "commands.h"
#include "view_keys.h"

const struct sheen_command sheen_command_table[] = {
    {"render", "MESH [options] -o OUT.png|OUT.gif",
     "Draws a mesh with the integer core, sends it through the panel's driver to a simulated controller, and writes "
     "what its glass shows.",
     SHEEN_RENDER, sheen_cmd_render},
    {"view", "MESH [options]",
     "Shows a turning mesh on a panel's glass in a window, drawn and sent as `render` does. Keys:\n" SHEEN_VIEW_KEYS,
     SHEEN_VIEW, sheen_cmd_view},
    {"bake", "MESH [options] -o mesh.h",
     "Writes a mesh as const data for a firmware's flash, the same bits that `render` draws, and reports the memory "
     "that it needs. Instead of a mesh: shine:N makes the power table (struct sheen_shine) of shininess N, 1 to 128; "
     "matcap:FILE, or matcap:NAME with a name that --matcap knows, makes its texture (struct sheen_texture); "
     "ramp:gamma "
     "or ramp:gamma:G makes the ramp (struct sheen_ramp) of a panel's curve.",
     SHEEN_BAKE, sheen_cmd_bake},
    {"plan", "MESH [options]",
     "Predicts how many frames a second of a turning mesh a board will draw, where the time goes, the RAM and flash "
     "needed, what limits the rate, and what to change first. Each line says how its numbers were found: measured, in "
     "cycles of the emulated processor; estimated, from instructions; counted, exact.",
     SHEEN_PLAN, sheen_cmd_plan},
    {"first-light", "[options] -o OUT.png",
     "Sends the first picture for a new panel (border, corner marks, colour and grey bars) through the panel's driver, "
     "and writes what the glass shows.",
     SHEEN_FIRST_LIGHT, sheen_cmd_first_light},
    {"panels", "", "Lists the panels: controller, glass, colours, clock, bytes and frames per second.", SHEEN_PANELS,
     sheen_cmd_panels},
    {"lecture", "-o DIR",
     "Draws a figure for each claim of the lecture that the core is built on, as PNG and SVG, and a contact sheet of "
     "them; prints the numbers that the figures show.",
     SHEEN_LECTURE, sheen_cmd_lecture},
    {"man", "", "Prints the manual page: sheen man | man -l -", 0, sheen_cmd_man},
    {NULL, NULL, NULL, 0, NULL},
};

static const struct sheen_command *running; /* NULL: none yet */

enum sheen_exit sheen_fail(enum sheen_exit status, const struct sheen_problem *problem)
{
    fprintf(stderr, "sheen: %s", problem->text);
    if (status == SHEEN_EXIT_USAGE && running != NULL)
        fprintf(stderr, " (see sheen help %s)", running->name);
    else if (status == SHEEN_EXIT_USAGE)
        fputs(" (see sheen --help)", stderr);
    fputc('\n', stderr);
    return status;
}

static void print_help(void)
{
    printf("Usage: sheen COMMAND ...\n\n");
    sheen_options_paragraph(sheen_text_what);
    putchar('\n');
    for (const struct sheen_command *command = sheen_command_table; command->name; command++)
        printf("sheen %s%s%s\n", command->name, *command->operands ? " " : "", command->operands);
    putchar('\n');
    sheen_options_paragraph(sheen_text_help);
    putchar('\n');
    sheen_options_paragraph(sheen_text_exit);
}

/* Output that did not arrive, as in a closed pipe or on a full disk, is a failure. */
static enum sheen_exit finish(enum sheen_exit status)
{
    struct sheen_problem problem;

    if (fflush(stdout) == 0 && !ferror(stdout))
        return status;
    sheen_problem(&problem, SHEEN_ERR_ARGUMENT, "standard output: %s", strerror(errno));
    return status == SHEEN_EXIT_OK ? sheen_fail(SHEEN_EXIT_FAILURE, &problem) : status;
}

static enum sheen_exit run(const struct sheen_command *command, int argc, char **argv)
{
    struct sheen_options options;
    struct sheen_problem problem;

    running = command;
    int parsed = sheen_options_parse(&options, command, argc, argv, &problem);

    if (parsed < 0)
        return sheen_fail(SHEEN_EXIT_USAGE, &problem);
    return parsed == 0 ? SHEEN_EXIT_OK : command->run(&options);
}

int main(int argc, char **argv)
{
    struct sheen_problem problem;
    const char *name = argc > 1 ? argv[1] : "";

    /* A closed pipe or a file grown too large makes a write fail; it does not end the program. */
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    int asks = strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0;
    if (asks && argc == 2) {
        print_help();
        return finish(SHEEN_EXIT_OK);
    }
    if (asks)
        name = argv[2];
    if (strcmp(name, "--version") == 0) {
        sheen_options_version();
        return finish(SHEEN_EXIT_OK);
    }
    for (const struct sheen_command *command = sheen_command_table; command->name; command++) {
        if (strcmp(name, command->name) != 0)
            continue;
        if (!asks)
            return finish(run(command, argc - 1, argv + 1));
        sheen_options_help(command);
        return finish(SHEEN_EXIT_OK);
    }
    if (argc > 1)
        sheen_problem(&problem, SHEEN_ERR_ARGUMENT, "unknown command '%s'", name);
    else
        sheen_problem(&problem, SHEEN_ERR_ARGUMENT, "no command given");
    return sheen_fail(SHEEN_EXIT_USAGE, &problem);
}
