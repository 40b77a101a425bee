/*
 * failure.c - see sheen_failure.h.
 */
#include "sheen_failure.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>

int sheen_failed(struct sheen_failure *why, int code, const char *format, ...)
{
    if (why) {
        va_list values;

        va_start(values, format);
        vsnprintf(why->text, sizeof why->text, format, values);
        va_end(values);
    }
    return code;
}

int sheen_again(int error, int *tries)
{
    return (error == EINTR || error == EAGAIN) && --*tries > 0;
}
