/*
 * textures_out.h - --texture-out: textures as they are drawn, for a person to see.
 */
#ifndef SHEEN_TEXTURES_OUT_H
#define SHEEN_TEXTURES_OUT_H

#include "options.h"
#include "texels.h"

/* Checks the file name in the options. 0, or SHEEN_ERR_ARGUMENT and *problem: it is no PNG's, or also the output's. */
int sheen_textures_out_check(const struct sheen_options *options, struct sheen_problem *problem);

/*
 * Writes the textures if the options ask for it, transparent texels with alpha 0. 0, or a negative code and *problem:
 * there are none, the name does not vary for several textures, or writing fails.
 */
int sheen_textures_out(const struct sheen_options *options, const struct sheen_texels *texels, size_t count,
                       struct sheen_problem *problem);

#endif
