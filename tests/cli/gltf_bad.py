"""
gltf_bad.py - glTF files that must be refused: yields name, bytes of the file, and what the line must say.
"""
import copy
import json
import math
import struct

from gltf_box import FLOAT, INDICES, NORMALS, POINTS, UBYTE, UINT, USHORT, Gltf, pack, plain, scalars

REMOVED = object()


def changed(*changes, box=None):
    """The plain box with values put elsewhere: ("accessors.0.count", 7)."""
    box = box or plain()
    out = copy.copy(box)
    out.json = copy.deepcopy(box.json)
    for path, value in changes:
        *way, last = [int(p) if p.isdigit() else p for p in path.split(".")]
        at = out.json
        for step in way:
            at = at[step]
        if value is REMOVED:
            del at[last]
        else:
            at[last] = value
    return out.text()


def structure():
    yield "empty-object", b"{}", "asset.version is missing"
    yield "an-array", b"[]", "no object"
    yield "not-json", b"{'asset': 1}", "line 1, column 2: not JSON"
    yield "cut", plain().text()[:-1], "not JSON, or not all of it"
    yield "deep-json", b"[" * 100000, "not JSON"
    yield "number-too-large", plain().text().replace(b'"count": 24', b'"count": 1e999'), "not JSON"
    yield "version-1", changed(("asset.version", "1.0")), "glTF 1.0; only 2.0 can be read"
    yield "version-1-number", changed(("asset.version", 1.1)), "glTF 1.1"
    yield "version-3", changed(("asset.version", "3.0")), "glTF 3.0"
    yield "version-at-least", changed(("asset.minVersion", "2.1")), "glTF 2.1"
    yield "required", changed(("extensionsRequired", ["EXAMPLE_other_geometry"])), "EXAMPLE_other_geometry"
    yield "required-control", changed(("extensionsRequired", ["A\nB\x1b"])), "A?B?"
    yield "required-long", changed(("extensionsRequired", ["A" * 9000])), "requires the extension"
    yield "nodes-object", changed(("nodes", {"a": {}})), "nodes is not an array"
    yield "node-number", changed(("nodes", [7])), "nodes[0] is not an object"
    yield "no-nodes-there", changed(("scenes.0.nodes", [7])), "scenes[0].nodes[0] is 7, there are 1 nodes"
    yield "no-scene-there", changed(("scene", 3)), "scene is 3, there are 1 scenes"
    yield "no-mesh-there", changed(("nodes.0.mesh", 1)), "nodes[0].mesh is 1, there are 1 meshes"
    yield "negative", changed(("nodes.0.mesh", -1)), "nodes[0].mesh is not a whole number"
    yield "a-half", changed(("nodes.0.mesh", 0.5)), "nodes[0].mesh is not a whole number"
    yield "beyond-2^53", changed(("nodes.0.mesh", 2 ** 63)), "nodes[0].mesh is not a whole number"
    yield "matrix-15", changed(("nodes.0.matrix", [0] * 15)), "nodes[0].matrix has 15 numbers, not 16"
    yield "scale-words", changed(("nodes.0.scale", ["1", 1, 1])), "nodes[0].scale[0] is not a number"
    yield "empty-scene", changed(("scenes.0.nodes", [])), "no triangles"
    yield "cycle", changed(("nodes", [{"children": [1]}, {"children": [0], "mesh": 0}])), "is below itself"
    yield "own-child", changed(("nodes", [{"children": [0], "mesh": 0}])), "nodes[0] is below itself"
    yield "two-parents", changed(("nodes", [{"children": [2]}, {"children": [2]}, {"mesh": 0}])), \
        "nodes[1].children[0]: nodes[0] has it too"
    yield "no-positions", changed(("meshes.0.primitives.0.attributes.POSITION", REMOVED)), \
        "meshes[0].primitives[0] has no POSITION"
    yield "mode-7", changed(("meshes.0.primitives.0.mode", 7)), "meshes[0].primitives[0]: mode 7"
    yield "points", changed(("meshes.0.primitives.0.mode", 0)), "points or lines, but no triangles"
    yield "flattened", changed(("nodes.0.scale", [0, 0, 0])), "no extent"
    yield "infinite", changed(("nodes.0.scale", [1e308, 1e308, 1e308])), "meshes[0].primitives[0]: vertex 0"
    yield "no-material-there", changed(("meshes.0.primitives.0.material", 0)), "primitives[0].material is 0, there are 0"


