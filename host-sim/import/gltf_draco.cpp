/*
 * gltf_draco.cpp - KHR_draco_mesh_compression: reads the numbers of meshes that libdraco unpacks.
 */
#include <draco/compression/decode.h>

#include "gltf.h"

namespace gltf
{

struct draco_mesh::holder {
    std::unique_ptr<draco::Mesh> mesh;
};

draco_mesh::draco_mesh(view data, const item &whom) : holder_(std::make_unique<holder>())
{
    draco::DecoderBuffer buffer;
    draco::Decoder decoder;

    buffer.Init(reinterpret_cast<const char *>(data.data()), data.size());
    auto result = decoder.DecodeMeshFromBuffer(&buffer);
    if (!result.ok())
        refuse("%s: Draco: %.100s", whom.name(), result.status().error_msg());
    holder_->mesh = std::move(result).value();
}

draco_mesh::~draco_mesh() = default;

table draco_mesh::attribute(const item &id, const item &accessor, const char *types) const
{
    const draco::PointAttribute *from = holder_->mesh->GetAttributeByUniqueId(static_cast<uint32_t>(id.whole()));
    const bool divide = accessor.get("normalized").flag() && from && !from->normalized();
    const uint64_t component = accessor.get("componentType").whole();
    table out;

    if (!from)
        refuse("%s: its Draco mesh has no attribute %llu", id.name(), static_cast<unsigned long long>(id.whole()));
    out.count = holder_->mesh->num_points();
    out.parts = parts_of(accessor, types);
    out.numbers.resize(out.count * out.parts);
    for (size_t i = 0; i < out.count; i++) {
        double *row = &out.numbers[i * out.parts];
        const auto value = from->mapped_index(draco::PointIndex(static_cast<uint32_t>(i)));
        if (!from->ConvertValue<double>(value, static_cast<uint8_t>(out.parts), row))
            refuse("%s: its Draco mesh has no value for vertex %zu", id.name(), i);
        for (size_t k = 0; divide && k < out.parts; k++)
            row[k] = normalized(row[k], component);
    }
    return out;
}

std::vector<uint32_t> draco_mesh::triangles() const
{
    std::vector<uint32_t> out;

    out.reserve(3 * static_cast<size_t>(holder_->mesh->num_faces()));
    for (uint32_t f = 0; f < holder_->mesh->num_faces(); f++) {
        for (const auto &point : holder_->mesh->face(draco::FaceIndex(f)))
            out.push_back(point.value());
    }
    return out;
}

} // namespace gltf
