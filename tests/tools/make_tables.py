#!/usr/bin/env python3
"""Writes core/math/tables.c, or with --check compares it. The tables are data; this is their definition."""
import math
import sys


def rows(values, per_line=12):
    lines = []
    for start in range(0, len(values), per_line):
        lines.append("    " + ", ".join(str(v) for v in values[start:start + per_line]) + ",")
    return "\n".join(lines)


def u16(value):
    return min(65535, math.floor(value + 0.5))


def text():
    reciprocal = [u16(32768 * 256 / (128 + i)) for i in range(129)]
    root = [u16(32768 * math.sqrt(512 / (128 + i))) for i in range(387)]
    return f"""/*
 * tables.c - the core's constant tables, written by tests/tools/make_tables.py
 * and compared with it by the tests. Values round to nearest; 2.0 in UQ1.15 is
 * held at 65535.
 */
#include "newton.h"

/* clang-format off */
const uint16_t sheen_reciprocal_table[RECIPROCAL_ENTRIES] = {{
{rows(reciprocal)}
}};

/* SHEEN_TEST_ROOT_FAULT spoils one entry by 1/64 of its value: the accuracy test has to see it. */
#ifdef SHEEN_TEST_ROOT_FAULT
#define ROOT(i, value) ((i) == (SHEEN_TEST_ROOT_FAULT) ? (value) - (value) / 64 : (value))
#else
#define ROOT(i, value) (value)
#endif

const uint16_t sheen_root_table[ROOT_ENTRIES] = {{
{rows([f"ROOT({i}, {v})" for i, v in enumerate(root)], 6)}
}};
"""


def main():
    path = sys.argv[-1]
    if "--check" in sys.argv:
        with open(path, encoding="ascii") as file:
            if file.read() != text():
                sys.exit(f"{path}: differs from its definition; run {sys.argv[0]} {path}")
        return
    with open(path, "w", encoding="ascii") as file:
        file.write(text())


main()
