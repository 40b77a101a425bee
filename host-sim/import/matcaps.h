/*
 * matcaps.h - the matcap that --matcap names: one of the core's, or a picture file.
 */
#ifndef SHEEN_MATCAPS_H
#define SHEEN_MATCAPS_H

#include "texels.h"

#define SHEEN_MATCAP_NAMES "glaze|chrome|clay|jade"
#define SHEEN_MATCAP_LARGEST 64u /* texels a side; larger pictures are reduced to it */

/*
 * Makes it a texture of the core; colors, bilinear: as for sheen_texels_make. Release with sheen_texels_free in any
 * case. 0, or a negative code and *problem: the file is missing, is no picture, or is not square.
 */
int sheen_matcap_load(struct sheen_texels *texels, const char *name, unsigned colors, int bilinear,
                      struct sheen_problem *problem);

#endif
