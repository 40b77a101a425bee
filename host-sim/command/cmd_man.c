/*
 * cmd_man.c - `sheen man`: the manual page, in roff, from the tables that make --help.
 */
#include <stdio.h>
#include <stdlib.h>

#include "commands.h"
#include "roff.h"

static void put_heading(const char *text)
{
    sheen_roff_line(".SS \"", text, "\"\n");
}

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
    sheen_roff_line(".SH \"sheen ", command->name, "\"\n"); /* .SH, because the options' headings are .SS */
    sheen_roff_line("", command->summary, "\n");
    sheen_options_each(command, put_heading, put_option);
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
    sheen_roff_line("", sheen_text_help, "\n");
    for (command = sheen_command_table; command->name; command++)
        put_command(command);
    sheen_roff_line(".SH EXIT STATUS\n", sheen_text_exit, "\n");
    return SHEEN_EXIT_OK;
}