def numbers():
    first, positions = "accessors.0.", "accessors[0]"
    yield "count-2^53", changed((first + "count", 2 ** 53)), positions + ": 9007199254740992 elements reach beyond"
    yield "count-times-stride", changed((first + "count", 2 ** 62 // 12)), positions
    yield "one-too-many", changed((first + "count", 25)), positions + ": 25 elements reach beyond the 288 bytes"
    yield "offset", changed((first + "byteOffset", 4)), positions + ": 24 elements reach beyond"
    yield "offset-2^53", changed((first + "byteOffset", 2 ** 53)), positions
    yield "zeros-without-end", changed((first + "count", 2 ** 40), (first + "bufferView", REMOVED)), "more memory"
    yield "scalars", changed((first + "type", "SCALAR")), positions + ": its type is SCALAR, not VEC3"
    yield "type-missing", changed((first + "type", REMOVED)), positions + ": its type is missing"
    yield "doubles", changed((first + "componentType", 5130)), positions + ": componentType 5130"
    yield "component-missing", changed((first + "componentType", REMOVED)), positions + ".componentType is missing"
    yield "view-not-there", changed((first + "bufferView", 9)), positions + ".bufferView is 9, there are 3 bufferViews"
    yield "stride-8", changed(("bufferViews.0.byteStride", 8)), positions + ": its view's byteStride is 8"
    yield "stride-huge", changed(("bufferViews.0.byteStride", 2 ** 40)), positions + ": its view's byteStride"
    yield "view-beyond", changed(("bufferViews.0.byteLength", 2 ** 52)), "bufferViews[0]: bytes 0 to 4503599627370496"
    yield "view-offset", changed(("bufferViews.0.byteOffset", 2 ** 53)), "bufferViews[0]: bytes 9007199254740992 to"
    yield "no-buffer-there", changed(("bufferViews.0.buffer", 4)), "bufferViews[0].buffer is 4, there are 1 buffers"
    yield "index-24", changed(("accessors.0.count", 23), ("accessors.1.count", 23)), \
        "corner 35 is vertex 23, there are 23"
    yield "index-nan", changed(("accessors.2.componentType", FLOAT), ("accessors.2.count", 18)), "corner"
    for bad in (math.nan, math.inf, -math.inf):
        box = Gltf()
        attributes = box.attributes(POINTS[:5] + [[0, bad, 0]] + POINTS[6:])
        box.show([{"attributes": attributes, "indices": box.accessor(scalars(INDICES), USHORT)}])
        yield f"position-{bad}", box.text(), "meshes[0].primitives[0]: vertex 5 is not a finite number"
    box = Gltf()
    attributes = box.attributes()
    box.json["accessors"][0]["sparse"] = box.sparse([0, 24], [[0, 0, 0]] * 2)
    box.show([{"attributes": attributes, "indices": box.accessor(scalars(INDICES), UINT)}])
    yield "sparse-24", box.text(), "accessors[0].sparse.indices: element 24 of 24"
    yield "sparse-huge", changed(("accessors.0.sparse.count", 2 ** 53), box=box), "accessors[0].sparse.indices: "
    yield "sparse-without", changed(("accessors.0.sparse.values", REMOVED), box=box), \
        "accessors[0].sparse.values.bufferView is missing"
    box = Gltf()
    primitive = box.box()
    primitive["targets"] = [{"POSITION": box.accessor(POINTS[:20])}]
    yield "morph-20", box.show([primitive], {"weights": [1]}).text(), "targets[0].POSITION: 20 elements for 24"


def files():
    box = plain()
    yield "no-file", box.text("none.bin"), "buffers[0]: its file none.bin cannot be read"
    yield "a-folder", box.text("."), "buffers[0]: its file . cannot be read"
    yield "web", box.text("https://example.org/a.bin"), "cannot be read"
    yield "base64", box.text("data:;base64,A*AA"), "buffers[0].uri: its data are not base64"
    yield "no-comma", box.text("data:;base64"), "buffers[0].uri: data without a comma"
    yield "short", box.text("data:;base64,AAAA"), "buffers[0] ends after 3 of 648 bytes"
    text = json.loads(box.text())
    del text["buffers"][0]["uri"]
    yield "no-uri", json.dumps(text).encode(), "buffers[0] has no uri"
    text["buffers"][0] = {"uri": "data:,"}
    yield "no-length", json.dumps(text).encode(), "buffers[0].byteLength is missing"
    binary = box.binary()
    yield "glb-1", binary[:4] + b"\1" + binary[5:], "glTF binary version 1"
    yield "glb-cut", binary[:-4], f"it ends after {len(binary) - 4} of {len(binary)} bytes"
    yield "glb-header", binary[:12], "it ends after 12 of"
    yield "glb-chunk", binary[:12] + b"\xff\xff\xff\x7f" + binary[16:], "chunk 0 has"
    yield "glb-no-json", binary[:16] + b"BIN\0" + binary[20:], "chunk 0: not JSON"
    yield "glb-json-twice", struct.pack("<4sII", b"glTF", 2, 36) + struct.pack("<I4s4s", 4, b"JSON", b"{}  ") * 2, \
        "chunk 1: JSON a second time"


def deformed():
    box = Gltf()
    primitive = box.box()
    primitive["attributes"] |= {"JOINTS_0": box.accessor([[2, 0, 0, 0]] * 24, UBYTE),
                                "WEIGHTS_0": box.accessor([[1, 0, 0, 0]] * 24)}
    binds = box.accessor([[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]])
    box.show([primitive], nodes=[{"mesh": 0, "skin": 0}, {}, {}], skins=[{"joints": [1, 2]}])
    yield "joint-2-of-2", box.text(), "vertex 0 uses joint 2, there are 2"
    yield "one-matrix", changed(("skins.0.inverseBindMatrices", binds), box=box), "1 matrices for 2 joints"
    yield "joint-not-there", changed(("skins.0.joints", [1, 9]), box=box), "skins[0].joints[1] is 9, there are 3 nodes"
    yield "skin-not-there", changed(("nodes.0.skin", 1), box=box), "nodes[0].skin is 1, there are 1 skins"
    yield "joints-alone", changed(("meshes.0.primitives.0.attributes.WEIGHTS_0", REMOVED), box=box), \
        "24 joints and 0 weights for 24 vertices"
    yield "joint-below-itself", changed(("nodes.1", {"children": [1]}), box=box), "nodes[1] is below itself"
    box = Gltf()
    primitive = box.box()
    where = {"TRANSLATION": box.accessor([[0, 0, 0]] * 2), "SCALE": box.accessor([[1, 1, 1]] * 3)}
    extension = {"EXT_mesh_gpu_instancing": {"attributes": where}}
    box.show([primitive], nodes=[{"mesh": 0, "extensions": extension}])
    yield "instances-2-and-3", box.text(), "EXT_mesh_gpu_instancing: its attributes have 2 and 3 elements"
    at = "nodes.0.extensions.EXT_mesh_gpu_instancing.attributes"
    yield "instances-of-nothing", changed((at, {}), box=box), "none of the attributes TRANSLATION"
    box.json["accessors"][where["TRANSLATION"]] = {"componentType": FLOAT, "count": 10 ** 8, "type": "VEC3"}
    del where["SCALE"]
    yield "instances-without-end", box.text(), "more memory"
    box.json.update(skins=[{"joints": [0]}])
    yield "instances-of-a-skin", changed(("nodes.0.skin", 0), box=box), "a skin and instances"


def packed(packer):
    raw = pack(POINTS + NORMALS, FLOAT) + pack(scalars(INDICES), UINT)
    data = packer(raw, "draco", 24, 12, 1, 11)
    for size in (0, 3, 11, len(data) // 2, len(data) - 1):
        box = plain()
        box.json["meshes"][0]["primitives"][0]["extensions"] = {"KHR_draco_mesh_compression": {
            "bufferView": box.view(data[:size]), "attributes": {"POSITION": 0, "NORMAL": 1}}}
        yield f"draco-cut-{size}", box.text(), "KHR_draco_mesh_compression: Draco"
    box = plain()
    box.json["meshes"][0]["primitives"][0]["extensions"] = {"KHR_draco_mesh_compression": {
        "bufferView": box.view(data), "attributes": {"POSITION": 0, "NORMAL": 7}}}
    yield "draco-attribute-7", box.text(), "NORMAL: its Draco mesh has no attribute 7"
    box = plain()
    rows = packer(pack(POINTS, FLOAT), "vertices", 24, 12)
    box.json["bufferViews"][0]["extensions"] = {"EXT_meshopt_compression": {
        "buffer": 0, "byteOffset": len(box.bytes), "byteLength": len(rows), "byteStride": 12, "count": 24,
        "mode": "ATTRIBUTES"}}
    box.bytes += rows
    at, name = "bufferViews.0.extensions.EXT_meshopt_compression.", "bufferViews[0].extensions.EXT_meshopt_compression"
    for size in (1, 16, len(rows) - 1):
        yield f"meshopt-cut-{size}", changed((at + "byteLength", size), box=box), name + ": its data are broken"
    yield "meshopt-count", changed((at + "count", 2 ** 50), box=box), name + ": it takes more memory"
    yield "meshopt-mode", changed((at + "mode", "SPLATS"), box=box), name + ": mode SPLATS"
    yield "meshopt-stride", changed((at + "byteStride", 7), box=box), "byteStride 7 and count 24 do not go together"
    yield "meshopt-filter", changed((at + "filter", "OCTAHEDRAL"), box=box), "do not go together"
    yield "meshopt-other", changed((at + "mode", "TRIANGLES"), (at + "byteStride", 2), box=box), name + ": its data are"
    yield "meshopt-triangles", changed((at + "mode", "TRIANGLES"), (at + "byteStride", 2), (at + "count", 25), box=box), \
        "do not go together"


def bad(packer):
    for part in (structure(), numbers(), files(), deformed(), packed(packer)):
        yield from part
