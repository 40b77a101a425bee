/*
 * test_core_worst.h - the largest error of a loop and where it was, for tests of the core's stages.
 *
 * Errors are in raw steps of the format that the test names.
 */
#ifndef TEST_CORE_WORST_H
#define TEST_CORE_WORST_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

__extension__ typedef __int128 int128;
__extension__ typedef unsigned __int128 uint128;

struct worst {
    double error;
    long count;
    char where[120];
};

/* An error counts by its size; the text says which case it was. NaN is the worst of all. */
__attribute__((format(printf, 3, 4))) static inline void worst_note(struct worst *w, double error, const char *text,
                                                                    ...)
{
    w->count++;
    if (fabs(error) <= w->error)
        return;
    w->error = isnan(error) ? INFINITY : fabs(error);
    va_list list;
    va_start(list, text);
    (void)vsnprintf(w->where, sizeof w->where, text, list);
    va_end(list);
}

/* Fails where an error was above the limit, or where nothing was compared. */
static inline void worst_assert(const struct worst *w, double limit, const char *what)
{
    if (w->count == 0)
        fail_msg("%s: nothing was compared", what);
    if (!(w->error <= limit))
        fail_msg("%s: off by %g, %g allowed, at %s", what, w->error, limit, w->where);
    print_message("           %s: at most %.3g of %g allowed, %ld cases\n", what, w->error, limit, w->count);
}

#endif
