#!/usr/bin/env python3
"""Writes core/pixel/shines.c, or with --check compares it: power tables as sheen_shine_make() makes them."""
import sys

ENTRIES = 256
SHININESS = [4, 8, 16, 32, 64, 128]
ONE = 0xffffffff


def multiply(a, b):
    """The product of UQ0.32 factors, where 0xffffffff means 1.0, rounded as in core/pixel/shine.c."""
    return (a * b + a + b) >> 32


def raised(s, n):
    result = ONE
    while n:
        if n & 1:
            result = multiply(result, s)
        s = multiply(s, s)
        n >>= 1
    return result


def table(n):
    shift = 0
    while shift < 3 and raised(ONE - (ONE >> (shift + 1)), n) < 1 << 16:
        shift += 1
    exact = [raised(ONE - u, n) if (u := i << (24 - shift)) < ONE else 0 for i in range(ENTRIES + 1)]
    power = [exact[0]] + [max(0, b - (a - b - (b - c)) // 12) for a, b, c in zip(exact, exact[1:], exact[2:])]
    entries = [1 << 15] + [(p >> 17) + (p >> 16 & 1) for p in power] + [0]
    return shift, [a << 16 | (a - b) for a, b in zip(entries, entries[1:])]


def rows(numbers, width=120, indent=8):
    line = " " * indent
    for number in numbers:
        word = f"{number}, "
        if len(line) + len(word.rstrip()) > width:
            yield line.rstrip()
            line = " " * indent
        line += word
    yield line.rstrip()


def text():
    out = ["/*", " * shines.c - power tables of the usual shininesses, written by tests/tools/make_shines.py", " */",
           "/* clang-format off */", '#include "pixel.h"']
    for n in SHININESS:
        shift, power = table(n)
        out += ["", f"const struct sheen_shine sheen_shine_{n} = {{", "    .power = {", *rows(power), "    },",
                f"    .shininess = {n},", f"    .shift = {shift},", "};"]
    return "\n".join(out) + "\n"


if __name__ == "__main__":
    if sys.argv[1] == "--check":
        with open(sys.argv[2], encoding="utf-8") as written:
            sys.exit(0 if written.read() == text() else f"{sys.argv[2]} is not what make_shines.py writes")
    with open(sys.argv[1], "w", encoding="utf-8") as to:
        to.write(text())
