"""Runs the scenes (guest.c) and an example (example.c) on processors in qemu; counts instructions and memory."""
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from rows import Row

HERE = Path(__file__).resolve().parent
TOP = HERE.parent.parent
KB, MILLION = 1024, 1e6
PIXELS = 320 * 240
ARM = ["arm-none-eabi-gcc", "-mthumb"]
RISCV = ["riscv64-unknown-elf-gcc", "-march=rv32imc", "-mabi=ilp32", "-mno-relax", "--specs=picolibc.specs"]


@dataclass
class Guest:
    compiler: list
    source: str
    code: int  # addresses of code and data
    data: int
    machine: list
    level: str = "-O2"


def cortex(cpu, board="mps2-an385", tick_ns=40, code=0, data=0x20000000, level="-O2"):
    return Guest([*ARM, f"-mcpu={cpu}", f"-DTICK_NS={tick_ns}"], "cortex.c", code, data,
                 ["qemu-system-arm", "-M", board], level)


GUESTS = {
    "M0+": cortex("cortex-m0plus"),
    "M3": cortex("cortex-m3"),
    "M4": cortex("cortex-m4", "mps2-an386"),
    "M33": cortex("cortex-m33", "mps2-an505", 50, 0x10000000, 0x38000000),
    "rv32imc": Guest(RISCV, "riscv.c", 0x80000000, 0x80400000, ["qemu-system-riscv32", "-M", "virt", "-bios", "none"]),
}
# What projects get that compile for size or for debugging; of these only a few rows are measured.
for level in ("-Os", "-Og", "-O0"):
    GUESTS[f"M0+ {level}"] = cortex("cortex-m0plus", level=level)
    GUESTS[f"M3 {level}"] = cortex("cortex-m3", level=level)
FEW = re.compile(r"(flat|gouraud|phong|textured lit|matcap)$")
MORE = "( dithered| fogged| stippled| morphed| smooth| outlined| wired)?"
LINE = re.compile(rf"^(S\d|teapot) (\w+){MORE} (\d+) (\d+) memory (\d+) (\d+) (\d+) (\d+) (\d+) $", re.M)


def run(command):
    """The output of a command, both streams. If the command fails, exits with that output."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=900)
    if done.returncode != 0:
        sys.exit(f"report: {' '.join(map(str, command))} ended with {done.returncode}\n{done.stdout}")
    return done.stdout


EXAMPLE = [f"-I{TOP / 'firmware'}", f"-I{TOP / 'firmware/examples'}", HERE / "example.c",
           TOP / "firmware/examples/mist.c"]


FLAGS = ["-std=c11", f"-I{HERE}", f"-I{TOP / 'core'}"]


def core(compiler, work):
    """The object files of the core, compiled once for all programs of a compiler with its options."""
    folder = Path(work, "_".join(compiler).replace("/", "_"))
    sources = sorted((TOP / "core").rglob("*.c"))
    objects = [folder / f"{i}.o" for i in range(len(sources))]
    if not folder.exists():
        folder.mkdir()
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(lambda pair: run([*compiler, *FLAGS, "-c", pair[0], "-o", pair[1]]), zip(sources, objects)))
    return objects


def build(guest, program, work):
    """Builds an image from a program's flags and sources and the core."""
    image = f"{work}/guest.elf"
    compiler = [*guest.compiler, guest.level]
    run([*compiler, *FLAGS, "-nostartfiles", "-T", HERE / "guest.ld",
         f"-Wl,--defsym=CODE={guest.code:#x},--defsym=DATA={guest.data:#x}", HERE / guest.source, *program,
         *core(compiler, work), "-o", image])
    return image


def output(guest, program, work):
    """What a program prints on this processor."""
    image = build(guest, program, work)
    text = run([*guest.machine, "-icount", "shift=0", "-display", "none", "-semihosting", "-kernel", image])
    loop = re.search(r"loop (\d+) of (\d+)", text)
    if not loop or abs(int(loop[1]) - int(loop[2])) > 100:
        sys.exit(f"report: the counter of {' '.join(guest.machine)} is off\n{text}")
    return text


def example_of(text):
    return int(re.search(r"^mist (\d+) $", text, re.M)[1])


def example_cycles(rp2040js, work):
    """Cycles of the example on an RP2040; rp2040js: the package's folder."""
    program = ["-DCOUNTED_BY_HOST", "-Wl,--defsym=ROOM=0x40000", *EXAMPLE]
    image = build(cortex("cortex-m0plus", code=0x10000000), program, work)
    run(["arm-none-eabi-objcopy", "-O", "binary", image, f"{work}/guest.bin"])
    return example_of(run(["node", HERE / "rp2040.mjs", f"{work}/guest.bin", rp2040js]))


def rows_of(machine, counts):
    """
    counts: {(scene, shading, more, rows per band): instructions}. A row with `more` (" dithered") holds the difference
    from the row without it.
    """
    for (scene, shading, more, band), count in counts.items():
        unit, per = ("px", PIXELS) if scene == "S3" else ("M", MILLION)
        whole = counts.get((scene, shading, "", 240))
        if band != 16 or more and scene not in ("S1", "S3", "teapot"):
            continue
        if more:
            plain = counts[scene, shading, "", 16]
            yield Row(f"{machine} {scene} {shading}{more}", (count - plain) / per, unit, plain / per)
        else:
            yield Row(f"{machine} {scene} {shading}", count / per, unit,
                      remark=f"one band takes {whole / count:.3f}" if whole else "")


def memory_rows(lines):
    """Memory of S1 in bands of 16 rows, without edges or morph, for the shading that needs most."""
    parts = [[int(n) for n in m.groups()[5:]] for m in lines if (m[1], m[3], m[4]) == ("S1", None, "16")]
    arena, vertices, lists, bands, tables = map(max, zip(*parts))
    for what, size in (("whole", arena + tables), ("vertices", vertices), ("lists", lists), ("bands", bands),
                       ("rest", arena + tables - vertices - lists - bands)):
        yield Row(f"RAM of S1, {what}", size / KB, "KB")


def measure(machine, data, work):
    """The rows of a processor. M3 gives the memory as well, since pointers have the same size on all of them."""
    guest = GUESTS[machine]
    lines = list(LINE.finditer(output(guest, [HERE / "guest.c", HERE / "scenes.c", data], work)))
    counts = {(m[1], m[2].replace("_", " "), m[3] or "", int(m[4])): int(m[5]) for m in lines}
    if guest.level != "-O2":
        return [row for row in rows_of(machine, counts) if " S1 " in row.name and FEW.search(row.name)]
    example = example_of(output(guest, EXAMPLE, work))
    return [*rows_of(machine, counts), Row(f"{machine} example mist", example / MILLION, "M"),
            *(memory_rows(lines) if machine == "M3" else ())]
