/*
 * options_help.c - what --help and --version say, laid out for a terminal of 80 columns.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "options.h"

enum {
    COLUMNS = 80,
    INDENT = 30 /* where an option's text begins */
};

const char sheen_version[] = SHEEN_VERSION;
const char sheen_text_what[] = "Shaded 3D with integers only, as a small display would show it.";
const char sheen_text_help[] = "sheen help COMMAND shows a command's options, sheen --version the version.";
const char sheen_text_mesh[] =
    "MESH is a file (OBJ, STL, PLY, glTF, ...) or builtin:teapot, builtin:teapot-fine, builtin:sphere, "
    "builtin:torus, builtin:cube. Angles are in degrees, counter-clockwise; defaults are in brackets.";
const char sheen_text_exit[] = "The exit status is 0, 1 after bad input or a failed write, 2 for a wrong command line; "
                               "one line on standard error says what is wrong.";

/* Prints a line of text from `column` on, wrapped between words only. Returns the text after that line. */
static const char *print_line(const char *text, size_t column, size_t indent)
{
    const char *word = text;

    while (*word && *word != '\n') {
        size_t length = strcspn(word, " \n");
        if (column > indent && column + 1 + length > COLUMNS) {
            printf("\n%*s", (int)indent, "");
            column = indent;
        } else if (column > indent) {
            putchar(' ');
            column++;
        }
        printf("%.*s", (int)length, word);
        column += length;
        word += length + (word[length] == ' ');
    }
    putchar('\n');
    return word + (*word == '\n');
}

void sheen_options_paragraph(const char *text)
{
    while (*text) {
        size_t length = strcspn(text, "\n");
        if (*text != ' ') {
            text = print_line(text, 0, 0);
            continue;
        }
        printf("%.*s\n", (int)length, text); /* laid out already */
        text += length + (text[length] == '\n');
    }
}

char *sheen_option_text(const struct sheen_option *option)
{
    char *text = NULL;
    int length =
        option->value ? asprintf(&text, "%s [%s]", option->help, option->value) : asprintf(&text, "%s", option->help);

    return length < 0 ? NULL : text;
}

static const char *const headings[SHEEN_SECTIONS_END] = {
    [SHEEN_FOR_OUTPUT] = "Output",
    [SHEEN_FOR_BOARD] = "Board",
    [SHEEN_FOR_PANEL] = "Panel",
    [SHEEN_FOR_WINDOW] = "Window",
    [SHEEN_FOR_VIEW] = "View",
    [SHEEN_FOR_LIGHT] = "Light and shading",
    [SHEEN_FOR_COLOR] = "Colour and background",
    [SHEEN_FOR_TEXTURE] = "Textures and matcaps",
    [SHEEN_FOR_EDGES] = "Edges",
    [SHEEN_FOR_MESH] = "Mesh",
    [SHEEN_FOR_ANIMATION] = "Animation",
};

void sheen_options_each(const struct sheen_command *command, void (*put_heading)(const char *text),
                        void (*put_option)(const struct sheen_option *option))
{
    for (unsigned section = SHEEN_FOR_OUTPUT; section < SHEEN_SECTIONS_END; section++) {
        int count = 0;
        for (const struct sheen_option *option = sheen_option_table; option->name; option++) {
            if (option->section != section || !(option->commands & command->bit))
                continue;
            if (count++ == 0)
                put_heading(headings[section]);
            put_option(option);
        }
    }
}

static void print_heading(const char *text)
{
    printf("\n%s:\n", text);
}

static void print_option(const struct sheen_option *option)
{
    const char letter[4] = {'-', option->letter, ',', '\0'};
    char *text = sheen_option_text(option);
    int length = printf("%3s --%s%s%s", option->letter ? letter : "", option->name, option->argument ? " " : "",
                        option->argument ? option->argument : "");

    if (length >= INDENT) /* too long for one line with its text */
        printf("\n%*s", INDENT, "");
    else
        printf("%*s", INDENT - length, "");
    print_line(text ? text : "", INDENT, INDENT);
    free(text);
}

void sheen_options_version(void)
{
    printf("sheen %s\n", sheen_version);
}

void sheen_options_help(const struct sheen_command *command)
{
    printf("Usage: sheen %s%s%s\n\n", command->name, *command->operands ? " " : "", command->operands);
    sheen_options_paragraph(command->summary);
    sheen_options_each(command, print_heading, print_option);
    if (command->bit & SHEEN_TAKES_MESH) {
        putchar('\n');
        sheen_options_paragraph(sheen_text_mesh);
    }
}
