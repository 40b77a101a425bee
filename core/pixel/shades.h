/*
 * shades.h - private: channels packed in two words, and tables of finished pixels over the diffuse intensity.
 */
#ifndef SHEEN_SHADES_H
#define SHEEN_SHADES_H

#include "../sheen.h"

/*
 * Channels in two words. red_blue is 2^16 red + blue, each UQ5.11, as an exact sum: what blue borrows when it goes
 * below 0, it gives back later. green is UQ6.26.
 */
struct packed {
    uint32_t red_blue, green;
};

/*
 * A colour on a 565 target over the diffuse intensity, without highlight. Without dither, finished pixels: entry i +
 * SHADES_GUARD is for the middle between i / 2^SHADES_BITS and the next; the guard entries catch what rounding puts
 * below 0 or above 1. With dither, segments of width 2^-SEGMENT_BITS, two of them to spare: the channels where a
 * segment begins, and what each 2^-SEGMENT_STEPS_BITS of it adds.
 */
#define SHADES_BITS 10
#define SHADES_GUARD 8
#define SHADES_PIXELS (SHADES_GUARD + (1 << SHADES_BITS) + SHADES_GUARD)

#define SEGMENT_BITS 7
#define SEGMENT_STEPS_BITS 5
#define SEGMENTS ((1 << SEGMENT_BITS) + 2)

struct shade_segment { /* as struct packed, in the order in which loops load them */
    uint32_t red_blue, red_blue_step;
    uint32_t green, green_step;
};

struct shades {
    union {
        uint16_t pixel[SHADES_PIXELS]; /* in the target's byte order */
        struct shade_segment segment[SEGMENTS];
    };
    uint32_t a[3]; /* the struct colour_terms that the table was made from */
    uint16_t b[3];
    uint8_t fraction; /* 0: not made yet */
    uint8_t dither;   /* 1: segments */
};

#endif
