/*
 * man.c - prints the manual page of sheen-panel, from the same tables as --help.
 */
#include "options_table.h"
#include "roff.h"

#include <stdio.h>

static void put_option(const char *name, const char *value, const char *text, const char *standard)
{
    sheen_roff_line(".TP\n\\fB\\-\\-", name, "\\fR");
    if (value)
        sheen_roff_line(" \\fI", value, "\\fR");
    sheen_roff_line("\n", text, "");
    if (standard)
        sheen_roff_line(*text ? " [" : "[", standard, "]");
    putchar('\n');
}

void options_man(void)
{
    printf(".TH SHEEN\\-PANEL 1 \"\" \"sheen %s\" \"User Commands\"\n"
           ".SH NAME\nsheen\\-panel \\- show a turning mesh on a small panel\n"
           ".SH SYNOPSIS\n\\fBsheen\\-panel\\fR [\\fIMESH\\fR] \\fB\\-\\-panel\\fR \\fINAME\\fR [\\fIOPTION\\fR]...\n"
           ".SH DESCRIPTION\n",
           SHEEN_VERSION);
    sheen_roff_line("", options_what, "\n.PP\n");
    sheen_roff_line("", options_mesh, "\n.SH OPTIONS\n");
    for (const struct option_row *row = option_rows; row->help; row++) {
        if (row->name)
            put_option(row->name, row->value, row->help, NULL);
        else
            sheen_roff_line(".SS \"", row->help, "\"\n");
    }
    sheen_roff_line(".SS \"", options_look, "\"\n");
    for (const struct sheen_option *option = sheen_option_table; option->name; option++)
        if (option_is_view(option))
            put_option(option->name, option->argument, option->help, option->value);
    printf(".SH EXIT STATUS\n0, or 1 where something failed, or 2 for a wrong command line.\n"
           ".SH SEE ALSO\n.BR sheen (1)\n");
}
