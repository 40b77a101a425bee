/*
 * cmd_man.c - `sheen man`: the page of the manual, in roff, from the tables that make --help.
 */
#include <stdio.h>

#include "commands.h"

/* Text as it is: no hyphens of the typesetter's, nothing taken for a request or an escape. */
static void put(const char *text)
{
    for (int first = 1; *text; text++) {
        if (*text == '-')
            fputs("\\-", stdout);
        else if (*text == '\\')
            fputs("\\e", stdout);
        else if (first && (*text == '.' || *text == '\''))
            printf("\\&%c", *text);
        else
            putchar(*text);
        first = *text == '\n';
    }
}

static void put_line(const char *before, const char *text, const char *after)
{
    fputs(before, stdout);
    put(text);
    fputs(after, stdout);
}

static void put_option(const struct sheen_option *option)
{
    char text[256];

    fputs(".TP\n", stdout);
    if (option->letter)
        printf("\\fB\\-%c\\fR, ", option->letter);
    put_line("\\fB\\-\\-", option->name, "\\fR");
    if (option->argument)
        put_line(" \\fI", option->argument, "\\fR");
    sheen_option_text(option, text, sizeof text);
    put_line("\n", text, "\n");
}

static void put_command(const struct sheen_command *command)
{
    put_line(".SS \"sheen ", command->name, "\"\n");
    put_line("", command->summary, "\n");
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
    put_line(".SH NAME\nsheen \\- ", sheen_text_what, "\n.SH SYNOPSIS\n");
    for (command = sheen_command_table; command->name; command++) {
        put_line(command == sheen_command_table ? "\\fBsheen " : ".br\n\\fBsheen ", command->name, "\\fR");
        put_line(*command->operands ? " " : "", command->operands, "\n");
    }
    put_line(".SH DESCRIPTION\n", sheen_text_mesh, "\n.PP\n");
    put_line("", sheen_text_help, "\n.SH COMMANDS\n");
    for (command = sheen_command_table; command->name; command++)
        put_command(command);
    put_line(".SH EXIT STATUS\n", sheen_text_exit, "\n");
    return SHEEN_EXIT_OK;
}
