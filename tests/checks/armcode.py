"""Reads Thumb machine code as objdump prints it: functions, their control flow, loops."""
import re
import subprocess

FUNCTION = re.compile(r"^([0-9a-f]+) <([^>]+)>:$")
INSTRUCTION = re.compile(r"^\s*([0-9a-f]+):\t([a-z][a-z0-9.]*)(?:\t(.*))?$")
RELOCATION = re.compile(r"^\s*([0-9a-f]+): (R_ARM_\w+)\t(\S+)")
TARGET = re.compile(r"\b([0-9a-f]+) <")
CONDITION = "(?:eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)"


class Function:
    """One function: instructions as address -> (mnemonic, operands), relocations as address -> symbol."""

    def __init__(self, name):
        self.name = name
        self.code = {}
        self.symbols = {}

    def text(self, address):
        mnemonic, operands = self.code[address]
        return f"{mnemonic} {self.symbols.get(address, operands)}".strip()

    def successors(self):
        """{address: set of addresses in the function that may be executed next}"""
        order = list(self.code)
        following = dict(zip(order, order[1:]))
        graph, jumps = {}, []
        for address in order:
            target, falls_through, computed = self._flow(address)
            graph[address] = {a for a in (target, following.get(address) if falls_through else None) if a in self.code}
            if computed:
                jumps.append(address)
        # A jump table's targets are the addresses that no other instruction leads to.
        reached = set().union(*graph.values(), order[:1]) if order else set()
        for address in jumps:
            graph[address] |= set(order) - reached
        return graph

    def _flow(self, address):
        """(branch target or None, whether the next instruction may follow, whether the target is computed)"""
        mnemonic, operands = self.code[address]
        base = mnemonic.split(".")[0]
        here = TARGET.search(operands) if address not in self.symbols else None
        target = int(here[1], 16) if here else None
        if base == "b":
            return target, False, False
        if base in ("cbz", "cbnz") or re.fullmatch("b" + CONDITION, base):
            return target, True, False
        conditional = re.fullmatch(r"(?:pop|bx|mov|ldr|ldmia|add)" + CONDITION, base) is not None
        if re.match(r"(pop|ldm)", base) and "pc" in operands or re.match(r"bx", base) and operands == "lr":
            return None, conditional, False
        if base in ("tbb", "tbh") or re.match(r"(mov|ldr|add)", base) and re.match(r"pc\b", operands):
            return None, conditional, True
        if base == "bl" and self.symbols.get(address, "").startswith("__gnu_thumb1_case"):
            return None, False, True
        if re.match(r"bx", base) and not base.startswith("blx"):
            return None, conditional, True
        return None, base != "udf", False

    def innermost_loops(self):
        """Each innermost loop as the sorted list of its addresses."""
        graph = self.successors()
        return [sorted(loop) for loop in innermost(graph, set(graph))]

    def outermost_loops(self):
        """Each outermost loop, with the loops inside it, as the sorted list of its addresses."""
        graph = self.successors()
        return [sorted(loop) for loop in loops(graph, set(graph))]


def disassemble(objdump, path):
    """The functions of an object file, with the symbols that their instructions refer to."""
    listing = subprocess.run([objdump, "-dr", "--no-show-raw-insn", path], check=True, capture_output=True, text=True)
    functions = []
    for line in listing.stdout.splitlines():
        if head := FUNCTION.match(line):
            functions.append(Function(head[2]))
        elif reloc := RELOCATION.match(line):
            functions[-1].symbols[int(reloc[1], 16)] = reloc[3]
        elif (code := INSTRUCTION.match(line)) and not code[2].startswith("."):
            operands = re.sub(r"\s*[@;].*", "", code[3] or "")
            functions[-1].code[int(code[1], 16)] = (code[2], operands)
    return functions


def loops(graph, nodes):
    """The strongly connected components that contain an edge."""
    for component in strongly_connected(graph, nodes):
        if len(component) > 1 or component & graph[min(component)]:
            yield component


def innermost(graph, nodes):
    """The innermost loops of a flow graph within nodes, found by removing the entries of loops.

    A strongly connected component is a loop. Whatever is still strongly connected without the loop's entries is a loop
    inside it. This works for loops of any shape.
    """
    for loop in loops(graph, nodes):
        entries = {n for source in graph if source not in loop for n in graph[source] & loop}
        inner = list(innermost(graph, loop - (entries or {min(loop)})))
        if inner:
            yield from inner
        else:
            yield loop


def strongly_connected(graph, nodes):
    """Kosaraju's two passes, without recursion because a function has thousands of instructions."""
    back = {n: set() for n in nodes}
    for n in nodes:
        for m in graph[n] & nodes:
            back[m].add(n)
    finished, seen = [], set()
    for root in sorted(nodes):
        stack = [(root, None)]
        while stack:
            node, rest = stack.pop()
            if rest is None:
                if node in seen:
                    continue
                seen.add(node)
                rest = iter(sorted(graph[node] & nodes))
            child = next(rest, None)
            if child is None:
                finished.append(node)
            else:
                stack.append((node, rest))
                stack.append((child, None))
    assigned = set()
    for root in reversed(finished):
        component, stack = set(), [root]
        while stack:
            node = stack.pop()
            if node not in assigned:
                assigned.add(node)
                component.add(node)
                stack.extend(back[node] - assigned)
        if component:
            yield component
