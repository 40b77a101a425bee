/*
 * sheen_speed.h - private: included at the top of each of the core's sources in the Arduino library.
 *
 * Arduino's cores compile for size, and then a frame takes up to 1.6 times as long (README.md, Numbers). These sources
 * are compiled for speed instead. On an RP2040 or RP2350, whose flash is outside the chip, what takes most of a frame
 * is copied to RAM besides; their linker scripts do so for these sections. SHEEN_SMALL, if defined, does neither.
 */
#ifndef SHEEN_SPEED_H
#define SHEEN_SPEED_H

#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE_SIZE__) && !defined(SHEEN_SMALL)
#pragma GCC optimize("O2")
#endif

/* ARDUINO_ARCH_RP2040: the core of Earle Philhower, on both chips; TARGET_RP2040: Arduino's own. */
#if (defined(ARDUINO_ARCH_RP2040) || defined(TARGET_RP2040)) && !defined(SHEEN_SMALL) && !defined(SHEEN_HOT_SECTION)
#define SHEEN_HOT_SECTION .time_critical.sheen
#endif

#endif
