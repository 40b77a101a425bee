/*
 * sheen_speed.h - private: included at the top of each of the core's sources in the Arduino library.
 *
 * Arduino's cores compile for size, and then a frame takes up to 1.6 times as long (README.md, Numbers). These sources
 * are compiled for speed instead, unless SHEEN_SMALL is defined.
 */
#ifndef SHEEN_SPEED_H
#define SHEEN_SPEED_H

#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE_SIZE__) && !defined(SHEEN_SMALL)
#pragma GCC optimize("O2")
#ifdef __ARM_ARCH_6M__ /* given -Os, GCC saves none of r8 to r11 there, in spite of the pragma */
#define SHEEN_NO_ASSEMBLY
#endif
#endif

#endif
