/*
 * gltf.h - the interfaces between the parts of the glTF reader. Private to gltf_*.cpp and mesh_gltf.cpp.
 *
 *   gltf_json.cpp      values of the JSON text, with the names that messages use for them
 *   gltf_file.cpp      the file, its buffers and views of them
 *   gltf_accessor.cpp  numbers out of views
 *   gltf_draco.cpp     numbers out of Draco's meshes
 *   gltf_shape.cpp     a primitive as triangles, its morph targets applied
 *   gltf_nodes.cpp     the places of nodes, and the meshes that they show
 *   gltf_color.cpp     materials and their textures
 *   mesh_gltf.cpp      puts it together: a file to polygons
 *
 * Every number in a file is hostile until it has been checked against the data. What cannot
 * be read throws a refusal, from which mesh_gltf.cpp makes the one line for the user.
 */
#ifndef SHEEN_GLTF_H
#define SHEEN_GLTF_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

extern "C" {
#include "polygons.h"
}

namespace gltf
{

/* ---- gltf_json.cpp ---- */

/* Thrown if the file cannot be read: the line that says why, without the file's name. */
struct refusal {
    std::string text;
};

[[noreturn]] [[gnu::format(printf, 1, 2)]] void refuse(const char *format, ...);

/* Makes a refusal of what the JSON parser reports. */
[[noreturn]] void refuse_json(const char *what);

/*
 * A value of the JSON text and its name for messages, as in "accessors[3].sparse". A missing
 * value, or null, is an item too: it converts to false and has no parts. A value of another
 * type than asked for is refused by name.
 */
class item
{
  public:
    item(const nlohmann::json *value, std::string name);
    explicit operator bool() const
    {
        return value_ != nullptr;
    }
    const char *name() const
    {
        return name_.c_str();
    }
    item get(const char *key) const;             /* of an object */
    item at(size_t index) const;                 /* of an array; refused beyond its end */
    size_t size() const;                         /* of an array */
    uint64_t whole(uint64_t absent) const;       /* 0..2^53 */
    uint64_t whole() const;                      /* refused if missing */
    double real(double absent) const;            /* always finite, as all numbers in JSON */
    void reals(double *out, size_t count) const; /* an array of `count`; if absent *out is unchanged */
    std::string text(const char *absent) const;
    std::string word() const; /* a string; any other value as JSON text */
    bool flag() const;        /* absent: false */

  private:
    const nlohmann::json *value_;
    std::string name_;
};

/* ---- gltf_file.cpp ---- */

using bytes = std::vector<uint8_t>;
using view = std::span<const uint8_t>;

class document
{
  public:
    explicit document(const std::string &path);
    ~document();
    const char *path() const
    {
        return path_.c_str();
    }
    item list(const char *key) const;                            /* a top-level array: "nodes" */
    item entry(const char *key, const item &number) const;       /* refused if out of range */
    view bytes_of(const item &view_number);                      /* a buffer view's bytes, decompressed */
    std::string beside(const std::string &uri) const;            /* the path of the file that a URI names */
    bytes decode_data(const std::string &uri, const item &whom); /* of "data:..." */
    void take(uint64_t count, uint64_t size, const item &whom);  /* accounts for memory; refused beyond the bound */

    struct sheen_notes notes = {};

  private:
    void open_binary(bytes &file);
    void check_version() const;
    void check_extensions() const;
    view buffer(const item &number);
    bytes load(const std::string &uri, const item &buffer);
    const bytes &decompress(const item &number, const item &extension);

    std::string path_;
    uint64_t room_; /* bytes that may still be allocated */
    std::unique_ptr<nlohmann::json> json_;
    bytes binary_; /* the second chunk of a .glb */
    bool has_binary_ = false;
    std::map<uint64_t, bytes> buffers_, decompressed_;
};

/* `count` bytes from `offset` on; refused if the view is shorter. */
view part(view whole, uint64_t offset, uint64_t count, const item &whom);

/* ---- gltf_accessor.cpp ---- */

/* count rows of `parts` numbers; normalised integers are already converted to -1..1 or 0..1. */
struct table {
    size_t count = 0, parts = 0;
    std::vector<double> numbers;
    const double *row(size_t i) const
    {
        return &numbers[i * parts];
    }
};

/* types: the allowed ones, "VEC3 VEC4". */
table read_accessor(document &file, const item &number, const char *types);

size_t parts_of(const item &accessor, const char *types);
double normalized(double raw, uint64_t component);

/* ---- gltf_draco.cpp ---- */

/* A Draco mesh. glTF's accessors say what its numbers mean; how many there are it says itself. */
class draco_mesh
{
  public:
    draco_mesh(view data, const item &whom);
    ~draco_mesh();
    table attribute(const item &id, const item &accessor, const char *types) const;
    std::vector<uint32_t> triangles() const; /* 3 corners each */

  private:
    struct holder;
    std::unique_ptr<holder> holder_;
};

/* ---- gltf_shape.cpp ---- */

/* A primitive at rest, in its mesh's space. Tables have a row per vertex; all except the points may be missing. */
struct shape {
    std::string name; /* "meshes[0].primitives[2]" */
    table points, normals, colors, uvs;
    std::vector<table> joints, weights; /* 4 per vertex in each table; as many tables of joints as of weights */
    std::vector<uint32_t> triangles;    /* 3 corners each, below points.count */
    item material;
};

/*
 * The mesh's primitives that have triangles. weights: of the morph targets; missing ones are 0. whole: 1 + the number
 * of a target without whose normals there are no normals at all, or 0.
 */
std::vector<shape> read_mesh(document &file, const item &mesh, const std::vector<double> &weights, unsigned whole);

/* ---- gltf_nodes.cpp ---- */

using matrix = std::array<double, 16>; /* column by column, as in the file */

/* A mesh and where it is: once for each matrix of `at`, or bent by its skin's joints if it has both. */
struct placement {
    item mesh;
    std::vector<double> weights;
    std::vector<matrix> at, joints;
    unsigned whole = 0; /* 1 + the number of the morph target that was asked for, if it is this mesh's; else 0 */
};

/*
 * Everything that the scene shows. target: 1 + the number of the morph target, in the first mesh that has any, that
 * gets weight 1; 0: none.
 */
std::vector<placement> place_meshes(document &file, unsigned target);

/* ---- gltf_color.cpp ---- */

/* Linear light, 1 = white, to a byte of sRGB. */
uint8_t srgb(double linear);

struct material {
    std::string name;
    double factor[3] = {1, 1, 1};      /* base colour, linear */
    uint32_t picture = 0;              /* as in a group (polygons.h) */
    double uv[6] = {1, 0, 0, 1, 0, 0}; /* matrix, column by column: from the shape's uv to the picture's */
};

/* A material's appearance. Its picture is added to *out, but not read yet. */
material read_material(document &file, const item &from, struct sheen_polygons &out);

/* The number of the texture coordinates that its texture uses, as in "TEXCOORD_0". */
uint64_t texcoord_of(const item &material);

} // namespace gltf

#endif
