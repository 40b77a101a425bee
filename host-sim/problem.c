/*
 * problem.c - one line for a person.
 */
#include "problem.h"

#include <stdarg.h>
#include <stdio.h>

int sheen_problem(struct sheen_problem *problem, int error, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(problem->text, sizeof problem->text, format, arguments);
    va_end(arguments);
    for (char *c = problem->text; *c; c++) {
        if ((unsigned char)*c < ' ' || *c == 127)
            *c = '?';
    }
    return error;
}
