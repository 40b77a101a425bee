/*
 * vector.h - private: unit vectors along vectors of 64-bit components.
 */
#ifndef SHEEN_VECTOR_H
#define SHEEN_VECTOR_H

#include "../sheen.h"

/* sheen_normalize() for components of magnitude below 2^63: the same errors and the same precision. */
int sheen_normalize_wide(const int64_t v[3], sheen_q30_t out[3]);

#endif
