"""
gltf_good.py - glTF files that must be read, each the box of gltf_box.py in another way.

good(packer) yields name, {file: bytes} of which the first is the mesh, and how many boxes it is (1 unless said).
"""
import json
import math
import struct

from gltf_box import (BYTE, CORNERS, FLOAT, HALF, INDICES, MOST, NORMALS, POINTS, SHORT, UBYTE, UINT, USHORT, Gltf,
                      pack, plain, scalars, whole)


def containers():
    box = plain()
    yield "data", {"a.gltf": box.text()}
    yield "binary", {"a.glb": box.binary()}
    yield "binary-more-chunks", {"a.glb": box.binary(struct.pack("<II", 4, 0x20202020) + b"more")}
    yield "binary-behind-the-end", {"a.glb": box.binary() + b"more"}
    yield "binary-by-content", {"no-ending": box.binary()}
    yield "file", {"a.gltf": box.text("a.bin"), "a.bin": box.bytes + b"more"}
    yield "percent", {"a.gltf": box.text("my%20b%C3%B6x%2F%25.bin"), "my böx/%.bin": box.bytes}
    yield "percent-that-is-none", {"a.gltf": box.text("50%.bin"), "50%.bin": box.bytes}
    yield "data-in-percent", {"a.gltf": box.text("data:," + "".join("%%%02x" % b for b in box.bytes))}
    yield "byte-order-mark", {"a.gltf": b"\xef\xbb\xbf" + box.text()}
    yield "blanks", {"a.gltf": b"\n\t " + box.text() + b" \r\n"}
    box.json["images"] = [{"uri": "none.png"}, {"bufferView": 77, "mimeType": "image/png"}]
    box.json["textures"] = [{"source": 0}, {"source": 1}]
    yield "images-not-there", {"a.glb": box.binary()}
    yield "whole-numbers-as-reals", {"a.gltf": box.text().replace(b'"count": 24', b'"count": 24.0')}


def scenes():
    box = Gltf()
    yield "no-scenes", {"a.gltf": box.show([box.box()], scene=False).text()}
    yield "no-scene-chosen", {"a.gltf": plain().text().replace(b'"scene": 0, ', b"")}
    box = plain()
    box.json.update(scene=1, scenes=[{"nodes": []}, {"name": "the one", "nodes": [0]}])
    yield "second-scene", {"a.gltf": box.text()}
    box.json.update(scene=1, nodes=[{"mesh": 0}, {"mesh": 0, "scale": [9, 9, 9]}])
    yield "a-node-outside", {"a.gltf": box.text()}
    box.json["extensionsRequired"] = ["KHR_materials_unlit", "KHR_texture_transform", "EXT_texture_webp"]
    yield "extensions-of-materials", {"a.gltf": box.text()}
    box.json.update(extensionsRequired=[], extensionsUsed=["EXAMPLE_a"], extensions={"EXAMPLE_a": {"a": [1]}})
    yield "extensions-that-are-optional", {"a.gltf": box.text()}
    box = plain()
    box.json["nodes"] = [{"children": [1, 2]}, {"mesh": 0},
                         {"mesh": 0, "scale": [7, 7, 7], "extensions": {"KHR_node_visibility": {"visible": False}}}]
    yield "invisible-node", {"a.gltf": box.text()}
    box = plain()
    box.json["nodes"] = [{"children": [i + 1]} for i in range(20000)] + [{"mesh": 0}]
    yield "20000-nodes-deep", {"a.gltf": box.text()}


