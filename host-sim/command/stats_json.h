/*
 * stats_json.h - `--stats`: a line of JSON per frame.
 */
#ifndef SHEEN_STATS_JSON_H
#define SHEEN_STATS_JSON_H

#include <stdio.h>

#include "turntable.h"

/* Prints one object and a newline. 0, or SHEEN_ERR_ARGUMENT if the stream fails. */
int sheen_stats_json(FILE *stream, const struct sheen_turntable *table, int number);

#endif
