"""texture_quads.py - one square with a texture, the picture upright on it, in every format; what `bake` made of it."""
import base64
import os
import re
import struct

from gltf_box import FLOAT, UBYTE, USHORT, Gltf

POINTS = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
UP = [(0, 0), (1, 0), (1, 1), (0, 1)]  # as OBJ and PLY count
DOWN = [(u, 1 - v) for u, v in UP]  # as glTF does


def write(name, content):
    os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
    with open(name, "wb") as file:
        file.write(content.encode() if isinstance(content, str) else content)


def mtl(line, more=""):
    return f"newmtl m\n{line}\n{more}"


def obj(uvs=UP, face="f 1/1 2/2 3/3 4/4\n", more="", library="q.mtl"):
    return (f"mtllib {library}\n" + "".join("v %g %g %g\n" % p for p in POINTS) +
            "".join("vt " + " ".join(str(x) for x in uv) + "\n" for uv in uvs) + "usemtl m\n" + face + more)


def ply(names=("s", "t"), form="ascii", kind="float", picture="t.png"):
    code = {"ascii": None, "binary_little_endian": "<", "binary_big_endian": ">"}[form]
    head = (f"ply\nformat {form} 1.0\n" + (f"comment TextureFile {picture}\n" if picture else "") +
            "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n" +
            "".join(f"property {kind} {name}\n" for name in names) +
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n").encode()
    rows = [(*p, *uv) for p, uv in zip(POINTS, UP)]
    if code is None:
        return head + "".join(" ".join("%g" % x for x in row) + "\n" for row in rows).encode() + b"4 0 1 2 3\n"
    return head + b"".join(struct.pack(code + "3f2" + kind[0], *row) for row in rows) + struct.pack(code + "B4i", 4, 0, 1, 2, 3)


def gltf(image, texture=None, material=None, sampler=None, uvs=None, component=FLOAT, glossy=False, color=None):
    """image: the JSON of it, or bytes to be put into a view. uvs: of TEXCOORD_0, _1 ..."""
    box = Gltf()
    primitive = {"attributes": {"POSITION": box.accessor(POINTS)}, "indices": box.accessor([[i] for i in (0, 1, 2, 0, 2, 3)],
                                                                                          USHORT), "material": 0}
    most = {FLOAT: 1, UBYTE: 255, USHORT: 65535}[component]
    for i, set_ in enumerate(uvs or [DOWN]):
        rows = set_ if component == FLOAT else [[round(x * most) for x in uv] for uv in set_]
        primitive["attributes"][f"TEXCOORD_{i}"] = box.accessor(rows, component, 4 if component == UBYTE else 0,
                                                                normalized=component != FLOAT)
    if color:
        primitive["attributes"]["COLOR_0"] = box.accessor([color] * 4)
    if isinstance(image, bytes):
        image = {"bufferView": box.view(image), "mimeType": "image/png"}
    used = {"index": 0, **(texture or {})}
    pbr = {"extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseTexture": used}}} if glossy else \
        {"pbrMetallicRoughness": {"baseColorTexture": used}}
    box.show([primitive], materials=[{**pbr, **(material or {})}],
             textures=[{"source": 0, **({"sampler": 0} if sampler else {})}], images=[image])
    if sampler:
        box.json["samplers"] = [sampler]
    return box


def data_uri(content, kind="image/png"):
    return {"uri": f"data:{kind};base64," + base64.b64encode(content).decode()}


# ---- what was made ----

def array(text, name):
    found = re.search(r"\w_%s\[\d+\] = \{([^}]*)\}" % name, text)
    return [int(x) for x in found[1].split(",") if x.strip()] if found else None


def field(text, name):
    return int(re.search(r"\.%s = (-?\d+)" % name, text)[1])


class Header:
    """A header of one mesh and its texture."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.text = file.read()
        positions, raw = array(self.text, "positions"), array(self.text, "uvs")
        self.points = [tuple(positions[i:i + 3]) for i in range(0, len(positions), 3)]
        self.uvs = None
        if raw is not None:
            offset = [int(x) / 65536 for x in re.search(r"\.uv_offset = \{(-?\d+), (-?\d+)\}", self.text).groups()]
            step = 2.0 ** -field(self.text, "uv_bits")
            self.uvs = [(offset[0] + raw[i] * step, offset[1] + raw[i + 1] * step) for i in range(0, len(raw), 2)]
            self.at = {tuple(round(x / 23170) for x in p): uv for p, uv in zip(self.points, self.uvs)}
        self.indices = array(self.text, "indices")

    def field(self, name):
        return field(self.text, name)

    def texels(self):
        """565 values as r, g, b, row by row; None where they are the key."""
        raw, palette, bits = array(self.text, "texels"), array(self.text, "palette"), self.field("bits")
        width = 1 << self.field("width_log2")
        if bits == 4:
            raw = [nibble for byte in raw for nibble in (byte & 15, byte >> 4)]
        raw = raw[:width << self.field("height_log2")]
        values = [palette[i] for i in raw] if palette else raw
        key = self.field("key") if self.field("keyed") else None
        return [[None if v == key else (v >> 11, v >> 5 & 63, v & 31) for v in values[i:i + width]]
                for i in range(0, len(values), width)]
