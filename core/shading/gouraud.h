/*
 * gouraud.h - private to the room of Gouraud shading: the quotient's set-up.
 */
#ifndef SHEEN_GOURAUD_H
#define SHEEN_GOURAUD_H

#include "shading.h"

/* Blinn's way. */
struct quotient_setup {
    struct setup s;
    struct plane channel[3]; /* with the draw's fraction, times weight */
    struct plane weight;     /* UQ0.32 */
};

void sheen_quotient_rows(const struct tile *t, const struct setup *s);

#endif
