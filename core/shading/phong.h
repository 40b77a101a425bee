/*
 * phong.h - private to the room of Phong shading: its set-ups and their rows.
 */
#ifndef SHEEN_PHONG_H
#define SHEEN_PHONG_H

#include "../triangle/reflection.h"
#include "shading.h"

/* One light, a root a pixel. */
struct phong_setup {
    struct setup s;
    int16_t x, y;             /* the pixel that `square` counts from */
    struct plane light, view; /* L.N and V.N, Q1.30 */
    struct quadric square;    /* N.N, UQ1.31 */
};

/* Several lights, and what the other ways do not take. */
struct phong_lights_setup {
    struct setup s;
    struct plane normal[3]; /* N, Q1.30 */
};

void sheen_phong_rows(const struct tile *t, const struct setup *s);
void sheen_phong_lights_rows(const struct tile *t, const struct setup *s);

#endif
