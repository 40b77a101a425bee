"""
gltf_box.py - one box, 2 x 3 x 4, closed, wound outwards, in the many ways of glTF 2.0.

Everything is written by hand here: JSON, buffers and binary containers. The box has 12 triangles; fitted to a
radius of 1 its area is 52 / 7.25 and its volume 24 / 7.25^1.5.
"""
import base64
import copy
import json
import struct

BYTE, UBYTE, SHORT, USHORT, UINT, FLOAT = 5120, 5121, 5122, 5123, 5125, 5126
FORM = {BYTE: "b", UBYTE: "B", SHORT: "h", USHORT: "H", UINT: "I", FLOAT: "f"}
MOST = {BYTE: 127, UBYTE: 255, SHORT: 32767, USHORT: 65535}
PARTS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
HALF = (1, 1.5, 2)


def sides():
    """Of each of the six sides its four corners, counter-clockwise from outside, as -1 or 1 an axis; its normal."""
    for axis in range(3):
        for sign in (-1, 1):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            corners = []
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))[::sign]:
                corner = [0, 0, 0]
                corner[axis], corner[u], corner[v] = sign, a, b
                corners.append(corner)
            yield corners, [sign if k == axis else 0 for k in range(3)]


CORNERS = [corner for corners, _ in sides() for corner in corners]
NORMALS = [normal for _, normal in sides() for _ in range(4)]
POINTS = [[c * h for c, h in zip(corner, HALF)] for corner in CORNERS]
INDICES = [4 * side + i for side in range(6) for i in (0, 1, 2, 0, 2, 3)]


def pack(rows, component, stride=0):
    """Rows of numbers as bytes; 0xee between them where they are apart."""
    out = b""
    for row in rows:
        one = struct.pack("<%d%s" % (len(row), FORM[component]), *row)
        out += one + b"\xee" * (stride - len(one) if stride else 0)
    return out


def scalars(values):
    return [[v] for v in values]


def whole(rows, most):
    return [[round(x * most) for x in row] for row in rows]


class Gltf:
    """A document in the making. Buffer 0 grows with each view; other buffers are given whole."""

    def __init__(self):
        self.json = {"asset": {"version": "2.0"}, "accessors": [], "bufferViews": [], "buffers": [{}]}
        self.bytes = b""

    def view(self, data, **more):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data), **more})
        self.bytes += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, rows, component=FLOAT, stride=0, **more):
        view = self.view(pack(rows, component, stride), **({"byteStride": stride} if stride else {}))
        return self.empty(len(rows), len(rows[0]), component, bufferView=view, **more)

    def empty(self, count, parts, component=FLOAT, **more):
        self.json["accessors"].append({"componentType": component, "count": count, "type": PARTS[parts], **more})
        return len(self.json["accessors"]) - 1

    def sparse(self, numbers, rows, component=FLOAT, number_component=USHORT):
        return {"count": len(rows),
                "indices": {"bufferView": self.view(pack(scalars(numbers), number_component)),
                            "componentType": number_component},
                "values": {"bufferView": self.view(pack(rows, component))}}

    def needs(self, *names):
        self.json["extensionsUsed"] = self.json["extensionsRequired"] = list(names)

    def show(self, primitives, mesh=None, nodes=None, scene=True, **more):
        """The scene: primitives as one mesh, at node 0 unless nodes are given."""
        self.json["meshes"] = [{"primitives": primitives, **(mesh or {})}]
        self.json["nodes"] = nodes or [{"mesh": 0}]
        if scene:
            self.json.update(scene=0, scenes=[{"nodes": [0]}])
        self.json.update(more)
        return self

    def attributes(self, points=POINTS, normals=NORMALS):
        return {"POSITION": self.accessor(points), "NORMAL": self.accessor(normals)}

    def box(self, component=USHORT):
        """The plain primitive."""
        return {"attributes": self.attributes(), "indices": self.accessor(scalars(INDICES), component)}

    # ---- the ways to write it down ----

    def text(self, uri=None):
        """A .gltf; without a uri the bytes are in it."""
        out = copy.deepcopy(self.json)
        uri = uri or "data:application/octet-stream;base64," + base64.b64encode(self.bytes).decode()
        out["buffers"][0] = {"byteLength": len(self.bytes), "uri": uri}
        return json.dumps(out).encode()

    def binary(self, more=b""):
        """A .glb."""
        out = copy.deepcopy(self.json)
        out["buffers"][0] = {"byteLength": len(self.bytes)}
        head = json.dumps(out).encode()
        head += b" " * (-len(head) % 4)
        body = self.bytes + b"\0" * (-len(self.bytes) % 4)
        chunks = struct.pack("<II", len(head), 0x4E4F534A) + head + struct.pack("<II", len(body), 0x004E4942) + body + more
        return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


def plain():
    box = Gltf()
    return box.show([box.box()])