def transforms():
    turn = [math.sin(0.4) * x for x in (2 / 3, -1 / 3, 2 / 3)] + [math.cos(0.4)]
    mirror = [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]
    shear = [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    back = [1, 0, 0, 0, -0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    for name, nodes in (("mirrored", [{"mesh": 0, "scale": [-1, 1, 1]}]),
                        ("mirrored-thrice", [{"mesh": 0, "scale": [-2, -2, -2]}]),
                        ("matrix", [{"mesh": 0, "matrix": mirror}]),
                        ("turned", [{"mesh": 0, "translation": [9, 9, 9], "rotation": turn, "scale": [3, 3, 3]}]),
                        ("chain", [{"children": [1], "matrix": shear}, {"children": [2], "matrix": back},
                                   {"mesh": 0, "rotation": turn}]),
                        ("far-away", [{"mesh": 0, "translation": [5e5, 4649776, 300], "scale": [0.2, 0.2, 0.2]}])):
        box = plain()
        box.json["nodes"] = nodes
        yield name, {"a.gltf": box.text()}
    box = Gltf()  # the cube, stretched by a parent: normals go by the inverse
    primitive = {"attributes": box.attributes(CORNERS), "indices": box.accessor(scalars(INDICES), UBYTE)}
    yield "stretched", {"a.gltf": box.show([primitive], nodes=[{"children": [1], "scale": HALF}, {"mesh": 0}]).text()}
    box = plain()
    box.json["nodes"] = [{"children": [1, 2, 3]}] + [{"mesh": 0}] * 3
    yield "one-mesh-thrice", {"a.gltf": box.text()}, 3


def components():
    for component in (UBYTE, USHORT, UINT):
        box = Gltf()
        yield f"indices-{component}", {"a.gltf": box.show([box.box(component)]).text()}
    box = Gltf()
    yield "no-indices", {"a.gltf": box.show([{"attributes": box.attributes(
        [POINTS[i] for i in INDICES], [NORMALS[i] for i in INDICES])}]).text()}
    for component, most in MOST.items():
        signed = component in (BYTE, SHORT)
        rows = CORNERS if signed else [[(x + 1) / 2 for x in corner] for corner in CORNERS]
        span = 1 if signed else 2
        for normalize in (True, False):
            box = Gltf()
            box.needs("KHR_mesh_quantization")
            normal = BYTE if component in (BYTE, UBYTE) else SHORT
            attributes = {
                "POSITION": box.accessor(whole(rows, most), component, 4 if most < 256 else 8, normalized=normalize),
                "NORMAL": box.accessor(whole(NORMALS, MOST[normal]), normal, 4 if normal == BYTE else 8, normalized=True)}
            scale = [span * h / (1 if normalize else most) for h in HALF]
            box.show([{"attributes": attributes, "indices": box.accessor(scalars(INDICES), UBYTE)}],
                     nodes=[{"mesh": 0, "scale": scale}])
            yield f"positions-{component}-{'normalized' if normalize else 'whole'}", {"a.glb": box.binary()}
    box = Gltf()
    rows = [p + n for p, n in zip(POINTS, NORMALS)]
    view = box.view(b"\xff" * 8 + pack(rows, FLOAT, 32), byteStride=32)
    attributes = {"POSITION": box.empty(24, 3, bufferView=view, byteOffset=8),
                  "NORMAL": box.empty(24, 3, bufferView=view, byteOffset=20)}
    yield "interleaved", {"a.gltf": box.show([{"attributes": attributes,
                                               "indices": box.accessor(scalars(INDICES), USHORT)}]).text()}
    box = plain()
    box.json["accessors"][1]["count"] = 20
    yield "too-few-normals", {"a.gltf": box.text()}
    box = Gltf()
    attributes = box.attributes(normals=[[math.nan, math.inf, 0]] * 24)
    yield "normals-not-a-number", {"a.gltf": box.show([{"attributes": attributes,
                                                        "indices": box.accessor(scalars(INDICES), USHORT)}]).text()}


def sparse():
    for component in (UBYTE, USHORT, UINT):
        box = Gltf()
        broken = [[9, 9, 9] if i % 5 == 0 else p for i, p in enumerate(POINTS)]
        attributes = box.attributes(broken)
        box.json["accessors"][0]["sparse"] = box.sparse(range(0, 24, 5), POINTS[::5], FLOAT, component)
        box.show([{"attributes": attributes, "indices": box.accessor(scalars(INDICES), UBYTE)}])
        yield f"sparse-{component}", {"a.gltf": box.text()}
    box = Gltf()
    attributes = {"POSITION": box.empty(24, 3, sparse=box.sparse(range(24), POINTS)),
                  "NORMAL": box.empty(24, 3, BYTE, normalized=True,
                                      sparse=box.sparse(range(24), whole(NORMALS, 127), BYTE))}
    indices = box.empty(36, 1, USHORT, sparse=box.sparse(range(36), scalars(INDICES), USHORT))
    yield "sparse-alone", {"a.glb": box.show([{"attributes": attributes, "indices": indices}]).binary()}


def modes():
    strip, fan = [0, 1, 3, 2], [0, 1, 2, 3]
    for name, mode, order in (("strips", 5, strip), ("fans", 6, fan)):
        box = Gltf()
        attributes = box.attributes()
        primitives = [{"attributes": attributes, "mode": mode,
                       "indices": box.accessor(scalars([4 * side + i for i in order]), UBYTE)} for side in range(6)]
        yield name, {"a.gltf": box.show(primitives).text()}
        box = Gltf()
        primitives = [{"attributes": box.attributes([POINTS[4 * side + i] for i in order],
                                                    [NORMALS[4 * side + i] for i in order]), "mode": mode}
                      for side in range(6)]
        yield name + "-without-indices", {"a.gltf": box.show(primitives).text()}
    box = Gltf()  # one strip: triangles without area lead from side to side, an even number of them
    order = [4 * side + i for side in range(6) for i in strip + [strip[3], 4 + strip[0]]][:-2]
    yield "one-strip", {"a.gltf": box.show([{"attributes": box.attributes(), "mode": 5,
                                             "indices": box.accessor(scalars(order), USHORT)}]).text()}
    box = Gltf()
    primitive = box.box()
    more = [{"attributes": primitive["attributes"], "mode": mode} for mode in range(4)]
    yield "points-and-lines-too", {"a.gltf": box.show(more + [primitive]).text()}
    box = Gltf()
    primitive = box.box()
    primitive["indices"] = box.accessor(scalars(INDICES + [0, 1]), USHORT)
    yield "a-triangle-that-lacks-a-corner", {"a.gltf": box.show([primitive]).text()}


def instances():
    rows = {"TRANSLATION": [[0, 0, 0], [0, 0, 0]],
            "ROTATION": [[0, 0, 0, 1], [0, 1, 0, 0]],
            "SCALE": [[1, 1, 1], [-1, 1, 1]]}
    for names in (("TRANSLATION",), ("ROTATION",), ("SCALE",), tuple(rows)):
        box = Gltf()
        box.needs("EXT_mesh_gpu_instancing")
        primitive = box.box()
        attributes = {name: box.accessor(rows[name]) for name in names}
        box.show([primitive], nodes=[{"mesh": 0, "scale": [2, 2, 2],
                                      "extensions": {"EXT_mesh_gpu_instancing": {"attributes": attributes}}}])
        yield "instances-" + "-".join(names), {"a.gltf": box.text()}, 2
    box = Gltf()
    primitive = box.box()
    attributes = {"ROTATION": box.accessor(whole([[0, 0, 0, 1], [0, 0, 1, 0]], 32767), SHORT, normalized=True)}
    box.show([primitive], nodes=[{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": attributes}}}])
    yield "instances-in-shorts", {"a.glb": box.binary()}, 2


def morphs():
    flat = [[x, y, z / 10] for x, y, z in POINTS]
    rise = [[0, 0, z * 0.9] for _, _, z in POINTS]

    def box_of(targets, weights, where):
        box = Gltf()
        primitive = box.box()
        primitive["attributes"]["POSITION"] = box.accessor(flat)
        primitive["targets"] = [{"POSITION": box.accessor(rows)} for rows in targets]
        mesh = {"weights": weights} if where == "mesh" else {"weights": [0.25] * len(weights)}
        return box.show([primitive], mesh, [{"mesh": 0, **({"weights": weights} if where == "node" else {})}])

    half = [[x / 2 for x in row] for row in rise]
    yield "morph-mesh", {"a.gltf": box_of([rise], [1], "mesh").text()}
    yield "morph-node", {"a.gltf": box_of([rise], [1], "node").text()}
    yield "morph-half", {"a.gltf": box_of([[[2 * x for x in row] for row in rise]], [0.5], "mesh").text()}
    yield "morph-two", {"a.gltf": box_of([half, half], [1, 1], "mesh").text()}
    yield "morph-unused", {"a.gltf": box_of([rise, half], [1, 0], "node").text()}
    box = Gltf()  # in bytes, sparse: the upper corners come up by 1 of a box that lacks that; normals too
    low = [[x, y, min(z, 1)] for x, y, z in POINTS]
    upper = [i for i, p in enumerate(POINTS) if p[2] > 1]
    primitive = box.box()
    primitive["attributes"] = box.attributes(low, [[0, 0, 0.0]] * 24)
    moved = box.empty(24, 3, BYTE, normalized=True, sparse=box.sparse(upper, [[0, 0, 127]] * len(upper), BYTE))
    primitive["targets"] = [{"POSITION": moved, "NORMAL": box.accessor(whole(NORMALS, 127), BYTE, 4, normalized=True)}]
    box.needs("KHR_mesh_quantization")
    yield "morph-sparse-bytes", {"a.gltf": box.show([primitive], {"weights": [1]}).text()}


def moved(x, y, z):
    return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1]


def skins():
    """A flat box of which the upper half hangs on joint 1, 1.8 higher, the lower half on joint 0, 1.8 lower."""
    flat = [[x, y, z / 10] for x, y, z in POINTS]
    joints = [[1 if p[2] > 0 else 0, 0, 0, 0] for p in POINTS]
    skinned = {"mesh": 0, "skin": 0, "translation": [3, 3, 3], "scale": [1, 5, -1]}
    nodes = [{"children": [1, 2]}, skinned, {"translation": [0, 0, -1.8], "children": [3]},
             {"translation": [0, 0, 3.6]}]

    def box_of(joint_rows, joint_component, weight_rows, weight_component, more=(), **skin):
        box = Gltf()
        primitive = box.box()
        primitive["attributes"] = box.attributes(flat)
        for number, (j, w) in enumerate([(joint_rows, weight_rows), *more]):
            primitive["attributes"][f"JOINTS_{number}"] = box.accessor(j, joint_component)
            primitive["attributes"][f"WEIGHTS_{number}"] = box.accessor(w, weight_component,
                                                                        normalized=weight_component != FLOAT)
        return box.show([primitive], nodes=nodes, skins=[{"joints": [2, 3], **skin}])

    one = [[1, 0, 0, 0]] * 24
    yield "skin", {"a.gltf": box_of(joints, UBYTE, one, FLOAT).text()}
    yield "skin-shorts", {"a.gltf": box_of(joints, USHORT, whole(one, 65535), USHORT).text()}
    yield "skin-bytes", {"a.glb": box_of(joints, UBYTE, whole(one, 255), UBYTE).binary()}
    yield "skin-skeleton", {"a.gltf": box_of(joints, UBYTE, one, FLOAT, skeleton=0).text()}
    yield "skin-weights-not-1", {"a.gltf": box_of([[j[0], j[0], 0, 0] for j in joints], UBYTE,
                                                  [[0.3, 0.1, 0, 0]] * 24, FLOAT).text()}
    yield "skin-no-weights", {"a.gltf": box_of(joints, UBYTE, [[0, 0, 0, 0]] * 24, FLOAT).text()}
    yield "skin-two-sets", {"a.gltf": box_of(joints, UBYTE, [[0.5, 0, 0, 0]] * 24, FLOAT,
                                             [([[0, 0, 0, j[0]] for j in joints], [[0, 0, 0, 0.5]] * 24)]).text()}
    twice = [[4, 5, 6, 7]] * 24
    yield "skin-joints-without-weight", {"a.gltf": box_of([j[:1] + t[1:] for j, t in zip(joints, twice)], UBYTE, one,
                                                          FLOAT).text()}
    # The mesh modelled where its joints were at 5 and at 7 along x: the inverse of that comes first.
    away = [[x + (7 if j[0] else 5), y, z] for (x, y, z), j in zip(flat, joints)]
    box = Gltf()
    primitive = box.box()
    primitive["attributes"] = box.attributes(away) | {"JOINTS_0": box.accessor(joints, UBYTE),
                                                      "WEIGHTS_0": box.accessor(one)}
    binds = box.accessor([moved(-5, 0, 0), moved(-7, 0, 0)])
    yield "skin-binds", {"a.gltf": box.show([primitive], nodes=nodes,
                                            skins=[{"joints": [2, 3], "inverseBindMatrices": binds}]).text()}
    box = plain()
    box.json.update(nodes=[{"children": [1, 2]}, {"mesh": 0, "skin": 0}, {}], skins=[{"joints": [2]}])
    yield "skin-of-a-mesh-without", {"a.gltf": box.text()}
    box = Gltf()  # joints that mirror
    primitive = box.box()
    primitive["attributes"] |= {"JOINTS_0": box.accessor([[0, 0, 0, 0]] * 24, UBYTE), "WEIGHTS_0": box.accessor(one)}
    yield "skin-mirrored", {"a.gltf": box.show([primitive], nodes=[{"mesh": 0, "skin": 0}, {"scale": [1, -1, 1]}],
                                               skins=[{"joints": [1]}]).text()}


def dracos(packer):
    raw = pack(POINTS + NORMALS, FLOAT) + pack(scalars(INDICES), UINT)
    for method in (0, 1):
        for bits in (0, 14):
            for component in (UBYTE, USHORT, UINT):
                box = Gltf()
                box.needs("KHR_draco_mesh_compression")
                data = packer(raw, "draco", 24, 12, method, bits)
                primitive = {"attributes": {"POSITION": box.empty(24, 3), "NORMAL": box.empty(24, 3)},
                             "indices": box.empty(36, 1, component),
                             "extensions": {"KHR_draco_mesh_compression": {
                                 "bufferView": box.view(data), "attributes": {"POSITION": 0, "NORMAL": 1}}}}
                name = f"draco-{'sequential' if method == 0 else 'edgebreaker'}-{bits}-{component}"
                yield name, {"a.glb": box.show([primitive]).binary()}
    box = plain()  # beside what is not packed
    primitive = box.json["meshes"][0]["primitives"][0]
    primitive["extensions"] = {"KHR_draco_mesh_compression": {"bufferView": box.view(data),
                                                              "attributes": {"POSITION": 0, "NORMAL": 1}}}
    primitive["mode"] = 4
    yield "draco-optional", {"a.gltf": box.text()}


def meshopts(packer):
    """Every attribute and the indices packed; the views' own buffer is a fallback that is not there."""
    def packed(box, data, mode, count, stride, filtered=None):
        view = box.view(data)
        packed_view = box.json["bufferViews"][view]
        more = {"buffer": 0, "byteOffset": packed_view["byteOffset"], "byteLength": len(data), "mode": mode,
                "count": count, "byteStride": stride, **({"filter": filtered} if filtered else {})}
        box.json["bufferViews"][view] = {"buffer": 1, "byteLength": count * stride,
                                         **({"byteStride": stride} if mode == "ATTRIBUTES" else {}),
                                         "extensions": {"EXT_meshopt_compression": more}}
        return view

    normals = [n + [0] for n in NORMALS]
    for name, index_size, mode in (("", 2, "TRIANGLES"), ("-32", 4, "TRIANGLES"), ("-sequence", 2, "INDICES")):
        for filtered in ("", "-filters", "-octahedral-8"):
            box = Gltf()
            box.json["buffers"].append({"byteLength": 4096, "extensions": {"EXT_meshopt_compression": {"fallback": True}}})
            box.needs("EXT_meshopt_compression", "KHR_mesh_quantization")
            points = packer(pack(POINTS, FLOAT), "exponential", 24, 12) if filtered else pack(POINTS, FLOAT)
            wide = filtered == "-octahedral-8"
            stride, form = (8, SHORT) if wide else (4, BYTE)
            bent = packer(pack(normals, FLOAT), "octahedral", 24, stride) if filtered else \
                pack(whole(normals, 127), BYTE)
            stride = stride if filtered else 4
            form = form if filtered else BYTE
            attributes = {
                "POSITION": box.empty(24, 3, bufferView=packed(box, packer(points, "vertices", 24, 12), "ATTRIBUTES", 24,
                                                               12, "EXPONENTIAL" if filtered else None)),
                "NORMAL": box.empty(24, 3, form, normalized=True,
                                    bufferView=packed(box, packer(bent, "vertices", 24, stride), "ATTRIBUTES", 24,
                                                      stride, "OCTAHEDRAL" if filtered else "NONE"))}
            how = "triangles" if mode == "TRIANGLES" else "indices"
            corners = packer(pack(scalars(INDICES), UINT), how, 36)
            indices = box.empty(36, 1, USHORT if index_size == 2 else UINT,
                                bufferView=packed(box, corners, mode, 36, index_size))
            yield f"meshopt{name}{filtered}", {"a.glb": box.show([{"attributes": attributes,
                                                                   "indices": indices}]).binary()}


def good(packer):
    for part in (containers(), scenes(), transforms(), components(), sparse(), modes(), instances(), morphs(), skins(),
                 dracos(packer), meshopts(packer)):
        yield from part


def curve(linear):
    """sRGB, 0..255."""
    return 255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055)


def colored():
    """name, bytes, the linear colour that `--color file` must show."""
    def with_material(material, colors=None, component=FLOAT):
        box = Gltf()
        primitive = box.box() | ({"material": 0} if material is not None else {})
        if colors:
            most = MOST.get(component, 1)
            rows = whole([colors] * 24, most) if component in MOST else [colors] * 24
            size = len(colors) * {UBYTE: 1, USHORT: 2, FLOAT: 4}[component]
            primitive["attributes"]["COLOR_0"] = box.accessor(rows, component, size + -size % 4,
                                                              normalized=component in MOST)
        return json.loads(box.show([primitive], materials=[material or {}]).text()), box

    grey = {"pbrMetallicRoughness": {"baseColorFactor": [0.2158605, 0.05, 0.8, 1]}}
    shine = {"extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.5, 0.1, 0, 1]}}}
    yield "factor", with_material(grey)[1], (0.2158605, 0.05, 0.8)
    yield "default", with_material({"name": "plain"})[1], (1, 1, 1)
    yield "specular-glossiness", with_material(shine)[1], (0.5, 0.1, 0)
    yield "specular-glossiness-beside", with_material(grey | shine)[1], (0.5, 0.1, 0)
    yield "too-bright", with_material({"pbrMetallicRoughness": {"baseColorFactor": [7, 0.5, 0, 1]}})[1], (1, 0.5, 0)
    for component in (FLOAT, UBYTE, USHORT):
        for color in ((1, 0.4, 0), (1, 0.4, 0, 0.5)):
            yield f"vertices-{component}-{len(color)}", with_material({}, list(color), component)[1], color[:3]
    yield "vertices-no-material", with_material(None, [0.2, 0.6, 1])[1], (0.2, 0.6, 1)
    yield "vertices-times-factor", with_material(grey, [0.5, 1, 0.25])[1], (0.10793, 0.05, 0.2)
