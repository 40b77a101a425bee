/*
 * ramps.h - a ramp over L.N as the command line names it.
 */
#ifndef SHEEN_RAMPS_H
#define SHEEN_RAMPS_H

#include "options.h"

#define SHEEN_RAMP_BYTES 528u /* struct sheen_ramp with 32-bit pointers */
#define SHEEN_LEAST_GAMMA 1.0
#define SHEEN_MOST_GAMMA 5.0

/* "half", "gamma:1.8": 0, or -1 where it is none; *choice is untouched then. */
int sheen_ramp_read(struct sheen_ramp_choice *choice, const char *text);

/* "--ramp gamma" divides by the diffuse light: 0, or SHEEN_ERR_ARGUMENT and *problem. */
int sheen_ramp_check(const struct sheen_options *options, struct sheen_problem *problem);

/*
 * What a material points to: a ramp of the core's, or *room, made for the options' ambient and diffuse light; NULL for
 * the lecture's.
 */
const struct sheen_ramp *sheen_ramp_of(struct sheen_ramp *room, const struct sheen_options *options);

#endif
