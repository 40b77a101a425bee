/*
 * cmd_man.c - `sheen man`: the manual page, in roff, from the tables that make --help.
 */
#include <stdio.h>
#include <stdlib.h>

#include "commands.h"
#include "roff.h"

static void put_option(const struct sheen_option *option)
{
    char *text = sheen_option_text(option);

    fputs(".TP\n", stdout);
    if (option->letter)
        printf("\\fB\\-%c\\fR, ", option->letter);
    sheen_roff_line("\\fB\\-\\-", option->name, "\\fR");
    if (option->argument)
        sheen_roff_line(" \\fI", option->argument, "\\fR");
    sheen_roff_line("\n", text ? text : "", "\n");
    free(text);
}

static void put_command(const struct sheen_command *command)
{
    sheen_roff_line(".SS \"sheen ", command->name, "\"\n");
    sheen_roff_line("", command->summary, "\n");
    for (const struct sheen_option *option = sheen_option_table; option->name; option++) {
        if (option->commands & command->bit)
            put_option(option);
    }
}

enum sheen_exit sheen_cmd_man(struct sheen_options *options)
{
    const struct sheen_command *command;

    (void)options;
    printf(".TH SHEEN 1 \"\" \"sheen %s\" \"User Commands\"\n", sheen_version);
    sheen_roff_line(".SH NAME\nsheen \\- ", sheen_text_what, "\n.SH SYNOPSIS\n");
    for (command = sheen_command_table; command->name; command++) {
        sheen_roff_line(command == sheen_command_table ? "\\fBsheen " : ".br\n\\fBsheen ", command->name, "\\fR");
        sheen_roff_line(*command->operands ? " " : "", command->operands, "\n");
    }
    sheen_roff_line(".SH DESCRIPTION\n", sheen_text_mesh, "\n.PP\n");
    sheen_roff_line("", sheen_text_help, "\n.SH COMMANDS\n");
    for (command = sheen_command_table; command->name; command++)
        put_command(command);
    sheen_roff_line(".SH EXIT STATUS\n", sheen_text_exit, "\n");
    return SHEEN_EXIT_OK;
}
