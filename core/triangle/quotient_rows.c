/*
 * quotient_rows.c - rows of channels that are linear in space, without fog.
 */
#include "quotient.h"

HOT void sheen_quotient_rows(const struct tile *t, const struct setup *s)
{
    quotient_rows(t, (const struct quotient_setup *)s, 0);
}
