/*
 * shadings.h - the shadings by number, for options, tables and loops of the host and the tests.
 */
#ifndef SHEEN_SHADINGS_H
#define SHEEN_SHADINGS_H

#include "sheen.h"

enum sheen_shading {
    SHEEN_FLAT = 0,
    SHEEN_GOURAUD,
    SHEEN_PHONG,
    SHEEN_SLERP,
    SHEEN_SHADINGS
};

static inline const struct sheen_shader *sheen_shader_of(unsigned shading)
{
    static const struct sheen_shader *const shader[SHEEN_SHADINGS] = {&sheen_flat, &sheen_gouraud, &sheen_phong,
                                                                      &sheen_slerp};

    return shader[shading];
}

#endif
