"""measure.py - what `sheen bake` made of a mesh, in numbers that a test can hold it to."""
import math
import re


def numbers(text, name):
    found = re.search(r"_%s\[\d+\] = \{([^}]*)\}" % name, text)
    values = [int(x) for x in found[1].split(",") if x.strip()]
    return [tuple(values[i:i + 3]) for i in range(0, len(values), 3)]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def measure(path):
    """Triangles, area, volume (of a closed mesh), the share of corners whose normal looks inwards."""
    text = open(path).read()
    points = [tuple(x / 32767 for x in p) for p in numbers(text, "positions")]
    normals = numbers(text, "normals")
    triangles = numbers(text, "indices")
    area = volume = inwards = 0
    for corners in triangles:
        a, b, c = (points[i] for i in corners)
        n = cross([y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)])
        area += math.sqrt(dot(n, n)) / 2
        volume += dot(a, n) / 6
        inwards += sum(dot(normals[i], n) <= 0 for i in corners)
    return len(triangles), area, volume, inwards / (3 * len(triangles))
