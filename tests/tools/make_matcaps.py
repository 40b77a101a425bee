#!/usr/bin/env python3
"""Writes core/pixel/matcap_*.c, pictures of a lit sphere, into a folder, or with --check compares them.

A texel shows what a sphere shows where its normal is (x, y, z), with z towards the eye. Only sums, products, quotients
and square roots are used, which IEEE 754 rounds alike everywhere, so that the files have the same bits on all machines.
"""
import os
import sys
from math import sqrt

SIZE = 64   # texels per side
SHARE = 4   # samples per texel and side


def clamp(x):
    return min(max(x, 0.0), 1.0)


def smooth(low, high, x):
    t = clamp((x - low) / (high - low))
    return t * t * (3 - 2 * t)


def mix(a, b, t):
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def add(a, b, t):
    return tuple(p + q * t for p, q in zip(a, b))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def unit(v):
    length = sqrt(dot(v, v))
    return tuple(p / length for p in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def power(x, doublings):
    """x to the power of 2^doublings; 0 for a negative x."""
    x = max(x, 0.0)
    for _ in range(doublings):
        x *= x
    return x


def ramp(stops, t):
    """Interpolates between (position, colour) stops in ascending order."""
    for (low, a), (high, b) in zip(stops, stops[1:]):
        if t <= high:
            return mix(a, b, clamp((t - low) / (high - low)))
    return stops[-1][1]


def mirrored(n):
    """The line of sight, (0, 0, 1), mirrored at n."""
    return (2 * n[2] * n[0], 2 * n[2] * n[1], 2 * n[2] * n[2] - 1)


def fresnel(n, least):
    f = 1 - n[2]
    return least + (1 - least) * f * f * f * f * f


def box(r, towards, up, width, height, soft):
    """
    How much of a lit rectangle at distance 1 the ray r hits, 0..1. towards: the direction of the rectangle's middle;
    width, height: half of its sides.
    """
    side = unit(cross(up, towards))
    up = cross(towards, side)
    depth = dot(r, towards)
    if depth <= 0.02:
        return 0.0
    p, q = abs(dot(r, side) / depth), abs(dot(r, up) / depth)
    return smooth(width + soft, width - soft, p) * smooth(height + soft, height - soft, q)


# ---- the four ----

SUN = unit((-0.45, 0.62, 0.64))
UP, AHEAD = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
SKY = [(0.0, (0.99, 0.97, 0.92)), (0.08, (0.86, 0.91, 0.95)), (0.30, (0.50, 0.68, 0.89)), (0.70, (0.16, 0.33, 0.64)),
       (1.0, (0.05, 0.12, 0.33))]
GROUND = [(0.0, (0.05, 0.04, 0.05)), (0.14, (0.17, 0.12, 0.10)), (0.50, (0.50, 0.39, 0.29)), (1.0, (0.86, 0.77, 0.63))]


def bump(middle, width, x):
    t = (x - middle) / width
    return max(1 - t * t, 0.0) * max(1 - t * t, 0.0)


def chrome(n):
    """Polished metal under a clear sky, on a plain."""
    r = mirrored(n)
    color = mix(ramp(GROUND, max(-r[1], 0.0)), ramp(SKY, max(r[1], 0.0)), smooth(-0.02, 0.02, r[1]))
    color = add(color, (1.0, 0.96, 0.86), 1.1 * power(dot(r, SUN), 7) + 0.22 * power(dot(r, SUN), 3))
    color = mix(color, (0.10, 0.12, 0.17), 0.55 * smooth(0.80, 1.0, 1 - n[2]))
    return mix(color, (0.95, 0.96, 0.98), 0.65 * bump(1.0, 0.10, 1 - n[2]))


def glaze(n):
    """Cobalt under a thick clear glaze, in a room: a window at the upper left, a strip at the right, a warm floor."""
    r = mirrored(n)
    light = clamp(0.5 + 0.5 * dot(n, SUN))
    color = ramp([(0.0, (0.00, 0.02, 0.08)), (0.45, (0.00, 0.11, 0.27)), (0.8, (0.02, 0.30, 0.50)),
                  (1.0, (0.08, 0.46, 0.63))], light)
    room = mix((0.12, 0.09, 0.10), (0.62, 0.70, 0.78), smooth(-0.7, 0.8, r[1]))
    color = mix(color, room, 0.05 + 0.8 * fresnel(n, 0.0))
    side = unit(cross(UP, SUN))
    across, down = dot(r, side), dot(r, cross(SUN, side))
    bars = smooth(0.012, 0.035, abs(across)) * smooth(0.012, 0.035, abs(down))
    window = box(r, SUN, UP, 0.44, 0.40, 0.03)
    strip = box(r, unit((0.93, 0.12, 0.18)), UP, 0.16, 0.95, 0.06)
    floor = box(r, unit((0.10, -0.88, 0.42)), AHEAD, 0.75, 0.14, 0.10)
    color = mix(color, (1.0, 0.99, 0.96), window * (0.25 + 0.70 * bars))
    color = mix(color, (0.80, 0.90, 1.0), 0.60 * strip)
    color = mix(color, (1.0, 0.80, 0.58), 0.30 * floor)
    return add(color, (0.45, 0.62, 0.72), 0.25 * power(dot(r, SUN), 2))


def clay(n):
    """Fired clay, matt: warm light from above, a cool bounce from below."""
    light = 0.5 + 0.5 * dot(n, unit((-0.50, 0.72, 0.50)))
    color = ramp([(0.0, (0.13, 0.06, 0.08)), (0.25, (0.28, 0.12, 0.11)), (0.55, (0.60, 0.30, 0.20)),
                  (0.82, (0.87, 0.55, 0.38)), (1.0, (0.98, 0.75, 0.58))], light * light * (1.75 - 0.75 * light))
    bounce = clamp(dot(n, unit((0.55, -0.75, 0.15))))
    color = add(color, (0.17, 0.12, 0.17), bounce * bounce)
    rim = (1 - n[2]) * (1 - n[2])
    color = add(color, (0.22, 0.10, 0.05), rim * clamp(0.35 + 0.65 * n[1]))
    return add(color, (0.30, 0.25, 0.22), 0.30 * power(dot(mirrored(n), SUN), 2))


def jade(n):
    """Polished jade: dark where it is thick, aglow where light comes through."""
    r = mirrored(n)
    thin = 1 - n[2]
    light = clamp(0.5 + 0.5 * dot(n, SUN))
    color = ramp([(0.0, (0.01, 0.11, 0.09)), (0.4, (0.03, 0.24, 0.16)), (0.75, (0.12, 0.43, 0.28)),
                  (1.0, (0.30, 0.63, 0.43))], light)
    behind = clamp(0.55 - 0.45 * dot(n, SUN))           # largest where the light is on the other side
    color = add(color, (0.42, 0.58, 0.30), thin * thin * (0.45 + 1.1 * behind))
    color = add(color, (0.16, 0.30, 0.12), smooth(0.15, 0.75, thin) * behind)
    color = mix(color, (0.80, 0.95, 0.86), 0.45 * fresnel(n, 0.0))
    shine = power(dot(r, SUN), 5)
    strip = box(r, unit((0.80, 0.45, 0.25)), UP, 0.10, 0.55, 0.09)
    color = mix(color, (0.86, 0.97, 0.88), 0.35 * strip)
    return mix(color, (0.96, 1.0, 0.96), 0.85 * smooth(0.2, 0.85, shine) + 0.15 * power(dot(r, SUN), 3))


MATCAPS = {"chrome": chrome, "glaze": glaze, "clay": clay, "jade": jade}


# ---- texels ----

def color_at(show, u, v):
    """
    The colour at (u, v) in -1..1, v upwards. Outside the sphere it is that of the rim, because filters reach there.
    """
    square = u * u + v * v
    if square >= 1:
        length = sqrt(square)
        return show((u / length, v / length, 0.0))
    return show((u, v, sqrt(1 - square)))


def texel(show, i, j):
    total = (0.0, 0.0, 0.0)
    for k in range(SHARE * SHARE):
        u = (SHARE * i + k % SHARE + 0.5) * 2 / (SHARE * SIZE) - 1
        v = 1 - (SHARE * j + k // SHARE + 0.5) * 2 / (SHARE * SIZE)
        total = add(total, tuple(clamp(c) for c in color_at(show, u, v)), 1.0)
    r, g, b = (int(most * c / (SHARE * SHARE) + 0.5) for most, c in zip((31, 63, 31), total))
    return r << 11 | g << 5 | b


def rows(numbers, width=120, indent=4):
    line = " " * indent
    for number in numbers:
        word = f"{number}, "
        if len(line) + len(word.rstrip()) > width:
            yield line.rstrip()
            line = " " * indent
        line += word
    yield line.rstrip()


def text(name):
    texels = [texel(MATCAPS[name], i, j) for j in range(SIZE) for i in range(SIZE)]
    log = SIZE.bit_length() - 1
    return "\n".join(
        ["/*", f" * matcap_{name}.c - a picture of a sphere, 565, written by tests/tools/make_matcaps.py", " */",
         "/* clang-format off */", '#include "pixel.h"', "",
         f"static const uint16_t {name}_texels[{SIZE} * {SIZE}] = {{", *rows(texels), "};", "",
         f"const struct sheen_texture sheen_matcap_{name} = {{", f"    .texels = {name}_texels,",
         f"    .width_log2 = {log},", f"    .height_log2 = {log},", "    .clamp_u = 1,", "    .clamp_v = 1,", "};", ""])


def main(check, folder):
    for name in MATCAPS:
        path = os.path.join(folder, f"matcap_{name}.c")
        if check:
            with open(path, encoding="utf-8") as written:
                if written.read() != text(name):
                    return f"{path} is not what make_matcaps.py writes"
        else:
            with open(path, "w", encoding="utf-8") as to:
                to.write(text(name))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] == "--check", sys.argv[-1]))
