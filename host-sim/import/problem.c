/*
 * problem.c - one line for the user that says what is wrong.
 */
#include "problem.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "utf8.h"

int sheen_problem(struct sheen_problem *problem, int error, const char *format, ...)
{
    char *line = NULL;
    va_list arguments;

    va_start(arguments, format);
    int made = vasprintf(&line, format, arguments); /* of any length: the end says what is wrong */
    va_end(arguments);
    if (made < 0) {
        sheen_utf8_copy(problem->text, sizeof problem->text, "not enough memory to say what is wrong");
        return error;
    }
    sheen_utf8_clean(line);
    sheen_utf8_shorten(line, SHEEN_PROBLEM_MAX);
    sheen_utf8_copy(problem->text, sizeof problem->text, line);
    free(line);
    return error;
}
