/*
 * thumb_runs.h - private: loops over long runs for Cortex-M, four pixels per turn, in assembly: compilers neither keep
 * the steps in the upper registers nor finish one of four pixels before the next. They do the same as packed_run and,
 * per pixel, shades_pixel do in C.
 */
#ifndef SHEEN_THUMB_RUNS_H
#define SHEEN_THUMB_RUNS_H

#include "../pixel/thumb.h"
#include "packed_rows.h"

#if THUMB_LOOPS

/* A run's values in the order in which the assembly loads them; count: at least 1. */
struct thumb_packed {
    struct packed_at step;
    uint16_t *depth;
    int32_t count;
    intptr_t to_pixel;
    struct packed_at at;
};

struct thumb_shades {
    struct shades_at step;
    uint16_t *depth;
    int32_t count;
    intptr_t to_pixel;
    struct shades_at at;
    const uint16_t *shades;
};

/*
 * Loops over n pixels and enters the first turn at pixel -n & 3 of its four. n: the register that holds -n; its two
 * lowest bits are shifted into the flags C and N, by which the entry is chosen.
 */
#define THUMB_FOURS(PIXEL, n, next)                                                                                    \
    "lsls " n ", " n ", #31\n bcs 5f\n bmi 2f\n"                                                                       \
    "1:\n" PIXEL("0") "2:\n" PIXEL("2") "3:\n" PIXEL("4") "4:\n" PIXEL("6") next "bne 1b\n b 6f\n"                     \
                                                                                 "5: bpl 3b\n b 4b\n"                  \
                                                                                 "6:\n"

#ifdef __thumb2__

/* Scratch: r0, r12. r4: address of the depth; r6: offset to the pixel from r4, once that has moved on; r8: z. */
#define THUMB_DEPTH "ldrh r0, [r4], #2\n cmp r0, r8, lsr #16\n bhs 9f\n lsr r0, r8, #16\n strh r0, [r4, #-2]\n"
#define THUMB_RUN(PIXEL) "negs r0, r5\n add r5, r4, r5, lsl #1\n subs r6, #2\n" THUMB_FOURS(PIXEL, "r0", "cmp r4, r5\n")

#define THUMB_SAVE
#define THUMB_RESTORE
#define THUMB_WRITTEN "r8", "r10", "r11",
#define PACKED_LOAD "ldm r0, {r1-r6, r8, r10, r11}\n"
#define PACKED_PIXEL(k)                                                                                                \
    THUMB_DEPTH "and r0, r10, #0xf800f800\n lsr r12, r11, #26\n orr r0, r0, r0, lsl #5\n orr r0, r0, r12, lsl #21\n"   \
                "rev r0, r0\n strh r0, [r4, r6]\n"                                                                     \
                "9: add r8, r1\n add r10, r2\n add r11, r3\n"
#define SHADES_LOAD "ldm r0, {r1, r2, r4-r6, r8, r10, r11}\n"
#define SHADES_PIXEL(k)                                                                                                \
    THUMB_DEPTH "lsr r0, r10, #20\n ldrh r0, [r11, r0, lsl #1]\n strh r0, [r4, r6]\n"                                  \
                "9: add r8, r1\n add r10, r2\n"

#else

/* Scratch: r0, r2. r1, r3: addresses of the depth and the pixel of the first of four; r4: z. */
#define THUMB_DEPTH(k) "ldrh r0, [r1, #" k "]\n lsrs r2, r4, #16\n cmp r2, r0\n bls 9f\n strh r2, [r1, #" k "]\n"
#define THUMB_RUN(PIXEL)                                                                                               \
    "lsls r0, r2, #1\n add r0, r1\n mov r12, r0\n negs r2, r2\n lsls r0, r2, #30\n lsrs r0, r0, #29\n subs r1, r0\n"   \
    "add r3, r1\n" THUMB_FOURS(PIXEL, "r2", "adds r1, #8\n adds r3, #8\n cmp r1, r12\n")

/*
 * GCC saves none of r8 to r11 if the command line says -Os, even where a pragma says -O2 (firmware/arduino), so the
 * loops do so themselves. It does not know of these 12 B of stack; tests/checks/callgraph.py does.
 */
#define THUMB_SAVE "mov r4, r8\n mov r5, r10\n mov r6, r11\n push {r4-r6}\n"
#define THUMB_RESTORE "pop {r4-r6}\n mov r8, r4\n mov r10, r5\n mov r11, r6\n"
#define THUMB_WRITTEN
#define PACKED_LOAD                                                                                                    \
    "movs r1, #0xf8\n lsls r1, r1, #8\n lsls r2, r1, #16\n orrs r1, r2\n mov lr, r1\n"                                 \
    "ldm r0!, {r1-r3}\n mov r8, r1\n mov r10, r2\n mov r11, r3\n ldm r0!, {r1-r6}\n"
#define PACKED_PIXEL(k)                                                                                                \
    THUMB_DEPTH(k)                                                                                                     \
    "mov r2, lr\n ands r2, r5\n lsrs r0, r6, #26\n lsls r0, r0, #21\n orrs r0, r2\n lsls r2, r2, #5\n orrs r0, r2\n"   \
    "rev r0, r0\n strh r0, [r3, #" k "]\n"                                                                             \
    "9: add r4, r8\n add r5, r10\n add r6, r11\n"
#define SHADES_LOAD "ldm r0!, {r1, r2}\n mov r8, r1\n mov r10, r2\n ldm r0!, {r1-r6}\n"
#define SHADES_PIXEL(k)                                                                                                \
    THUMB_DEPTH(k)                                                                                                     \
    "lsrs r0, r5, #20\n lsls r0, r0, #1\n ldrh r0, [r6, r0]\n strh r0, [r3, #" k "]\n"                                 \
    "9: add r4, r8\n add r5, r10\n"

#endif

/* r7 and r9 are left alone: the compiler may need them for its own purposes. */
#define THUMB_LOOP(run, LOAD, PIXEL)                                                                                   \
    register const void *at __asm__("r0") = (run);                                                                     \
    __asm__ volatile(".syntax unified\n" THUMB_SAVE LOAD THUMB_RUN(PIXEL) THUMB_RESTORE                                \
                     : "+r"(at)                                                                                        \
                     :                                                                                                 \
                     : "r1", "r2", "r3", "r4", "r5", "r6", THUMB_WRITTEN "r12", "lr", "cc", "memory")

/* Not dithered, into a target of the other byte order. */
SPECIALISED void thumb_packed_run(const struct thumb_packed *run)
{
    THUMB_LOOP(run, PACKED_LOAD, PACKED_PIXEL);
}

SPECIALISED void thumb_shades_run(const struct thumb_shades *run)
{
    THUMB_LOOP(run, SHADES_LOAD, SHADES_PIXEL);
}

#endif

#endif
