#!/usr/bin/env python3
"""plan.py SHEEN [--readme README.md [--update]] - the page of what `sheen plan` says about the demo's teapot.

--readme: checks the page's table between two marks in that file, and exits with 1 if it differs; --update rewrites it.
"""
import argparse
import contextlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path

PANELS = ("st7789-240x240", "ili9341", "ssd1306")
SHADINGS = {"flat": "flat", "gouraud": "Gouraud", "phong": "Phong"}
MARKS = re.compile(r"(<!-- sheen plan: .*? -->\n).*?(<!-- end of it -->\n)", re.S)


def plan(sheen, panel, shade):
    return json.loads(subprocess.run([sheen, "plan", "builtin:teapot", "--panel", panel, "--shade", shade,
                                      "--buffers", "2", "--json"],
                                     check=True, capture_output=True, text=True).stdout)


def row(*cells):
    return "| " + " | ".join(cells) + " |"


def rate(board):
    """Mean and worst frames per second, sending only what changes, with two buffers; or why it does not fit."""
    if board["ram"]["short"]:
        return "no RAM"
    if board["flash"]["short"]:
        return "no flash"
    rates = board["changed"]["two_buffers"]
    return "over 999" if rates["worst"] >= 999.5 else f"{rates['mean']:.0f} ({rates['worst']:.0f})"


def table(sheen):
    plans = {(panel, shade): plan(sheen, panel, shade) for panel in PANELS for shade in SHADINGS}
    yield row("", "", *(f"{panel} {SHADINGS[shade]}" for panel, shade in plans))
    yield row(*["---"] * (2 + len(plans)))
    for number, board in enumerate(next(iter(plans.values()))["boards"]):
        yield row(board["board"], "measured" if board["measured"] else "estimated",
                  *(rate(p["boards"][number]) for p in plans.values()))
    yield row("RAM, KB", "counted", *(f"{p['ram']['all'] / 1024:.0f} ({p['ram']['least'] / 1024:.0f})"
                                      for p in plans.values()))


def page(sheen, lines):
    costs = plan(sheen, PANELS[0], "flat")["costs"]
    return ["# Will it run on my board? {#plan}", "",
            "What `sheen plan` says of the demo's teapot, 992 triangles, dithered: frames a second in the mean of a turn"
            " and at worst, of",
            "what changes, with two buffers and bands of 16 rows. *Measured* are cycles of the emulated processor,"
            " *estimated* instructions in",
            "QEMU times cycles an instruction; `sheen plan MESH --board NAME` tells where the time goes, and what to"
            " change first. RAM is what", "default capacities take (what this turn takes).", "", *lines, "", f"Costs: {costs}."]


def replace(path, text):
    """The file is the old one or the new one at any time, never a part of it."""
    part = path.with_name(path.name + ".part")
    try:
        part.write_text(text, encoding="utf-8")
        os.replace(part, path)
    except OSError as error:
        sys.exit(f"plan.py: {path}: {error.strerror}")
    finally:
        with contextlib.suppress(OSError):
            part.unlink()


def main():
    parser = argparse.ArgumentParser(prog="plan.py")
    parser.add_argument("sheen")
    parser.add_argument("--readme", type=Path)
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    lines = list(table(arguments.sheen))
    if not arguments.readme:
        print("\n".join(page(arguments.sheen, lines)), flush=True)
        return 0
    text = arguments.readme.read_text(encoding="utf-8")
    if not MARKS.search(text):
        sys.exit(f"plan.py: {arguments.readme}: no marks for the table")
    new = MARKS.sub(lambda m: m[1] + "\n".join(["", *lines, "", ""]) + m[2], text)
    if arguments.update:
        replace(arguments.readme, new)
    elif new != text:
        print(f"plan.py: {arguments.readme}: its table is not what `sheen plan` says: --update", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except OSError as error:
        sys.exit(f"plan.py: {error.filename or 'standard output'}: {error.strerror}")
    except subprocess.CalledProcessError as error:
        sys.exit(f"plan.py: {error.stderr.strip() or error}")
