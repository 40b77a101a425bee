/*
 * gltf_nodes.cpp - the places of a glTF file's nodes, and the meshes that they show.
 */
#include <algorithm>

#include "gltf.h"

namespace gltf
{

namespace
{

constexpr matrix IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

matrix multiply(const matrix &a, const matrix &b)
{
    matrix out;

    for (size_t column = 0; column < 4; column++) {
        for (size_t row = 0; row < 4; row++) {
            double sum = 0;
            for (size_t k = 0; k < 4; k++)
                sum += a[4 * k + row] * b[4 * column + k];
            out[4 * column + row] = sum;
        }
    }
    return out;
}

/* Scales, then rotates by the quaternion x y z w, whose length need not be exactly 1, then moves. */
matrix compose(const double move[3], const double turn[4], const double scale[3])
{
    const double square = turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3];
    const double s = square > 0 ? 2 / square : 0;
    const double x = turn[0], y = turn[1], z = turn[2], w = turn[3];

    return {scale[0] * (1 - s * (y * y + z * z)),
            scale[0] * s * (x * y + z * w),
            scale[0] * s * (x * z - y * w),
            0,
            scale[1] * s * (x * y - z * w),
            scale[1] * (1 - s * (x * x + z * z)),
            scale[1] * s * (y * z + x * w),
            0,
            scale[2] * s * (x * z + y * w),
            scale[2] * s * (y * z - x * w),
            scale[2] * (1 - s * (x * x + y * y)),
            0,
            move[0],
            move[1],
            move[2],
            1};
}

matrix read_local(const item &node)
{
    double move[3] = {0, 0, 0}, turn[4] = {0, 0, 0, 1}, scale[3] = {1, 1, 1};
    matrix out = IDENTITY;

    if (node.get("matrix")) {
        node.get("matrix").reals(out.data(), out.size());
        return out;
    }
    node.get("translation").reals(move, 3);
    node.get("rotation").reals(turn, 4);
    node.get("scale").reals(scale, 3);
    return compose(move, turn, scale);
}

constexpr size_t NONE = SIZE_MAX;

/* All nodes with their parents; their places in the world are computed on demand. */
class tree
{
  public:
    explicit tree(document &file);
    const matrix &world(size_t node);
    bool is_root(size_t node) const
    {
        return parents_[node] == NONE;
    }
    const item nodes;

