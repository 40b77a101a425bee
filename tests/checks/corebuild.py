"""Compiles the core, or other sources, for a Cortex-M as firmware does, and reads the objects."""
import os
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from functools import cache

from armcode import disassemble

ROOT = os.path.relpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
TOOL = "arm-none-eabi-"
FLAGS = ["-std=c11", "-mthumb", "-ffreestanding", "-ffunction-sections", "-Wall", "-Wextra", "-fstack-usage",
         "-fcallgraph-info=su"]
TARGETS = {"M0+": "cortex-m0plus", "M3": "cortex-m3"}


def tool(name, *args):
    return subprocess.run([TOOL + name, *args], check=True, capture_output=True, text=True).stdout


class Build:
    """The sources compiled for one processor into a folder of their own."""

    def __init__(self, sources, cpu, folder, optimisation="-O2"):
        os.makedirs(folder, exist_ok=True)
        self.flags = [*FLAGS, optimisation, "-mcpu=" + cpu, "-I", os.path.join(ROOT, "core")]
        # the folder is part of the name, because there are frame/edges.c and mesh/edges.c
        self.objects = {s: os.path.join(folder, "_".join(s.split(os.sep)[-2:])[:-2] + ".o") for s in sources}
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(self._compile, self.objects.items()))

    def _compile(self, pair):
        subprocess.run([TOOL + "gcc", *self.flags, "-c", pair[0], "-o", pair[1]], check=True)

    def functions(self, chosen):
        """{source: its functions as machine code} for the sources that `chosen` accepts"""
        return {s: disassemble(TOOL + "objdump", o) for s, o in self.objects.items() if chosen(s)}

    @cache
    def sizes(self, source):
        """(bytes of code, of constants, of state)"""
        code = constants = state = 0
        for line in tool("size", "-A", self.objects[source]).splitlines():
            name, size = (line.split() + ["", ""])[:2]
            if name.startswith(".text"):
                code += int(size)
            elif name.startswith(".rodata"):
                constants += int(size)
            elif re.match(r"\.(data|bss|tdata|tbss)", name):
                state += int(size)
        return code, constants, state

    def linked(self, names):
        """Bytes of code that a linker keeps for these names, without functions of libgcc."""
        program = os.path.join(os.path.dirname(next(iter(self.objects.values()))), "linked.elf")
        wanted = [f"-Wl,--undefined={name}" for name in names]
        subprocess.run([TOOL + "gcc", *self.flags, "-nostdlib", "-Wl,--gc-sections,--entry=0,--no-warn-rwx-segments,"
                        "--unresolved-symbols=ignore-all", *wanted, *self.objects.values(), "-o", program], check=True)
        return sum(int(line.split()[1]) for line in tool("size", "-A", program).splitlines()
                   if line.startswith(".text"))

    @cache
    def symbols(self, source):
        """[(name, letter of nm)]; the letter C marks common variables, which are in no section of an object."""
        return [tuple(line.split()[:2]) for line in tool("nm", "-P", self.objects[source]).splitlines()]

    def address_taken(self):
        """Names of functions whose address is in data or code. (Jump tables refer to sections instead.)"""
        taken = set()
        for obj in self.objects.values():
            for line in tool("objdump", "-r", obj).splitlines():
                if m := re.search(r"R_ARM_(?:ABS32|\w*MOV[WT]\w*)\s+(\w[\w.]*)", line):
                    taken.add(m[1])
        return taken

    def call_files(self):
        """Paths of gcc's call graphs (callgraph.py)."""
        return [obj[:-2] + ".ci" for obj in self.objects.values()]
