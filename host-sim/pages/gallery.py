#!/usr/bin/env python3
"""gallery.py SHEEN_SOURCE CORE_LIBRARY OUT - the gallery: each example's last frame, and the lines that draw it.

Compiles and runs the examples. Writes one PNG per example to OUT/pictures, and the page to standard output.
"""
import glob
import os
import re
import struct
import subprocess
import sys
import zlib

WIDTH, FRAMES = 240, 3
LINES = 10


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout


def png(ppm):
    head, pixels = ppm.split(b"\n", 1)
    width, height = map(int, head.split()[1:3])
    rows = b"".join(b"\0" + pixels[y * width * 3:(y + 1) * width * 3] for y in range(height))
    chunk = lambda kind, data: (struct.pack(">I", len(data)) + kind + data
                                + struct.pack(">I", zlib.crc32(kind + data)))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def heart(text):
    """The function that draws a picture, cut to LINES lines."""
    lines = re.search(r"^int example_draw\(.*?^}$", text, re.M | re.S)[0].splitlines()
    return lines if len(lines) <= LINES else lines[:LINES - 1] + ["    ..."]


def main(source, library, out):
    pictures = os.path.join(out, "pictures")
    os.makedirs(pictures, exist_ok=True)
    print("# Gallery {#gallery}\n\nEach picture is the third frame of a program in firmware/examples, drawn when this")
    print("page was made; below it the lines that draw it.")
    for path in sorted(glob.glob(os.path.join(source, "firmware", "examples", "*.c"))):
        name = os.path.splitext(os.path.basename(path))[0]
        with open(path, encoding="utf-8") as f:
            text = f.read()
        program = os.path.join(out, name)
        run("gcc", "-O1", *(f"-I{source}/{p}" for p in ("core", "firmware", "firmware/examples")), path,
            f"{source}/host-sim/pages/picture.c", library, "-pthread", "-o", program)
        with open(os.path.join(pictures, f"{name}.png"), "wb") as f:
            f.write(png(run(program, str(WIDTH), str(FRAMES))))
        what = re.match(r"/\*\n \* \S+ - (.*?)(?:\n \*\n|\n \*/)", text, re.S)[1].replace("\n *", "")
        print(f"\n## {name}.c\n\n{what[0].upper()}{what[1:]}\n\n![{name}]({name}.png)\n\n```c")
        print("\n".join(heart(text)) + "\n```")


try:
    main(*sys.argv[1:])
except OSError as error:
    sys.exit(f"gallery.py: {error.filename or sys.argv[-1]}: {error.strerror}")
except subprocess.CalledProcessError as error:
    sys.exit(f"gallery.py: {error}")
