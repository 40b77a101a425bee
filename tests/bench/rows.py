"""Compares what is measured with its budgets, and with the targets called bar and beyond (the file budget).

Each line of budget holds a row: name, unit, budget, bar, beyond, separated by two or more spaces; - means none. A row
more than SLACK above its budget fails; for a row more than SLACK below it, a lower budget is suggested. Once a budget
is within its bar, the measured value must be too.
"""
import re
import sys
from dataclasses import dataclass
from pathlib import Path

FILE = Path(__file__).resolve().parent / "budget"
SLACK = 0.02
HEAD = """\
# The bench's budgets (rows.py): name, unit, budget, bar, goal beyond it. More than 2 % above the budget fails;
# tests/bench/report --update sets budgets to what is measured. M: millions of instructions or clocks per frame; px:
# instructions per pixel; KB: 1,024 B. Rows called dithered, fogged, stippled (half of the pixels), morphed, smooth
# (contours), outlined or wired are what that adds to the plain frame.
"""


@dataclass
class Row:
    name: str
    value: float
    unit: str
    whole: float = 0  # SLACK is a share of this, or of the budget if that is larger
    remark: str = ""

    def change(self, budget):
        """How far the value is above its budget, as a share of the whole."""
        return (self.value - budget) / (max(budget, self.whole) or 1)


@dataclass
class Limits:
    unit: str
    budget: float | None = None
    bar: float | None = None
    beyond: float | None = None

    def refuses(self, row):
        """Why a row is too much, or None."""
        if self.budget is None:
            return "it has no budget"
        if row.change(self.budget) > SLACK:
            return f"more than {100 * SLACK:.0f} % above its budget of {show(self.budget)}"
        if self.bar is not None and row.value > self.bar >= self.budget:
            return f"above its bar of {show(self.bar)}, which was kept"
        return None

    def may_sink(self, row):
        return self.budget is not None and row.change(self.budget) < -SLACK


def show(number):
    return "-" if number is None else f"{round(number, 3) + 0.0:.3f}"


def read():
    """{name: Limits}"""
    limits = {}
    for number, line in enumerate(FILE.read_text().splitlines(), 1):
        if line.startswith("#") or not line:
            continue
        fields = re.split(r"\s{2,}", line.strip())
        if len(fields) != 5 or fields[0] in limits:
            sys.exit(f"{FILE.name}:{number}: not a row of name, unit, budget, bar, beyond, or its second: {line}")
        limits[fields[0]] = Limits(fields[1], *(None if f == "-" else float(f) for f in fields[2:]))
    return limits


def write(limits):
    width = max(map(len, limits))
    lines = [f"{name:<{width}}  {l.unit:<6}  {show(l.budget):>9}  {show(l.bar):>7}  {show(l.beyond):>7}"
             for name, l in sorted(limits.items())]
    FILE.write_text(HEAD + "\n".join(lines) + "\n")


def update(rows):
    limits = read()
    for row in rows:
        limits.setdefault(row.name, Limits(row.unit)).budget = row.value
    write(limits)


def print_table(rows, limits):
    width = max(len(row.name) for row in rows)
    print(f"{'':<{width}}  {'unit':<6}  {'measured':>9}  {'budget':>9}  {'':>7}  {'bar':>7}  {'beyond':>7}")
    for row in sorted(rows, key=lambda r: r.name):
        l = limits.get(row.name, Limits(row.unit))
        change = "" if l.budget is None else f"{100 * row.change(l.budget):+.1f} %"
        print(f"{row.name:<{width}}  {row.unit:<6}  {show(row.value):>9}  {show(l.budget):>9}  {change:>7}  "
              f"{show(l.bar):>7}  {show(l.beyond):>7}  {row.remark}".rstrip())


def judge(rows, limits):
    """Prints the table and the conclusions. Returns how many rows are refused."""
    print_table(rows, limits)
    refused = [(row, why) for row in rows if (why := limits.get(row.name, Limits(row.unit)).refuses(row))]
    lower = [row.name for row in rows if row.name in limits and limits[row.name].may_sink(row)]
    bars = [row.value <= limits[row.name].bar for row in rows if row.name in limits and limits[row.name].bar is not None]
    print(f"{sum(bars)} of {len(bars)} bars kept")
    if lower:
        print(f"better than their budgets by over {100 * SLACK:.0f} %: {', '.join(lower)}\n"
              "lower them: tests/bench/report --update")
    for row, why in refused:
        print(f"report: {row.name}: {show(row.value)} {row.unit}: {why}", file=sys.stderr)
    return len(refused)
