#!/usr/bin/env python3
"""panels.py SHEEN - the page of panels that have a driver: the table that `sheen panels` prints from the records."""
import re
import subprocess
import sys

WORDS = ("panel", "controller", "glass", "colours", "MHz", "mode", "B/frame", "frames/s", "notes")


def main(sheen):
    lines = subprocess.run([sheen, "panels"], capture_output=True, text=True, check=True).stdout.splitlines()
    heads = lines[0].split()
    if tuple(heads) != WORDS:
        sys.exit(f"panels.py: the table's columns are {heads}")
    print("# Panels {#panels}\n\nGenerated from the records of hal/records. Frames a second: what the rated clock of the")
    print("bus carries, whatever is drawn. Notes say what is not confirmed.\n")
    print("| " + " | ".join(heads) + " |\n|" + "---|" * len(heads))
    for line in lines[1:]:
        cells = re.split(r"\s{2,}", line.strip(), maxsplit=len(heads) - 1)
        if len(cells) < len(heads) - 1:
            break # the table ends; text follows
        cells += [""] * (len(heads) - len(cells))
        print("| " + " | ".join(cells) + " |")


main(sys.argv[1])
