/*
 * thumb.h - private: whether loops are written in assembly for Cortex-M, and the loop that clears a tile.
 */
#ifndef SHEEN_THUMB_H
#define SHEEN_THUMB_H

#include "pixel.h"

#if defined(__OPTIMIZE__) && FAST_LOOPS && !SHEEN_STATS && !defined(__ARM_BIG_ENDIAN) &&                               \
    (defined(__thumb2__) || (defined(__thumb__) && defined(__ARM_ARCH_6M__)))
#define THUMB_LOOPS 1

#ifdef __thumb2__
#define THUMB_COPIES "mov r3, r2\n mov r4, r2\n mov r5, r2\n mov r6, r2\n mov r8, r2\n mov r10, r2\n mov r12, r2\n"
#define THUMB_STORE "stmia r0!, {r2-r6, r8, r10, r12}\n stmia r0!, {r2-r6, r8, r10, r12}\n"
#else
#define THUMB_COPIES "mov r3, r2\n mov r4, r2\n mov r5, r2\n"
#define THUMB_STORE "stmia r0!, {r2-r5}\n stmia r0!, {r2-r5}\n stmia r0!, {r2-r5}\n stmia r0!, {r2-r5}\n"
#endif

/*
 * Stores pairs of pixels from `from` to before `to`, a multiple of 64 B away; returns `to`. Compilers store at most two
 * registers at once.
 */
static inline uint64_t *thumb_fill(uint64_t *from, const uint64_t *to, uint32_t pair)
{
    register uint64_t *at __asm__("r0") = from;
    register const uint64_t *end __asm__("r1") = to;
    register uint32_t value __asm__("r2") = pair;

    __asm__ volatile(".syntax unified\n" THUMB_COPIES "b 2f\n1:\n" THUMB_STORE "2: cmp r0, r1\n bne 1b\n"
                     : "+r"(at)
                     : "r"(end), "r"(value)
                     : "r3", "r4", "r5", "r6", "r8", "r10", "r12", "cc", "memory");
    return at;
}

#else
#define THUMB_LOOPS 0
#endif

#endif
