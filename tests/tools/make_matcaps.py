#!/usr/bin/env python3
"""Write core/pixel/matcap_*.c into a folder, or with --check compare them: pictures of a lit sphere, of our own making.

A texel is what a sphere shows where its normal is (x, y, z), z towards the eye. Nothing but sums, products, quotients and
square roots, which IEEE 754 rounds alike everywhere, so that the files are the same bits wherever this runs.
"""
import os
import sys
from math import sqrt

SIZE = 64   # texels a side
SHARE = 4   # samples a texel and side


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
    """x to the power of 2^doublings, 0 below 0."""
    x = max(x, 0.0)
    for _ in range(doublings):
        x *= x
    return x


def ramp(stops, t):
    """Between (position, colour) stops, ascending."""
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
    """How much of a lit rectangle at distance 1 a ray r meets; towards: its middle, width and height: half of its sides."""
    side = unit(cross(up, towards))
    up = cross(towards, side)
    depth = dot(r, towards)
    if depth <= 0.02:
        return 0.0
    p, q = abs(dot(r, side) / depth), abs(dot(r, up) / depth)
    return smooth(width + soft, width - soft, p) * smooth(height + soft, height - soft, q)


# ---- the four ----

SUN = unit((-0.45, 0.62, 0.64))
SKY = [(0.0, (0.97, 0.97, 0.95)), (0.10, (0.80, 0.88, 0.95)), (0.35, (0.45, 0.63, 0.86)), (0.75, (0.15, 0.30, 0.60)),
       (1.0, (0.06, 0.13, 0.34))]
GROUND = [(0.0, (0.07, 0.05, 0.05)), (0.16, (0.20, 0.14, 0.11)), (0.55, (0.52, 0.41, 0.31)), (1.0, (0.80, 0.71, 0.58))]


def chrome(n):
    r = mirrored(n)
    color = mix(ramp(GROUND, -r[1]), ramp(SKY, r[1]), smooth(-0.025, 0.025, r[1]))
    color = add(color, (1.0, 0.97, 0.90), 0.9 * power(dot(r, SUN), 6) + 0.18 * power(dot(r, SUN), 3))
    return mix(color, (0.93, 0.95, 0.97), 0.55 * fresnel(n, 0.0))


def glaze(n):
    r = mirrored(n)
    light = clamp(0.5 + 0.5 * dot(n, SUN))
    color = ramp([(0.0, (0.00, 0.03, 0.10)), (0.45, (0.01, 0.14, 0.30)), (0.8, (0.03, 0.33, 0.52)), (1.0, (0.09, 0.47, 0.63))],
                 light)
    room = mix((0.10, 0.09, 0.10), (0.58, 0.66, 0.74), smooth(-0.7, 0.8, r[1]))
    color = mix(color, room, 0.05 + 0.75 * fresnel(n, 0.0))
    key = box(r, SUN, (0.0, 1.0, 0.0), 0.42, 0.36, 0.035)
    strip = box(r, unit((0.93, 0.12, 0.18)), (0.0, 1.0, 0.0), 0.16, 0.95, 0.06)
    low = box(r, unit((0.10, -0.88, 0.42)), (0.0, 0.0, 1.0), 0.75, 0.14, 0.10)
    color = mix(color, (1.0, 0.99, 0.96), 0.92 * key)
    color = mix(color, (0.80, 0.90, 1.0), 0.55 * strip)
    color = mix(color, (1.0, 0.80, 0.58), 0.30 * low)
    return add(color, (0.45, 0.60, 0.70), 0.22 * power(dot(r, SUN), 2))


def clay(n):
    light = 0.5 + 0.5 * dot(n, unit((-0.50, 0.70, 0.58)))
    color = ramp([(0.0, (0.21, 0.10, 0.10)), (0.30, (0.37, 0.18, 0.15)), (0.62, (0.68, 0.37, 0.26)), (0.86, (0.88, 0.57, 0.41)),
                  (1.0, (0.97, 0.73, 0.57))], light * light * (1.9 - 0.9 * light))
    bounce = clamp(dot(n, unit((0.45, -0.80, 0.20))))
    color = add(color, (0.16, 0.10, 0.13), bounce * bounce)
    rim = (1 - n[2]) * (1 - n[2])
    color = add(color, (0.15, 0.07, 0.04), rim * clamp(0.4 + 0.6 * n[1]))
    return add(color, (0.30, 0.25, 0.22), 0.25 * power(dot(mirrored(n), SUN), 2))


def jade(n):
    r = mirrored(n)
    through = 1 - n[2]                                  # thin at the rim: light that comes from behind
    light = clamp(0.5 + 0.5 * dot(n, SUN))
    color = ramp([(0.0, (0.02, 0.13, 0.09)), (0.4, (0.05, 0.29, 0.18)), (0.75, (0.17, 0.50, 0.32)), (1.0, (0.33, 0.66, 0.44))],
                 light)
    glow = clamp(0.55 - 0.45 * dot(n, SUN))             # most where the light is behind
    color = add(color, (0.36, 0.55, 0.33), through * through * (0.35 + 1.25 * glow))
    color = add(color, (0.12, 0.20, 0.08), clamp(through * 1.6) * glow)
    shine = power(dot(r, SUN), 5)
    color = mix(color, (0.95, 1.0, 0.95), 0.80 * smooth(0.25, 0.85, shine) + 0.12 * power(dot(r, SUN), 3))
    return color


MATCAPS = {"chrome": chrome, "glaze": glaze, "clay": clay, "jade": jade}


# ---- texels ----

def color_at(show, u, v):
    """At (u, v) in -1..1, v upwards; beyond the sphere as at its rim, for filters reach there."""
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
         "/* clang-format off */", '#include "pixel.h"', "", f"static const uint16_t {name}_texels[{SIZE} * {SIZE}] = {{",
         *rows(texels), "};", "", f"const struct sheen_texture sheen_matcap_{name} = {{",
         f"    .texels = {name}_texels, .width_log2 = {log}, .height_log2 = {log}, .clamp_u = 1, .clamp_v = 1,", "};", ""])


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
