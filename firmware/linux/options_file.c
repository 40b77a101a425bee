/*
 * options_file.c - reads options from a file: one line `name = value` per option; '#' begins a comment.
 *
 *   panel = st7789-240x240
 *   spi = /dev/spidev0.0
 *   dc = GPIO25
 */
#include "options.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LONGEST 4094 /* characters per line */

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

/* Reads one line: an option, a comment or nothing. */
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

/* Returns the text of a file, to be freed, or NULL and *why. A file with a zero byte is refused. */
static char *read_all(const char *path, struct sheen_failure *why)
{
    FILE *file = fopen(path, "re");
    char *text = NULL;
    size_t size = 0;

    if (!file) {
        sheen_failed(why, 1, "%s: %s", path, strerror(errno));
        return NULL;
    }
    ssize_t length = getdelim(&text, &size, '\0', file);
    const char *wrong = ferror(file) ? strerror(errno) : text ? NULL : strerror(ENOMEM);
    fclose(file);
    if (!wrong && length < 0)
        *text = '\0'; /* an empty file */
    else if (!wrong && strlen(text) != (size_t)length)
        wrong = "holds a zero byte";
    if (!wrong)
        return text;
    free(text);
    sheen_failed(why, 1, "%s: %s", path, wrong);
    return NULL;
}

int options_read_file(struct options *options, const char *path, struct sheen_failure *why)
{
    struct sheen_failure what = {""};
    char *next = options->file = read_all(path, why);
    int error = next ? 0 : 1;

    for (unsigned number = 1; !error && next; number++) {
        char *line = next, *end = strchr(line, '\n');
        next = end ? end + 1 : NULL;
        if (end)
            *end = '\0';
        if (strlen(line) > LONGEST)
            error = sheen_failed(&what, -1, "a line longer than %d characters", LONGEST);
        else
            error = read_line(options, line, &what);
        if (error)
            error = sheen_failed(why, 1, "%s:%u: %s", path, number, what.text);
    }
    return error;
}
