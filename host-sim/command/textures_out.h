/*
 * textures_out.h - --texture-out: textures as they are drawn, for a person to see.
 */
#ifndef SHEEN_TEXTURES_OUT_H
#define SHEEN_TEXTURES_OUT_H

#include "options.h"
#include "texels.h"

/* 0, or SHEEN_ERR_ARGUMENT and *problem: the name that the options have for them is that of no PNG. */
int sheen_textures_out_check(const struct sheen_options *options, struct sheen_problem *problem);

/*
 * Writes them where the options ask for it, transparent texels with alpha 0. 0, or a negative code and *problem: there
 * is none, or the name does not differ from one to the next.
 */
int sheen_textures_out(const struct sheen_options *options, const struct sheen_texels *texels, size_t count,
                       struct sheen_problem *problem);

#endif
