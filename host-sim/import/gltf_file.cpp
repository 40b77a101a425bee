/*
 * gltf_file.cpp - a glTF 2.0 file, text or binary; its buffers, inside or beside it; views of buffers.
 */
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include "gltf.h"
#include "mesh_bytes.h"

namespace gltf
{

namespace
{

/* Memory that may be allocated beside the file itself: ROOM_TIMES its size plus ROOM_BYTES, for small files. */
constexpr uint64_t ROOM_TIMES = 16, ROOM_BYTES = 64 << 20;

unsigned long long number_of(uint64_t n)
{
    return n;
}

uint32_t load32(const bytes &from, size_t at)
{
    uint32_t value = 0;

    for (size_t i = 0; i < 4; i++)
        value |= static_cast<uint32_t>(from[at + i]) << (8 * i);
    return value;
}

/* Returns false if the file cannot be read or is not a regular one. */
bool read_file(const std::string &path, bytes &out)
{
    struct sheen_problem problem;
    sheen_bytes file;
    const bool read = sheen_bytes_load(&file, path.c_str(), &problem) == 0;

    if (read)
        out.assign(file.bytes, file.bytes + file.count);
    sheen_bytes_free(&file);
    return read;
}

/* -1 if c is not a hexadecimal digit. */
int hex_digit(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

/* Decodes %20 and the like; a % without two hexadecimal digits after it is kept. */
std::string decode_percent(const std::string &text)
{
    std::string out;

    for (size_t i = 0; i < text.size(); i++) {
        const int high = text[i] == '%' && i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
        const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
        out += low >= 0 ? static_cast<char>(16 * high + low) : text[i];
        i += low >= 0 ? 2 : 0;
    }
    return out;
}

bytes decode_base64(const std::string &text, size_t at, const item &whom)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<int8_t, 256> values;
    bytes out;
    uint32_t bits = 0;
    unsigned count = 0;

    values.fill(-1);
    for (int i = 0; i < 64; i++)
        values[static_cast<uint8_t>(digits[i])] = static_cast<int8_t>(i);
    size_t end = text.size();
    while (end > at && text[end - 1] == '=')
        end--;
    out.reserve((end - at) / 4 * 3 + 3);
    for (; at < end; at++) {
        const int value = values[static_cast<uint8_t>(text[at])];
        if (value < 0)
            refuse("%s.uri: its data are not base64", whom.name());
        bits = bits << 6 | static_cast<uint32_t>(value);
        if (++count % 4 != 1)
            out.push_back(static_cast<uint8_t>(bits >> (6 - 2 * ((count - 1) % 4))));
    }
    return out;
}

} // namespace

view part(view whole, uint64_t offset, uint64_t count, const item &whom)
{
    if (offset > whole.size() || count > whole.size() - offset)
        refuse("%s: bytes %llu to %llu of %zu", whom.name(), number_of(offset), number_of(offset + count),
               whole.size());
    return whole.subspan(offset, count);
}

/* ---- the file ---- */

document::document(const std::string &path) : path_(path)
{
    bytes file;

    if (!read_file(path, file))
        refuse("it cannot be read");
    room_ = ROOM_TIMES * file.size() + ROOM_BYTES;
    if (file.size() >= 4 && memcmp(file.data(), "glTF", 4) == 0)
        open_binary(file);
    try {
        json_ = std::make_unique<nlohmann::json>(nlohmann::json::parse(file.begin(), file.end()));
    } catch (const nlohmann::json::exception &error) {
        refuse_json(error.what());
    }
    if (!json_->is_object())
        refuse("not a glTF file: its JSON is no object");
    check_version();
    check_extensions();
}

document::~document() = default;

/* A header of 12 bytes, then chunks: JSON, which is left in `file`, and binary. Chunks of extensions are skipped. */
void document::open_binary(bytes &file)
{
    const uint32_t version = file.size() >= 12 ? load32(file, 4) : 2, size = file.size() >= 12 ? load32(file, 8) : 12;
    bytes json;

    if (version != 2)
        refuse("glTF binary version %u; only 2 can be read", version);
    if (size > file.size() || file.size() < 20)
        refuse("it ends after %zu of %u bytes", file.size(), std::max(size, 20u));
    for (size_t at = 12, chunk = 0; at + 8 <= size; chunk++) {
        const uint32_t count = load32(file, at), type = load32(file, at + 4);
        at += 8;
        if (count > size - at)
            refuse("chunk %zu has %zu of %u bytes", chunk, size - at, count);
        if ((type == 0x4e4f534a) != (chunk == 0)) /* JSON */
            refuse("chunk %zu: %s", chunk, chunk ? "JSON a second time" : "not JSON, which comes first");
        const auto begin = file.begin() + static_cast<ptrdiff_t>(at);
        if (chunk == 0)
            json.assign(begin, begin + count);
        if (chunk == 1 && type == 0x004e4942) { /* BIN */
            binary_.assign(begin, begin + count);
            has_binary_ = true;
        }
        at += count;
    }
    file.swap(json);
}

void document::check_version() const
{
    const item asset = list("asset");
    const std::string number = asset.get("version").word(), least = asset.get("minVersion").text("2.0");

    if (number.empty())
        refuse("not glTF 2.0: asset.version is missing");
    if (number.compare(0, 2, "2.") != 0 || least.compare(0, 3, "2.0") != 0)
        refuse("glTF %.8s; only 2.0 can be read", (least > "2.0" ? least : number).c_str());
}

/*
 * A reader that does not know a required extension must refuse the file. The extensions
 * below are either read or concern materials, textures, lights or animations, which do
 * not change the shape.
 */
void document::check_extensions() const
{
    static const char *const known[] = {"KHR_mesh_quantization",
                                        "KHR_draco_mesh_compression",
                                        "EXT_meshopt_compression",
                                        "EXT_mesh_gpu_instancing",
                                        "KHR_node_visibility",
                                        "KHR_texture_transform",
                                        "KHR_texture_basisu",
                                        "KHR_lights_punctual",
                                        "KHR_animation_pointer",
                                        "KHR_techniques_webgl",
                                        "KHR_technique_webgl",
                                        "KHR_xmp",
                                        "KHR_xmp_json_ld",
                                        "EXT_texture_webp",
                                        "EXT_texture_avif",
                                        "EXT_lights_image_based",
                                        "EXT_lights_ies",
                                        "MSFT_texture_dds",
                                        "MSFT_packing_occlusionRoughnessMetallic",
                                        "MSFT_packing_normalRoughnessMetallic"};
    const item required = list("extensionsRequired");

    for (size_t i = 0; i < required.size(); i++) {
        const std::string name = required.at(i).text("");
        const bool is_material = name.compare(0, 14, "KHR_materials_") == 0;
        if (!is_material && std::find(std::begin(known), std::end(known), name) == std::end(known))
            refuse("it requires the extension %.100s, which is not known", name.c_str());
    }
}

item document::list(const char *key) const
{
    return item(json_.get(), "").get(key);
}

item document::entry(const char *key, const item &number) const
{
    const item all = list(key);
    const uint64_t index = number.whole();

    if (index >= all.size())
        refuse("%s is %llu, there are %zu %s", number.name(), number_of(index), all.size(), key);
    return all.at(index);
}

void document::take(uint64_t count, uint64_t size, const item &whom)
{
    if (size > 0 && count > room_ / size)
        refuse("%s: it takes more memory than a file of this size may", whom.name());
    room_ -= count * size;
}

/* ---- buffers ---- */

bytes document::decode_data(const std::string &uri, const item &whom)
{
    const size_t comma = uri.find(',');

    if (comma == std::string::npos)
        refuse("%s.uri: data without a comma", whom.name());
    if (uri.rfind(";base64", comma) != std::string::npos)
        return decode_base64(uri, comma + 1, whom);
    const std::string text = decode_percent(uri.substr(comma + 1));
    return bytes(text.begin(), text.end());
}

std::string document::beside(const std::string &uri) const
{
    const std::string name = decode_percent(uri);
    const size_t slash = path_.rfind('/');

    return name[0] == '/' || slash == std::string::npos ? name : path_.substr(0, slash + 1) + name;
}

bytes document::load(const std::string &uri, const item &whom)
{
    bytes out;

    if (uri.compare(0, 5, "data:") == 0)
        return decode_data(uri, whom);
    if (!read_file(beside(uri), out))
        refuse("%s: its file %.100s cannot be read", whom.name(), decode_percent(uri).c_str());
    room_ += ROOM_TIMES * out.size();
    return out;
}

view document::buffer(const item &number)
{
    const item entry_ = entry("buffers", number), uri = entry_.get("uri");
    const uint64_t index = number.whole(), length = entry_.get("byteLength").whole();
    const bool inside = !uri && index == 0 && has_binary_;

    if (!uri && !inside)
        refuse("%s has no uri", entry_.name());
    if (!inside && !buffers_.contains(index))
        buffers_[index] = load(uri.text(""), entry_);
    const bytes &all = inside ? binary_ : buffers_[index];
    if (length > all.size())
        refuse("%s ends after %zu of %llu bytes", entry_.name(), all.size(), number_of(length));
    return view(all.data(), length);
}

/* ---- views ---- */

namespace
{

/* Checks what the decoder only asserts. */
bool fits(const std::string &mode, const std::string &filter, uint64_t count, uint64_t stride)
{
    const bool shape = mode == "ATTRIBUTES" ? stride % 4 == 0 && stride >= 4 && stride <= 256
                                            : (stride == 2 || stride == 4) && (mode != "TRIANGLES" || count % 3 == 0);

    if (filter == "NONE")
        return shape;
    return shape && mode == "ATTRIBUTES" &&
           ((filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) || (filter == "QUATERNION" && stride == 8) ||
            filter == "EXPONENTIAL");
}

int decode(const std::string &mode, bytes &out, size_t count, size_t stride, view from)
{
    if (mode == "ATTRIBUTES")
        return meshopt_decodeVertexBuffer(out.data(), count, stride, from.data(), from.size());
    if (mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(out.data(), count, stride, from.data(), from.size());
    if (mode == "INDICES")
        return meshopt_decodeIndexSequence(out.data(), count, stride, from.data(), from.size());
    return -1;
}

} // namespace

const bytes &document::decompress(const item &number, const item &extension)
{
    const uint64_t index = number.whole(), count = extension.get("count").whole();
    const uint64_t stride = extension.get("byteStride").whole();
    const std::string mode = extension.get("mode").text(""), filter = extension.get("filter").text("NONE");
    const view from = part(buffer(extension.get("buffer")), extension.get("byteOffset").whole(0),
                           extension.get("byteLength").whole(), extension);

    if (decompressed_.contains(index))
        return decompressed_[index];
    if (!fits(mode, filter, count, stride))
        refuse("%s: mode %.20s, filter %.20s, byteStride %llu and count %llu do not go together", extension.name(),
               mode.c_str(), filter.c_str(), number_of(stride), number_of(count));
    take(count, stride, extension);
    bytes &out = decompressed_[index];
    out.resize(count * stride);
    if (decode(mode, out, count, stride, from) != 0)
        refuse("%s: its data are broken, or of a later version", extension.name());
    if (filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(out.data(), count, stride);
    if (filter == "QUATERNION")
        meshopt_decodeFilterQuat(out.data(), count, stride);
    if (filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(out.data(), count, stride);
    return out;
}

view document::bytes_of(const item &view_number)
{
    const item entry_ = entry("bufferViews", view_number);

    if (const item extension = entry_.get("extensions").get("EXT_meshopt_compression"))
        return decompress(view_number, extension);
    return part(buffer(entry_.get("buffer")), entry_.get("byteOffset").whole(0), entry_.get("byteLength").whole(),
                entry_);
}

} // namespace gltf
