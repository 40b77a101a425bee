/*
 * wire.h - prints what leaves a stand-in's wires, in the format that tests/boards/glass.c replays. The bytes of a
 * transfer under way are read when it completes, so writing to its buffer before that changes the output.
 */
#ifndef WIRE_H
#define WIRE_H

#include <stdint.h>
#include <stdio.h>

static int wire_level = 1; /* level of D/C: 0 command, 1 data */
static const void *wire_flying;
static size_t wire_count;

static inline void wire_record(int kind, const void *bytes, size_t count)
{
    if (count == 0)
        return;
    putchar(kind);
    for (int i = 0; i < 4; i++)
        putchar((int)(count >> 8 * i & 255));
    fwrite(bytes, 1, count, stdout);
}

static inline void wire_number(int kind, uint32_t value)
{
    uint8_t bytes[4] = {(uint8_t)value, (uint8_t)(value >> 8), (uint8_t)(value >> 16), (uint8_t)(value >> 24)};

    wire_record(kind, bytes, 4);
}

static inline void wire_bytes(const void *bytes, size_t count)
{
    wire_record(wire_level ? 'D' : 'C', bytes, count);
}

static inline void wire_launch(const void *bytes, size_t count)
{
    wire_flying = bytes;
    wire_count = count;
}

static inline void wire_land(void)
{
    wire_bytes(wire_flying, wire_flying ? wire_count : 0);
    wire_flying = NULL;
}

#endif
