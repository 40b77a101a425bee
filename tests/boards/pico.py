"""Runs the demo on an emulated Raspberry Pi Pico and reads the results."""
import bisect
import json
import os
import re

from emulated import Failed, read_pictures, run

LEAST_BANDS = 8  # of 15; the teapot and the text touch at least as many
# Cycles that the firmware spends outside the frame between the key and the first letter of its answer, at most.
OVERHEAD = 4000
TICK = 125  # cycles; the firmware's clock has steps of a microsecond


class Pico:
    """The results of a run of the firmware."""

    def __init__(self, folder, uf2, keys, *alone):
        self.out = os.path.join(folder, ".".join((uf2, str(len(keys)), *alone)))
        run("node", os.path.join(folder, "rp2040js", "run.mjs"), os.path.join(folder, "uf2", f"{uf2}.uf2"), keys,
            self.out, *alone)
        with open(self.out + ".json", encoding="utf-8") as f:
            measured = json.load(f)
        with open(self.out + ".log", encoding="utf-8") as f:
            self.log = f.read()
        self.frames, self.restarts, self.spi_hz = measured["frames"], measured["restarts"], measured["spiHz"]

    def pictures(self, glass, panel, pixels):
        run(glass, "replay", panel, self.out + ".wire", self.out + ".pictures")
        return read_pictures(self.out + ".pictures", pixels)


def check_frame(frame):
    """The firmware's own numbers must agree with the emulator's; each band must feed the watchdog."""
    clocks, sent, us = map(int, re.search(r": (\d+) clocks, bus (\d+) B, (\d+) us", frame["line"]).groups())
    if not -TICK <= frame["cycles"] - clocks <= OVERHEAD:
        raise Failed(f"'{frame['line']}', but it took {frame['cycles']} cycles")
    if sent != frame["bytes"]:
        raise Failed(f"'{frame['line']}', but {frame['bytes']} B left SPI0")
    if abs(frame["busy"] / 125 - us) > 1:
        raise Failed(f"'{frame['line']}', but the bus was busy for {frame['busy'] / 125:.0f} us")
    drawing, waiting = map(int, re.search(r"drawing (\d+), waiting (\d+)", frame["line"]).groups())
    if abs(drawing + waiting - clocks) > 1 or waiting >= clocks:
        raise Failed(f"'{frame['line']}': drawing and waiting are not the whole")
    if not LEAST_BANDS <= frame["rectangles"] <= frame["feeds"]:
        raise Failed(f"'{frame['line']}': {frame['rectangles']} bands, the watchdog was fed {frame['feeds']} times")


def lap(line):
    """From the running demo's log: a frame's clocks for drawing, waiting and sending; and frames per second."""
    us, drawing, waiting, rate = re.search(r"(\d+) us, drawing (\d+), waiting (\d+), ([\d.]+) frames/s", line).groups()
    return int(drawing), int(waiting), 125 * int(us), float(rate)


def functions(elf):
    """Sorted start addresses, and names."""
    rows = [line.split() for line in run("arm-none-eabi-nm", "-n", elf).splitlines()]
    rows = [(int(row[0], 16) & ~1, row[2]) for row in rows if row[1] in "tTW" and not row[2].startswith("$")]
    return [row[0] for row in rows], [row[1] for row in rows]


def print_profile(folder, frames):
    starts, names = functions(os.path.join(folder, "rp2040", "firmware", "rp2040", "rp2040.elf"))
    spent = {}
    for frame in frames:
        for address, cycles in frame["profile"].items():
            name = names[bisect.bisect(starts, int(address)) - 1]
            spent[name] = spent.get(name, 0) + cycles
    total = sum(spent.values())
    print("where the cycles of a frame go:")
    for name, cycles in sorted(spent.items(), key=lambda item: -item[1])[:12]:
        print(f"  {cycles / len(frames):10.0f}  {100 * cycles / total:5.1f} %  {name}")
