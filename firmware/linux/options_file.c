/*
 * options_file.c - options from a file: a line `name = value` each, '#' begins a comment.
 *
 *   panel = st7789-240x240
 *   spi = /dev/spidev0.0
 *   dc = GPIO25
 */
#include "options.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

/* Cuts blanks off both ends, in place. */
static char *trim(char *text)
{
    size_t length;

    while (isspace((unsigned char)*text))
        text++;
    for (length = strlen(text); length > 0 && isspace((unsigned char)text[length - 1]); length--)
        text[length - 1] = '\0';
    return text;
}

/* A line of a file: an option, a comment or nothing. */
static int read_line(struct options *options, char *line, struct sheen_failure *why)
{
    char *equals, *name, *comment = strchr(line, '#');

    if (comment)
        *comment = '\0';
    name = trim(line);
    if (*name == '\0')
        return 0;
    equals = strchr(name, '=');
    if (!equals)
        return sheen_failed(why, -1, "'%.60s' is not of the form name = value", name);
    *equals = '\0';
    name = trim(name);
    return options_set(options, name, trim(equals + 1), why);
}

int options_read_file(struct options *options, const char *path, struct sheen_failure *why)
{
    FILE *file = fopen(path, "re");
    char line[4096];
    struct sheen_failure what = {""};
    int error = 0;

    if (!file)
        return sheen_failed(why, 1, "%s: %s", path, strerror(errno));
    for (unsigned number = 1; error == 0 && fgets(line, sizeof line, file); number++) {
        if (!strchr(line, '\n') && !feof(file))
            error = sheen_failed(&what, -1, "a line longer than %zu characters", sizeof line - 2);
        else
            error = read_line(options, line, &what);
        if (error)
            error = sheen_failed(why, 1, "%s:%u: %s", path, number, what.text);
    }
    if (error == 0 && ferror(file))
        error = sheen_failed(why, 1, "%s: %s", path, strerror(errno));
    fclose(file);
    return error;
}
