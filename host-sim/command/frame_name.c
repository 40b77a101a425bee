/*
 * frame_name.c - the file name of a frame.
 */
#include "frame_name.h"

#include <stdio.h>
#include <string.h>

/* Finds the next %d or %0Nd: where it begins, how long it is, the digits it asks for. 0 if there is none. */
static int find(const char *from, const char **begin, int *length, int *digits)
{
    for (const char *p = strchr(from, '%'); p; p = strchr(p + 1, '%')) {
        *begin = p;
        *digits = 1;
        *length = 2;
        if (p[1] == 'd')
            return 1;
        if (p[1] == '0' && p[2] >= '1' && p[2] <= '9' && p[3] == 'd') {
            *digits = p[2] - '0';
            *length = 4;
            return 1;
        }
    }
    return 0;
}

const char *sheen_file_of(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? slash + 1 : path;
}

int sheen_frame_name_varies(const char *pattern)
{
    const char *begin;
    int length, digits;

    return find(sheen_file_of(pattern), &begin, &length, &digits) && !find(begin + length, &begin, &length, &digits);
}

int sheen_frame_name(char *name, size_t size, const char *pattern, int number, size_t count)
{
    const char *begin = pattern + strlen(pattern);
    int length = 0, digits = 1, made;

    if (count > 1 && sheen_frame_name_varies(pattern) && find(sheen_file_of(pattern), &begin, &length, &digits))
        made = snprintf(name, size, "%.*s%0*d%s", (int)(begin - pattern), pattern, digits, number, begin + length);
    else
        made = snprintf(name, size, "%s", pattern);
    return made >= 0 && (size_t)made < size ? 0 : -1;
}

const char *sheen_ending(const char *path)
{
    const char *file = sheen_file_of(path), *dot = strrchr(file, '.');

    return dot && dot != file ? dot : "";
}
