#!/usr/bin/env python3
"""numbers.py BUDGET - the page of what a frame costs, by processor and on the Pico. BUDGET is tests/bench/budget, which
the bench checks against what it measures."""
import re
import sys

SHADINGS = ("flat", "gouraud", "phong", "slerp")
SCENES = {"S1": "a sphere of 3,968 triangles that covers 45 % of 320x240", "S2": "a torus of 2,000 triangles",
          "S5": "a coarse sphere, 80 triangles"}
PROCESSORS = {"M0+": "Cortex-M0+", "M3": "Cortex-M3", "M4": "Cortex-M4", "M33": "Cortex-M33", "rv32imc": "rv32imc",
              "x86-64": "x86-64"}
PICO_MHZ = 125


def budget(path):
    """A dictionary from each row's name to its measured value."""
    with open(path, encoding="utf-8") as f:
        rows = (re.match(r"(\S.*?)\s{2,}(?:M|px|KB)\s+(-?[\d.]+)\s", line) for line in f)
        return {row[1]: float(row[2]) for row in rows if row}


def row(*cells):
    return "| " + " | ".join(cells) + " |"


def frames(table, scene):
    lines = [row("processor", *(shading.replace("gouraud", "Gouraud").replace("phong", "Phong") for shading in SHADINGS)),
             row(*["---"] * (1 + len(SHADINGS)))]
    for name, words in PROCESSORS.items():
        lines.append(row(words, *(f"{table[f'{name} {scene} {shading}']:.2f}" for shading in SHADINGS)))
    return lines


def main(path):
    table = budget(path)
    mean, worst, alone = (table[f"RP2040 teapot phong, {which}"] for which in ("mean", "worst", "1 core, mean"))
    print("# Numbers {#numbers}\n\nWhat the bench measured last (`tests/run bench`; gcc -O2, bands of 16 rows; instructions",
          "by QEMU and callgrind,\nclocks by rp2040js).")
    for scene, words in SCENES.items():
        print(f"\n## Million instructions a frame: {words}\n", *frames(table, scene), sep="\n")
    print(f"\n## Raspberry Pi Pico at {PICO_MHZ} MHz, measured\n\nThe demo's teapot on 240x240 in Phong takes {mean:.1f}",
          f"million clocks in the mean of 60 views, {worst:.1f} at most: {PICO_MHZ / worst:.0f} to {PICO_MHZ / mean:.0f}",
          f"frames a\nsecond on both cores, sending beside drawing; {PICO_MHZ / alone:.0f} on one.",
          "Other processors: clock over instructions is the most that can\ncome; flash with wait states and slow memories",
          "take from it.")
    print(f"\n## Memory\n\nThe first sphere's frame takes {table['RAM of S1, whole']:.1f} KB in all:",
          f"{table['RAM of S1, bands']:.1f} a band's colour and depth, {table['RAM of S1, vertices']:.1f}\nits vertices,",
          f"{table['RAM of S1, lists']:.1f} its lists. The stack of the core stays within 1 KB.")


main(sys.argv[1])