  private:
    std::vector<size_t> parents_;
    std::vector<bool> known_;
    std::vector<matrix> worlds_;
};

tree::tree(document &file) : nodes(file.list("nodes"))
{
    file.take(nodes.size(), sizeof(matrix), nodes);
    parents_.resize(nodes.size(), NONE);
    known_.resize(nodes.size());
    worlds_.resize(nodes.size());
    for (size_t i = 0; i < nodes.size(); i++) {
        const item children = nodes.at(i).get("children");
        for (size_t c = 0; c < children.size(); c++) {
            (void)file.entry("nodes", children.at(c)); /* refused if out of range */
            size_t &parent = parents_[children.at(c).whole()];
            if (parent != NONE)
                refuse("%s: nodes[%zu] has it too", children.at(c).name(), parent);
            parent = i;
        }
    }
}

/* Goes up to the first ancestor whose place is known, then down again. */
const matrix &tree::world(size_t node)
{
    std::vector<size_t> way;

    for (size_t at = node; at != NONE && !known_[at]; at = parents_[at]) {
        if (way.size() == parents_.size())
            refuse("nodes[%zu] is below itself", node);
        way.push_back(at);
    }
    while (!way.empty()) {
        const size_t at = way.back();
        const matrix local = read_local(nodes.at(at));
        worlds_[at] = is_root(at) ? local : multiply(worlds_[parents_[at]], local);
        known_[at] = true;
        way.pop_back();
    }
    return worlds_[node];
}

/* The roots of the chosen scene; of the first scene if none is chosen; all roots if there are no scenes. */
std::vector<size_t> find_roots(const document &file, const tree &all)
{
    const item chosen = file.list("scene"), scenes = file.list("scenes");
    std::vector<size_t> out;

    if (!chosen && scenes.size() == 0) {
        for (size_t i = 0; i < all.nodes.size(); i++) {
            if (all.is_root(i))
                out.push_back(i);
        }
        return out;
    }
    const item nodes = (chosen ? file.entry("scenes", chosen) : scenes.at(0)).get("nodes");
    for (size_t i = 0; i < nodes.size(); i++) {
        (void)file.entry("nodes", nodes.at(i));
        out.push_back(nodes.at(i).whole());
    }
    return out;
}

/* EXT_mesh_gpu_instancing: shows the node's mesh once per row of the attributes, each a transform within the node. */
std::vector<matrix> read_instances(document &file, const item &extension, const matrix &world)
{
    const item from = extension.get("attributes");
    const char *const names[3] = {"TRANSLATION", "ROTATION", "SCALE"};
    table rows[3];
    std::vector<matrix> out;
    size_t count = NONE;

    for (size_t k = 0; k < 3; k++) {
        if (!from.get(names[k]))
            continue;
        rows[k] = read_accessor(file, from.get(names[k]), k == 1 ? "VEC4" : "VEC3");
        if (count != NONE && rows[k].count != count)
            refuse("%s: its attributes have %zu and %zu elements", extension.name(), count, rows[k].count);
        count = rows[k].count;
    }
    if (count == NONE)
        refuse("%s has none of the attributes TRANSLATION, ROTATION and SCALE", extension.name());
    file.take(count, sizeof(matrix), extension);
    for (size_t i = 0; i < count; i++) {
        const double still[3] = {0, 0, 0}, straight[4] = {0, 0, 0, 1}, same[3] = {1, 1, 1};
        out.push_back(
            multiply(world, compose(rows[0].count ? rows[0].row(i) : still, rows[1].count ? rows[1].row(i) : straight,
                                    rows[2].count ? rows[2].row(i) : same)));
    }
    return out;
}

/* For each joint the matrix from the mesh at rest to the world. The place of the node with the skin is ignored. */
std::vector<matrix> read_joints(document &file, const item &skin, tree &all)
{
    const item joints = skin.get("joints"), inverse = skin.get("inverseBindMatrices");
    std::vector<matrix> out;
    table binds;

    if (inverse)
        binds = read_accessor(file, inverse, "MAT4");
    if (inverse && binds.count < joints.size())
        refuse("%s: %zu matrices for %zu joints", inverse.name(), binds.count, joints.size());
    file.take(joints.size(), sizeof(matrix), joints);
    for (size_t j = 0; j < joints.size(); j++) {
        matrix bind = IDENTITY;
        (void)file.entry("nodes", joints.at(j));
        if (inverse)
            std::copy_n(binds.row(j), bind.size(), bind.begin());
        out.push_back(multiply(all.world(joints.at(j).whole()), bind));
    }
    return out;
}

placement place(document &file, size_t node, tree &all)
{
    const item from = all.nodes.at(node), instancing = from.get("extensions").get("EXT_mesh_gpu_instancing");
    placement out{file.entry("meshes", from.get("mesh")), {}, {}, {}, 0};
    const item weights = from.get("weights") ? from.get("weights") : out.mesh.get("weights");

    if (instancing && from.get("skin"))
        refuse("%s: a skin and instances of it together are not read", from.name());
    if (instancing)
        out.at = read_instances(file, instancing, all.world(node));
    else
        out.at.push_back(all.world(node));
    if (from.get("skin"))
        out.joints = read_joints(file, file.entry("skins", from.get("skin")), all);
    out.weights.resize(weights.size());
    weights.reals(out.weights.data(), out.weights.size());
    return out;
}

/* The number of morph targets of a mesh: the same for all of its primitives. */
size_t count_targets(const item &mesh)
{
    const item primitives = mesh.get("primitives");

    return primitives.size() ? primitives.at(0).get("targets").size() : 0;
}

/* The name of the mesh to which morph target `target` (from 1) belongs; empty if it is 0 or no mesh has targets. */
std::string find_target(const document &file, unsigned target)
{
    const item meshes = file.list("meshes");

    for (size_t i = 0; target && i < meshes.size(); i++) {
        const size_t count = count_targets(meshes.at(i));
        if (count && target > count)
            refuse("%s has %zu morph targets, none has number %u", meshes.at(i).name(), count, target - 1);
        if (count)
            return meshes.at(i).name();
    }
    return "";
}

void apply_target(placement &to, const std::string &mesh, unsigned target)
{
    if (mesh != to.mesh.name())
        return;
    to.whole = target;
    to.weights.resize(std::max(to.weights.size(), static_cast<size_t>(target)));
    to.weights[target - 1] = 1;
}

} // namespace

std::vector<placement> place_meshes(document &file, unsigned target)
{
    const std::string moved = find_target(file, target);
    tree all(file);
    std::vector<bool> seen(all.nodes.size());
    std::vector<size_t> waiting = find_roots(file, all);
    std::vector<placement> out;

    std::reverse(waiting.begin(), waiting.end());
    while (!waiting.empty()) {
        const size_t node = waiting.back();
        const item from = all.nodes.at(node), children = from.get("children");
        const item visible = from.get("extensions").get("KHR_node_visibility").get("visible");
        waiting.pop_back();
        if (seen[node] || (visible && !visible.flag()))
            continue;
        seen[node] = true; /* a node has one place, but may be named twice in a list of roots */
        if (from.get("mesh")) {
            out.push_back(place(file, node, all));
            apply_target(out.back(), moved, target);
        }
        for (size_t c = children.size(); c > 0; c--)
            waiting.push_back(children.at(c - 1).whole());
    }
    return out;
}

} // namespace gltf
