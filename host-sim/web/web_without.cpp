/*
 * web_without.cpp - replaces what the page does without: Assimp, Draco, meshoptimizer, and C++'s exceptions.
 *
 * WebAssembly as Debian's clang makes it has no exceptions: code that throws is compiled, code that catches is left
 * out. Everything that the readers throw ends the reading of a file, so here it ends the instance of the module that
 * reads, with the error line that mesh_gltf.cpp and gltf_file.cpp would have made of it.
 */
#include <cstdlib>
#include <meshoptimizer.h>
#include <new>
#include <nlohmann/json.hpp>
#include <typeinfo>

#include "../import/gltf.h"
#include "web_mesh.h"

extern "C" {
#include "mesh_assimp.h"
}

namespace
{

[[noreturn]] void without(const char *what)
{
    const std::string why = std::string("it is ") + what + "; the command sheen reads it, this page does not";

    sheen_web_refuse(SHEEN_ERR_UNSUPPORTED, why.c_str());
}

[[noreturn]] void no_memory()
{
    sheen_web_refuse(SHEEN_ERR_MEMORY, "reading it takes more memory than there is");
}

const bool is_set = (std::set_new_handler(no_memory), true);

} // namespace

extern "C" {

void *__cxa_allocate_exception(size_t size) noexcept
{
    return malloc(size);
}

[[noreturn]] void __cxa_throw(void *thrown, std::type_info *type, void (*)(void *))
{
    if (*type == typeid(gltf::refusal))
        sheen_web_refuse(SHEEN_ERR_ARGUMENT, static_cast<gltf::refusal *>(thrown)->text.c_str());
    /* Both have nlohmann's exception as their only base, so that the pointer may be cast. */
    if (*type == typeid(nlohmann::json::parse_error) || *type == typeid(nlohmann::json::out_of_range))
        gltf::refuse_json(static_cast<nlohmann::json::exception *>(thrown)->what());
    no_memory();
}

int sheen_mesh_assimp_knows(const char *)
{
    return 1;
}

int sheen_mesh_assimp_read(struct sheen_polygons *, const char *, struct sheen_problem *)
{
    without("not OBJ, STL, PLY, OFF or glTF");
}

/* Functions of meshoptimizer's C interface. */

int meshopt_decodeVertexBuffer(void *, size_t, size_t, const unsigned char *, size_t)
{
    without("compressed by meshoptimizer");
}

int meshopt_decodeIndexBuffer(void *, size_t, size_t, const unsigned char *, size_t)
{
    without("compressed by meshoptimizer");
}

int meshopt_decodeIndexSequence(void *, size_t, size_t, const unsigned char *, size_t)
{
    without("compressed by meshoptimizer");
}

void meshopt_decodeFilterOct(void *, size_t, size_t)
{
}

void meshopt_decodeFilterQuat(void *, size_t, size_t)
{
}

void meshopt_decodeFilterExp(void *, size_t, size_t)
{
}
}

namespace gltf
{

struct draco_mesh::holder {
};

draco_mesh::draco_mesh(view, const item &)
{
    without("compressed by Draco");
}

draco_mesh::~draco_mesh() = default;

table draco_mesh::attribute(const item &, const item &, const char *) const
{
    return {};
}

std::vector<uint32_t> draco_mesh::triangles() const
{
    return {};
}

} // namespace gltf
