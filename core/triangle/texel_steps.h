/*
 * texel_steps.h - private: how coordinates are stepped along a run of texels.
 */
#ifndef SHEEN_TEXEL_STEPS_H
#define SHEEN_TEXEL_STEPS_H

#include "textured.h"

/*
 * For small pictures that repeat they are packed: V above U in one word, both with PACKED_BITS of fraction; a carry out
 * of U adds only 2^-PACKED_BITS texel to V. Along TEXEL_PART px, packed steps are off by at most 2^-6 texel; after
 * every TEXEL_PART px that is mended. Otherwise U and V are stepped as they are.
 */
#define PACKED_BITS 10

SPECIALISED uint32_t packed_at(const struct texel_at *at, unsigned width)
{
    return (at->u >> 6 & ((1u << (PACKED_BITS + width)) - 1)) + (at->v >> 6 << (PACKED_BITS + width));
}

#endif
