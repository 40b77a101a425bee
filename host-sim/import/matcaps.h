/*
 * matcaps.h - what --matcap names: one of the core's, or a picture's file.
 */
#ifndef SHEEN_MATCAPS_H
#define SHEEN_MATCAPS_H

#include "texels.h"

#define SHEEN_MATCAP_NAMES "glaze|chrome|clay|jade"
#define SHEEN_MATCAP_LARGEST 64u /* texels a side, to which pictures are reduced */

/*
 * As the core takes it; colors, bilinear: as of sheen_texels_make, with which it is released in any case. 0, or a
 * negative code and *problem: a file that is not there, is no picture, or not square.
 */
int sheen_matcap_load(struct sheen_texels *texels, const char *name, unsigned colors, int bilinear,
                      struct sheen_problem *problem);

#endif
