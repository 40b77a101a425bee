/*
 * gouraud.h - private to the room of Gouraud shading: the quotient's rows.
 */
#ifndef SHEEN_GOURAUD_H
#define SHEEN_GOURAUD_H

#include "../triangle/quotient.h"
#include "shading.h"

void sheen_quotient_rows(const struct tile *t, const struct setup *s);

#endif
