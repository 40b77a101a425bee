/*
 * ramps.h - the ramps over L.N that the command line names.
 */
#ifndef SHEEN_RAMPS_H
#define SHEEN_RAMPS_H

#include "options.h"

#define SHEEN_RAMP_BYTES 528u /* struct sheen_ramp with 32-bit pointers */
#define SHEEN_LEAST_GAMMA 1.0
#define SHEEN_MOST_GAMMA 5.0

/* Reads a ramp's name, such as "half" or "gamma:1.8". 0, or -1 if it is none; *choice is untouched then. */
int sheen_ramp_read(struct sheen_ramp_choice *choice, const char *text);

/* Checks the diffuse light, by which "--ramp gamma" divides. 0, or SHEEN_ERR_ARGUMENT and *problem: it is too small. */
int sheen_ramp_check(const struct sheen_options *options, struct sheen_problem *problem);

/*
 * The ramp for a material to point to: one of the core's, or *room, filled in for the options' ambient and diffuse
 * light; NULL for the lecture's max(0, L.N).
 */
const struct sheen_ramp *sheen_ramp_of(struct sheen_ramp *room, const struct sheen_options *options);

#endif
