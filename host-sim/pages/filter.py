#!/usr/bin/env python3
"""filter.py HEADER - prints a public header with its comments in doxygen's form; HEADER itself is not changed.

The first comment describes the file. A comment before declarations describes all of them up to the next blank line or
comment. A comment behind a declaration describes every name in it.
"""
import itertools
import re
import sys

BEHIND = re.compile(r"^(\s*)(.*?[;,}]|#define \S+ .*?|\w+(?: = [-\w]+)?)\s*/\* (.*)$")
SEVERAL = re.compile(r"^(\s*)((?:extern |const |struct |enum |unsigned )*\w+) (\*?\w+(?:\[\w+\])?(?:, \*?\w+(?:\[\w+\])?)+);$")


def split(line):
    """Splits `int a, b;` into one declaration per name."""
    found = SEVERAL.match(line)
    if not found:
        return [line]
    indent, kind, names = found.groups()
    return [f"{indent}{kind} {name};" for name in names.split(", ")]


def main(path):
    with open(path, encoding="utf-8") as f:
        lines = f.read().split("\n")
    out, at, group = [], 0, False

    def close():
        nonlocal group
        if group:
            out.append("/**@}*/")
        group = False

    while at < len(lines):
        line = lines[at]
        if re.match(r"^/\* -+ .* -+ \*/$", line):
            close()
        elif line.lstrip().startswith("/*"):
            close()
            end = at
            while "*/" not in lines[end]:
                end += 1
            text = "\n".join(lines[at:end + 1])
            while end + 1 < len(lines) and re.match(r"^\s*/\*[^*].*\*/$", lines[end + 1]): # the comment's second line
                end += 1
                text = text[:text.rindex("*/")] + lines[end].strip()[2:]
            text = text.replace("/*", "/** @file\n" if at == 0 else "/**", 1)
            follows = list(itertools.takewhile(lambda l: l.strip() and "/*" not in l, lines[end + 1:]))
            if at and follows and not any("{" in declared for declared in follows):
                out.append("/**@{*/")
                group = True
            out.append(text.replace("#", "\\#"))
            at = end
        elif (found := BEHIND.match(line)) and not line.lstrip().startswith("*"):
            indent, code, text = found.groups()
            while "*/" not in text:
                at += 1
                text += " " + lines[at].strip()
            out += [f"{part} /**< {text}" for part in split(indent + code)]
        else:
            if not line.strip() or line.startswith("}"):
                close()
            while line.startswith("extern") and not line.endswith(("{", ";")):
                at += 1
                line += " " + lines[at].strip()
            out += split(line)
        at += 1
    close()
    print("\n".join(out))


main(sys.argv[1])
