/*
 * phong_colored.c - Phong shading with colours of vertices and lights: at a pixel its normal is lit, and its colour
 * multiplies that.
 */
#include "../triangle/tinted.h"
#include "shading.h"

const struct sheen_shader sheen_phong_colored = {.begin = sheen_glow_begin,
                                                 .carry = sheen_carry_shares,
                                                 .setup = sheen_setup_tinted,
                                                 .needs_normals = 1,
                                                 .at_pixels = 1};
