/*
 * gltf_shape.cpp - the primitives of a glTF mesh as triangles, with morph targets applied, before skinning.
 */
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "gltf.h"

namespace gltf
{

namespace
{

enum mode {
    TRIANGLES = 4,
    STRIP = 5,
    FAN = 6
};

/* A primitive and the sources of its numbers. */
struct source {
    document &file;
    const item primitive;
    const std::vector<double> &weights;
    std::optional<draco_mesh> packed;
    item packed_ids; /* ids of the attributes in `packed` */
};

/* The attribute called `name` before any morph target; without rows if there is none. */
table read_base(const source &from, const char *name, const char *types)
{
    const item number = from.primitive.get("attributes").get(name);
    const item id = from.packed_ids.get(name);

    if (!number)
        return {};
    if (from.packed && id)
        return from.packed->attribute(id, from.file.entry("accessors", number), types);
    return read_accessor(from.file, number, types);
}

/* The base plus each morph target times its weight. */
table read_attribute(const source &from, const char *name, const char *types)
{
    const item targets = from.primitive.get("targets");
    table out = read_base(from, name, types);

    for (size_t t = 0; t < targets.size() && t < from.weights.size() && out.count > 0; t++) {
        const item number = targets.at(t).get(name);
        if (!number || from.weights[t] == 0)
            continue;
        const table delta = read_accessor(from.file, number, types);
        if (delta.count != out.count || delta.parts != out.parts)
            refuse("%s: %zu elements for %zu vertices", number.name(), delta.count, out.count);
        for (size_t i = 0; i < out.numbers.size(); i++)
            out.numbers[i] += from.weights[t] * delta.numbers[i];
    }
    return out;
}

/* Like read_attribute, for an optional attribute: it is left out unless it has a row for each vertex. */
table read_optional(const source &from, const char *name, const char *types, size_t vertices)
{
    table out = read_attribute(from, name, types);

    if (out.count == vertices || out.count == 0)
        return out;
    sheen_note(&from.file.notes, SHEEN_NOTE_WARNING, "%s: %s has %zu elements for %zu vertices and is left out",
               from.file.path(), from.primitive.get("attributes").get(name).name(), out.count, vertices);
    return {};
}

/* Normals; none if the requested target moves points without normals, because the base's belong to another shape. */
table read_normals(const source &from, size_t vertices, unsigned whole)
{
    const item targets = from.primitive.get("targets");
    const bool is_moved = whole && targets.size() >= whole && targets.at(whole - 1).get("POSITION");

    if (is_moved && !targets.at(whole - 1).get("NORMAL"))
        return {};
    return read_optional(from, "NORMAL", "VEC3", vertices);
}

/* The attribute with the uv of a material's texture; TEXCOORD_0, the default, without a material. */
std::string texcoord_name(document &file, const item &material)
{
    return "TEXCOORD_" + std::to_string(material ? texcoord_of(file.entry("materials", material)) : 0);
}

/* JOINTS_0 and WEIGHTS_0, _1 ... */
void read_influences(const source &from, shape &to)
{
    for (unsigned set = 0;; set++) {
        const std::string joints = "JOINTS_" + std::to_string(set), weights = "WEIGHTS_" + std::to_string(set);
        table j = read_base(from, joints.c_str(), "VEC4"), w = read_base(from, weights.c_str(), "VEC4");
        if (j.count == 0 && w.count == 0)
            return;
        if (j.count != to.points.count || w.count != to.points.count)
            refuse("%s: %zu joints and %zu weights for %zu vertices", to.name.c_str(), j.count, w.count,
                   to.points.count);
        to.joints.push_back(std::move(j));
        to.weights.push_back(std::move(w));
    }
}

std::vector<uint32_t> read_indices(const source &from, size_t vertices)
{
    const item number = from.primitive.get("indices");
    std::vector<uint32_t> out;

    if (from.packed)
        out = from.packed->triangles();
    else if (number) {
        const table indices = read_accessor(from.file, number, "SCALAR");
        out.reserve(indices.count);
        for (const double index : indices.numbers) { /* an invalid index becomes one that no vertex has */
            const bool is_whole = index >= 0 && index < 4294967295.0 && index == std::floor(index);
            out.push_back(is_whole ? static_cast<uint32_t>(index) : UINT32_MAX);
        }
    } else {
        out.resize(vertices);
        std::iota(out.begin(), out.end(), 0u);
    }
    const auto wrong = std::find_if(out.begin(), out.end(), [=](uint32_t index) { return index >= vertices; });
    if (wrong != out.end())
        refuse("%s: its corner %zu is vertex %lu, there are %zu", from.primitive.name(),
               static_cast<size_t>(wrong - out.begin()), static_cast<unsigned long>(*wrong), vertices);
    return out;
}

/* Makes triangles of a list, strip or fan of corners; every second triangle of a strip is turned around. */
std::vector<uint32_t> make_triangles(const std::vector<uint32_t> &corners, uint64_t mode)
{
    std::vector<uint32_t> out;

    if (mode == TRIANGLES) {
        out.assign(corners.begin(), corners.end() - static_cast<ptrdiff_t>(corners.size() % 3));
        return out;
    }
    for (size_t i = 0; i + 2 < corners.size(); i++) {
        const size_t odd = mode == STRIP ? i % 2 : 0;
        out.push_back(corners[mode == STRIP ? i : 0]);
        out.push_back(corners[i + 1 + odd]);
        out.push_back(corners[i + 2 - odd]);
    }
    return out;
}

shape read_primitive(document &file, const item &primitive, const std::vector<double> &weights, unsigned whole)
{
    const item extension = primitive.get("extensions").get("KHR_draco_mesh_compression");
    const uint64_t mode = primitive.get("mode").whole(TRIANGLES);
    source from{file, primitive, weights, {}, extension.get("attributes")};
    shape out{primitive.name(), {}, {}, {}, {}, {}, {}, {}, primitive.get("material")};

    if (mode > FAN)
        refuse("%s: mode %llu does not exist in glTF 2.0", primitive.name(), static_cast<unsigned long long>(mode));
    if (mode < TRIANGLES) {
        sheen_note(&file.notes, SHEEN_NOTE_WARNING, "%s: has points or lines, which are left out", file.path());
        return out;
    }
    if (extension)
        from.packed.emplace(file.bytes_of(extension.get("bufferView")), extension);
    out.points = read_attribute(from, "POSITION", "VEC3");
    if (out.points.count == 0)
        refuse("%s has no POSITION", primitive.name());
    out.normals = read_normals(from, out.points.count, whole);
    out.colors = read_optional(from, "COLOR_0", "VEC3 VEC4", out.points.count);
    out.uvs = read_optional(from, texcoord_name(file, out.material).c_str(), "VEC2", out.points.count);
    read_influences(from, out);
    const std::vector<uint32_t> corners = read_indices(from, out.points.count);
    out.triangles = make_triangles(corners, from.packed ? static_cast<uint64_t>(TRIANGLES) : mode);
    if (mode == TRIANGLES && corners.size() % 3 != 0)
        sheen_note(&file.notes, SHEEN_NOTE_WARNING, "%s: %s has %zu corners, no whole triangles; the rest is left out",
                   file.path(), primitive.name(), corners.size());
    return out;
}

} // namespace

std::vector<shape> read_mesh(document &file, const item &mesh, const std::vector<double> &weights, unsigned whole)
{
    const item primitives = mesh.get("primitives");
    std::vector<shape> out;

    for (size_t i = 0; i < primitives.size(); i++) {
        shape one = read_primitive(file, primitives.at(i), weights, whole);
        if (!one.triangles.empty())
            out.push_back(std::move(one));
    }
    return out;
}

} // namespace gltf
