/*
 * mesh_gltf.cpp - glTF 2.0 to polygons: every mesh that the scene shows, at its place. Runs in the confined child.
 */
#include "mesh_gltf.h"

#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>

#include "gltf.h"
#include "utf8.h"

using namespace gltf;

namespace
{

/* Bytes of output per vertex, and per triangle with its three corners. */
constexpr size_t VERTEX_BYTES = 24, TRIANGLE_BYTES = 3 * (4 + 24 + 16 + 3) + 4 + 2;

/* Appends zeroed room for `more` items to the `count` of an array that sheen_polygons_free releases. */
template <class T> void grow(T *&array, size_t count, size_t more)
{
    void *grown = realloc(static_cast<void *>(array), (count + more + 1) * sizeof *array);

    if (!grown)
        throw std::bad_alloc();
    array = static_cast<T *>(grown);
    memset(static_cast<void *>(array + count), 0, (more + 1) * sizeof *array);
}

/* The polygons being made, and the state of making them. */
struct making {
    document &file;
    struct sheen_polygons &out;
    std::vector<material> materials; /* the file's, then one for primitives without a material */
    bool with_normals, with_colors, with_uvs;
};

/* What placing a vertex gives beside its point. */
struct placed {
    double normal[3];
    bool is_mirrored; /* the transform turns the faces around it inside out */
};

void make_groups(making &to)
{
    const item all = to.file.list("materials");

    if (all.size() >= UINT16_MAX)
        refuse("%zu materials, at most %u can be used", all.size(), UINT16_MAX - 1u);
    for (size_t i = 0; i < all.size(); i++)
        to.materials.push_back(read_material(to.file, all.at(i), to.out));
    to.materials.emplace_back();
}

/* Blends the joints' matrices by weights scaled to a sum of 1; if all weights are 0 the first joint counts. */
matrix blend(const shape &from, size_t vertex, const std::vector<matrix> &joints)
{
    matrix out = {};
    double sum = 0;

    for (size_t set = 0; set < from.joints.size(); set++) {
        for (size_t k = 0; k < 4; k++)
            sum += from.weights[set].row(vertex)[k];
    }
    for (size_t set = 0; set < from.joints.size(); set++) {
        for (size_t k = 0; k < 4; k++) {
            const double joint = from.joints[set].row(vertex)[k];
            const double weight = sum != 0 ? from.weights[set].row(vertex)[k] / sum : set == 0 && k == 0;
            if (weight == 0)
                continue;
            if (!(joint >= 0 && joint < static_cast<double>(joints.size())))
                refuse("%s: vertex %zu uses joint %.0f, there are %zu", from.name.c_str(), vertex, joint,
                       joints.size());
            for (size_t i = 0; i < out.size(); i++)
                out[i] += weight * joints[static_cast<size_t>(joint)][i];
        }
    }
    return out;
}

/*
 * Normals are transformed by the cofactors, which are the inverse's transpose times the
 * determinant and exist for flattening transforms too.
 */
placed place_normal(const matrix &m, const double *normal)
{
    double cofactors[3][3], determinant = 0;
    placed out = {{0, 0, 0}, false};

    for (size_t i = 0; i < 3; i++) {
        const double *a = &m[4 * ((i + 1) % 3)], *b = &m[4 * ((i + 2) % 3)];
        for (size_t j = 0; j < 3; j++)
            cofactors[i][j] = a[(j + 1) % 3] * b[(j + 2) % 3] - a[(j + 2) % 3] * b[(j + 1) % 3];
    }
    for (size_t k = 0; k < 3; k++)
        determinant += m[k] * cofactors[0][k];
    out.is_mirrored = determinant < 0;
    for (size_t i = 0; normal && i < 3; i++) {
        for (size_t j = 0; j < 3; j++)
            out.normal[j] += (out.is_mirrored ? -normal[i] : normal[i]) * cofactors[i][j];
    }
    return out;
}

void place_point(const matrix &m, const double *point, double out[3])
{
    for (size_t k = 0; k < 3; k++)
        out[k] = m[k] * point[0] + m[4 + k] * point[1] + m[8 + k] * point[2] + m[12 + k];
}

bool is_float(const double v[3])
{
    return std::fabs(v[0]) <= FLT_MAX && std::fabs(v[1]) <= FLT_MAX && std::fabs(v[2]) <= FLT_MAX;
}

void put_color(const shape &from, size_t vertex, uint8_t color[3])
{
    for (size_t k = 0; k < 3; k++)
        color[k] = srgb(from.colors.count ? from.colors.row(vertex)[k] : 1);
}

/* A NaN in the file becomes infinite, because NaN stands for a missing uv (polygons.h). */
void put_uv(const shape &from, size_t vertex, const material &by, double uv[2])
{
    if (from.uvs.count == 0) {
        uv[0] = uv[1] = std::nan("");
        return;
    }
    const double *row = from.uvs.row(vertex);
    for (size_t k = 0; k < 2; k++) {
        uv[k] = by.uv[k] * row[0] + by.uv[2 + k] * row[1] + by.uv[4 + k];
        uv[k] = std::isnan(uv[k]) ? HUGE_VAL : uv[k];
    }
}

void grow_all(making &to, const shape &from)
{
    struct sheen_polygons &out = to.out;
    const size_t triangles = from.triangles.size() / 3;

    to.file.take(from.points.count, VERTEX_BYTES, item(nullptr, from.name));
    to.file.take(triangles, TRIANGLE_BYTES, item(nullptr, from.name));
    if (out.corner_count + from.triangles.size() > UINT32_MAX / 8 ||
        out.point_count + from.points.count > UINT32_MAX / 8)
        refuse("there are too many triangles");
    grow(out.points, out.point_count, from.points.count);
    grow(out.corners, out.corner_count, from.triangles.size());
    grow(out.normals, out.corner_count, from.triangles.size());
    grow(out.colors, out.corner_count, from.triangles.size());
    grow(out.uvs, out.corner_count, from.triangles.size());
    grow(out.first, out.polygon_count ? out.polygon_count + 1 : 0, triangles); /* one entry more than polygons */
    grow(out.groups, out.polygon_count, triangles);
}

/* Adds a triangle of the shape, its corners in reverse order if the first of them is mirrored. */
void add_triangle(making &to, const shape &from, const uint32_t *corners, const std::vector<placed> &vertices,
                  size_t group)
{
    struct sheen_polygons &out = to.out;
    const bool backwards = vertices[corners[0]].is_mirrored;

    for (size_t k = 0; k < 3; k++, out.corner_count++) {
        const uint32_t vertex = corners[backwards ? 2 - k : k];
        const size_t point = out.point_count + vertex;
        if (!is_float(out.points[point]))
            refuse("%s: vertex %lu is not a finite number", from.name.c_str(), static_cast<unsigned long>(vertex));
        out.corners[out.corner_count] = static_cast<uint32_t>(point);
        memcpy(out.normals[out.corner_count], vertices[vertex].normal, sizeof out.normals[0]);
        put_color(from, vertex, out.colors[out.corner_count]);
        put_uv(from, vertex, to.materials[group], out.uvs[out.corner_count]);
    }
    out.groups[out.polygon_count] = static_cast<uint16_t>(group);
    out.first[++out.polygon_count] = static_cast<uint32_t>(out.corner_count);
}

/* A skinned shape is placed by `joints`, any other by `at`. */
void add_shape(making &to, const shape &from, const std::vector<matrix> &joints, const matrix &at)
{
    const bool is_skinned = !joints.empty() && !from.joints.empty();
    std::vector<placed> vertices(from.points.count);
    size_t group = to.materials.size() - 1;

    if (from.material) {
        (void)to.file.entry("materials", from.material);
        group = from.material.whole();
    }
    grow_all(to, from);
    for (size_t v = 0; v < from.points.count; v++) {
        const matrix m = is_skinned ? blend(from, v, joints) : at;
        place_point(m, from.points.row(v), to.out.points[to.out.point_count + v]);
        vertices[v] = place_normal(m, from.normals.count ? from.normals.row(v) : nullptr);
    }
    for (size_t t = 0; t < from.triangles.size(); t += 3)
        add_triangle(to, from, &from.triangles[t], vertices, group);
    to.out.point_count += from.points.count;
    to.with_normals |= from.normals.count > 0;
    to.with_colors |= from.colors.count > 0;
    to.with_uvs |= from.uvs.count > 0;
}

/* A mesh at several places that follow each other is read once. */
void add_meshes(making &to)
{
    std::vector<shape> shapes;
    std::string name;
    std::vector<double> weights;

    for (const placement &one : place_meshes(to.file, to.out.target)) {
        if (name != one.mesh.name() || weights != one.weights)
            shapes = read_mesh(to.file, one.mesh, one.weights, one.whole);
        name = one.mesh.name();
        weights = one.weights;
        for (const shape &part_ : shapes) {
            for (const matrix &at : one.at)
                add_shape(to, part_, one.joints, at);
        }
    }
}

void set_groups(making &to)
{
    struct sheen_polygons &out = to.out;

    grow(out.group, 0, to.materials.size());
    out.group_count = to.materials.size();
    for (size_t g = 0; g < out.group_count; g++) {
        struct sheen_group &group = out.group[g];
        sheen_utf8_copy(group.name, sizeof group.name, to.materials[g].name.c_str());
        group.has_color = g + 1 < out.group_count;
        group.picture = to.materials[g].picture;
        for (size_t k = 0; k < 3 && group.has_color; k++)
            group.color[k] = srgb(to.materials[g].factor[k]);
    }
}

void read(struct sheen_polygons &out, const char *path)
{
    document file(path);
    making to{file, out, {}, false, false, false};

    make_groups(to);
    const uint32_t noted = file.notes.count;
    add_meshes(to);
    if (out.polygon_count == 0)
        refuse(file.notes.count > noted ? "its scene has points or lines, but no triangles"
                                        : "its scene has no triangles");
    set_groups(to);
    if (!to.with_normals) {
        free(out.normals);
        out.normals = nullptr;
    }
    if (!to.with_colors) {
        free(out.colors);
        out.colors = nullptr;
    }
    if (!to.with_uvs) {
        free(out.uvs);
        out.uvs = nullptr;
    }
    out.notes = file.notes;
}

} // namespace

int sheen_mesh_gltf_read(struct sheen_polygons *polygons, const char *path, struct sheen_problem *problem)
{
    const unsigned target = polygons->target;

    memset(polygons, 0, sizeof *polygons);
    polygons->target = target;
    try {
        read(*polygons, path);
        return SHEEN_OK;
    } catch (const refusal &why) {
        return sheen_problem(problem, SHEEN_ERR_ARGUMENT, "%s: %s", path, why.text.c_str());
    } catch (const std::exception &) { /* std::bad_alloc, std::length_error */
        return sheen_problem(problem, SHEEN_ERR_MEMORY, "%s: it takes more memory than a file of this size may", path);
    }
}
