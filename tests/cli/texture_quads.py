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


def wedges(form="ascii", first=False, vertices=None, number=None, uvs=UP):
    """A PLY whose face has its own uv, as MeshLab writes them: before its corners or behind them."""
    code = {"ascii": None, "binary_little_endian": "<", "binary_big_endian": ">"}[form]
    lists = ["property list uchar int vertex_indices\n", "property list uchar float texcoord\n"][::-1 if first else 1]
    head = (f"ply\nformat {form} 1.0\ncomment TextureFile t.png\nelement vertex 4\n" +
            "".join(f"property float {name}\n" for name in ("x", "y", "z", *(("s", "t") if vertices else ()))) +
            "element face 1\n" + "".join(lists) + ("property int texnumber\n" if number is not None else "") +
            "end_header\n").encode()
    rows = [(*p, *(vertices or ())) for p in POINTS]
    flat = [x for uv in uvs for x in uv]
    if code is None:
        parts = [" 4 0 1 2 3", f" {len(flat)} " + " ".join("%g" % x for x in flat)][::-1 if first else 1]
        return head + ("".join(" ".join("%g" % x for x in row) + "\n" for row in rows) + "".join(parts) +
                       (f" {number}" if number is not None else "") + "\n").encode()
    parts = [struct.pack(code + "B4i", 4, 0, 1, 2, 3), struct.pack(f"{code}B{len(flat)}f", len(flat), *flat)]
    return (head + b"".join(struct.pack(f"{code}{len(row)}f", *row) for row in rows) + b"".join(parts[::-1 if first else 1]) +
            (struct.pack(code + "i", number) if number is not None else b""))


def off(kind="STOFF", between=""):
    return (f"{kind}\n4 1 0\n" + "".join("%g %g %g " % p + between + "%g %g\n" % uv for p, uv in zip(POINTS, UP)) +
            "4 0 1 2 3\n")


def dae(image=False):
    """COLLADA; image: its material names a picture."""
    def source(name, rows, names):
        return (f'<source id="{name}"><float_array id="{name}a" count="{len(rows) * len(names)}">' +
                " ".join("%g" % x for row in rows for x in row) + f'</float_array><technique_common><accessor source="#{name}a" '
                f'count="{len(rows)}" stride="{len(names)}">' +
                "".join(f'<param name="{n}" type="float"/>' for n in names) + "</accessor></technique_common></source>\n")
    material = ('<library_images><image id="i"><init_from>t.png</init_from></image></library_images><library_materials>'
                '<material id="m"><instance_effect url="#e"/></material></library_materials><library_effects><effect id="e">'
                '<profile_COMMON><newparam sid="s"><surface type="2D"><init_from>i</init_from></surface></newparam><newparam '
                'sid="t"><sampler2D><source>s</source></sampler2D></newparam><technique sid="c"><lambert><diffuse><texture '
                'texture="t" texcoord="u"/></diffuse></lambert></technique></profile_COMMON></effect></library_effects>')
    bind = ('<bind_material><technique_common><instance_material symbol="m" target="#m"/></technique_common></bind_material>')
    return ('<?xml version="1.0"?>\n<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>'
            '<up_axis>Y_UP</up_axis></asset>' + material * image + '<library_geometries><geometry id="g"><mesh>\n' +
            source("p", POINTS, "XYZ") + source("t", UP, "ST") + '<vertices id="v"><input semantic="POSITION" source="#p"/>'
            '</vertices><polylist count="1"' + ' material="m"' * image + '><input semantic="VERTEX" source="#v" offset="0"/>'
            '<input semantic="TEXCOORD" source="#t" offset="1" set="0"/><vcount>4</vcount><p>0 0 1 1 2 2 3 3</p></polylist>'
            '</mesh></geometry></library_geometries>\n<library_visual_scenes><visual_scene id="s"><node>'
            '<instance_geometry url="#g">' + bind * image + '</instance_geometry></node></visual_scene></library_visual_scenes>'
            '<scene><instance_visual_scene url="#s"/></scene></COLLADA>\n')


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
