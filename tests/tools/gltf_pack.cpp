/*
 * gltf_pack.cpp - packs numbers with glTF's two compressions, for tests/cli/gltf: standard input to standard output.
 *
 *   gltf_pack draco VERTICES FACES METHOD BITS  floats of positions, then of normals, then 32-bit indices;
 *                                               METHOD 0 sequential, 1 edgebreaker; BITS 0: not quantised
 *   gltf_pack vertices COUNT STRIDE             EXT_meshopt_compression: ATTRIBUTES
 *   gltf_pack triangles COUNT, indices COUNT    32-bit indices: TRIANGLES, INDICES
 *   gltf_pack octahedral COUNT STRIDE           4 floats per row, encoded for that filter
 *   gltf_pack exponential COUNT STRIDE          STRIDE / 4 floats per row, likewise
 */
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>

namespace
{

std::vector<char> read_all()
{
    std::vector<char> out;

    for (int c = getchar(); c != EOF; c = getchar())
        out.push_back(static_cast<char>(c));
    return out;
}

/* Adds an attribute of 3 floats with one value per vertex. */
int add_attribute(draco::Mesh &mesh, draco::GeometryAttribute::Type type, const float *values, unsigned count)
{
    draco::GeometryAttribute form;

    form.Init(type, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
    const int id = mesh.AddAttribute(form, true, count);
    for (unsigned i = 0; i < count; i++)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), values + 3 * i);
    return id;
}

int pack_draco(const std::vector<char> &in, unsigned vertices, unsigned faces, int method, int bits)
{
    const float *numbers = reinterpret_cast<const float *>(in.data());
    const unsigned *indices = reinterpret_cast<const unsigned *>(numbers + 6 * vertices);
    draco::Mesh mesh;
    draco::Encoder encoder;
    draco::EncoderBuffer out;

    mesh.set_num_points(vertices);
    mesh.SetNumFaces(faces);
    for (unsigned f = 0; f < faces; f++) {
        draco::Mesh::Face face;
        for (unsigned k = 0; k < 3; k++)
            face[k] = draco::PointIndex(indices[3 * f + k]);
        mesh.SetFace(draco::FaceIndex(f), face);
    }
    add_attribute(mesh, draco::GeometryAttribute::POSITION, numbers, vertices);
    add_attribute(mesh, draco::GeometryAttribute::NORMAL, numbers + 3 * vertices, vertices);
    encoder.SetEncodingMethod(method ? draco::MESH_EDGEBREAKER_ENCODING : draco::MESH_SEQUENTIAL_ENCODING);
    if (bits) {
        encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
        encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, bits);
    }
    if (!encoder.EncodeMeshToBuffer(mesh, &out).ok())
        return 1;
    return fwrite(out.data(), 1, out.size(), stdout) != out.size();
}

int pack_meshopt(const std::string &mode, const std::vector<char> &in, size_t count, size_t stride)
{
    const unsigned *indices = reinterpret_cast<const unsigned *>(in.data());
    std::vector<unsigned char> out(64 + in.size() * 8);
    size_t size = 0;

    if (mode == "vertices")
        size = meshopt_encodeVertexBuffer(out.data(), out.size(), in.data(), count, stride);
    else if (mode == "triangles")
        size = meshopt_encodeIndexBuffer(out.data(), out.size(), indices, count);
    else if (mode == "indices")
        size = meshopt_encodeIndexSequence(out.data(), out.size(), indices, count);
    else if (mode == "octahedral")
        meshopt_encodeFilterOct(out.data(), count, stride, stride == 4 ? 8 : 16,
                                reinterpret_cast<const float *>(in.data()));
    else if (mode == "exponential")
        meshopt_encodeFilterExp(out.data(), count, stride, 20, reinterpret_cast<const float *>(in.data()));
    if (size == 0)
        size = count * stride;
    return fwrite(out.data(), 1, size, stdout) != size;
}

} // namespace

int main(int argc, char **argv)
{
    const std::string mode = argc > 1 ? argv[1] : "";
    unsigned numbers[4] = {0, 0, 0, 0};

    for (int i = 2; i < argc && i < 6; i++)
        numbers[i - 2] = static_cast<unsigned>(atoi(argv[i]));
    const std::vector<char> in = read_all();
    if (mode == "draco")
        return pack_draco(in, numbers[0], numbers[1], static_cast<int>(numbers[2]), static_cast<int>(numbers[3]));
    return pack_meshopt(mode, in, numbers[0], numbers[1]);
}
