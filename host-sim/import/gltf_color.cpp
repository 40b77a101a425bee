/*
 * gltf_color.cpp - colours and textures of glTF materials.
 */
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>

#include "gltf.h"

namespace gltf
{

uint8_t srgb(double linear)
{
    const double x = linear > 0 ? std::fmin(linear, 1) : 0; /* NaN: 0 */
    const double curve = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;

    return static_cast<uint8_t>(255 * curve + 0.5);
}

namespace
{

enum wrap {
    CLAMP = 33071,
    MIRROR = 33648
};

/* The specular-glossiness extension, which older files have beside metallic-roughness or instead of it. */
item glossy_of(const item &from)
{
    return from.get("extensions").get("KHR_materials_pbrSpecularGlossiness");
}

item texture_of(const item &from)
{
    const item glossy = glossy_of(from);

    return glossy ? glossy.get("diffuseTexture") : from.get("pbrMetallicRoughness").get("baseColorTexture");
}

item transform_of(const item &texture)
{
    return texture.get("extensions").get("KHR_texture_transform");
}

uint8_t wrap_of(const item &sampler, const char *key)
{
    const uint64_t number = sampler.get(key).whole(10497);

    return number == CLAMP ? SHEEN_WRAP_CLAMP : number == MIRROR ? SHEEN_WRAP_MIRROR : SHEEN_WRAP_REPEAT;
}

/* Scales, rotates, then moves uv. As v points downwards, the rotation looks counter-clockwise. */
void read_transform(const item &from, double uv[6])
{
    double offset[2] = {0, 0}, scale[2] = {1, 1};
    const double angle = from.get("rotation").real(0), c = std::cos(angle), s = std::sin(angle);

    from.get("offset").reals(offset, 2);
    from.get("scale").reals(scale, 2);
    const double all[6] = {c * scale[0], -s * scale[0], s * scale[1], c * scale[1], offset[0], offset[1]};
    std::memcpy(uv, all, sizeof all);
}

/*
 * The cut-off for a texel's alpha. MASK compares the texel's alpha times the factor's, `alpha`, with alphaCutoff, which
 * is therefore divided by `alpha`. BLEND is cut at half of the texel's own alpha whatever the factor's, so that a pane
 * of glass is drawn, although opaque.
 */
double cutoff_of(const item &from, double alpha)
{
    const std::string mode = from.get("alphaMode").text("OPAQUE");

    if (mode != "MASK")
        return mode == "BLEND" ? 0.5 : 0;
    const double least = from.get("alphaCutoff").real(0.5);
    if (!(least > 0))
        return 0;
    return least <= std::fmin(alpha, 1) ? least / std::fmin(alpha, 1) : SHEEN_CUT_ALL;
}

template <class T> T *copy_of(const T *from, size_t count)
{
    T *out = static_cast<T *>(std::malloc(count + 1));

    if (!out)
        throw std::bad_alloc();
    std::memcpy(out, from, count);
    out[count] = 0;
    return out;
}

/* Sets the picture's bytes if they are within the file, else the path of a file beside it. */
void find_picture(document &file, const item &image, struct sheen_picture &to)
{
    const std::string uri = image.get("uri").text("");
    const bool is_data = uri.compare(0, 5, "data:") == 0;
    bytes decoded;
    view inside;

    if (!uri.empty() && !is_data) {
        const std::string path = file.beside(uri);
        to.name = copy_of(path.c_str(), path.size());
        return;
    }
    if (is_data) {
        decoded = file.decode_data(uri, image);
        inside = decoded;
    } else {
        inside = file.bytes_of(image.get("bufferView"));
    }
    file.take(inside.size(), 1, image);
    const std::string name = std::string(file.path()) + ": " + image.name();
    to.bytes = copy_of(inside.data(), inside.size());
    to.count = inside.size();
    to.name = copy_of(name.c_str(), name.size());
}

/* A texture may have a picture in another format beside its PNG or JPEG, or instead of it. */
uint32_t read_picture(document &file, const item &number, double cutoff, struct sheen_polygons &out)
{
    const item texture = file.entry("textures", number), source = texture.get("source");
    const item sampler = texture.get("sampler") ? file.entry("samplers", texture.get("sampler")) : item(nullptr, "");
    struct sheen_picture picture = {};

    if (source) {
        find_picture(file, file.entry("images", source), picture);
    } else {
        const std::string name = std::string(file.path()) + ": " + texture.name();
        picture.name = copy_of(name.c_str(), name.size());
        picture.bytes = copy_of(reinterpret_cast<const unsigned char *>(""), 0); /* neither PNG nor JPEG */
    }
    picture.wrap[0] = wrap_of(sampler, "wrapS");
    picture.wrap[1] = wrap_of(sampler, "wrapT");
    picture.cutoff = cutoff;
    const uint32_t made = sheen_polygons_picture(&out, &picture);
    if (!made)
        throw std::bad_alloc();
    return made;
}

/* Warns of WebGL techniques: shader programs that set the colours in old files converted from COLLADA. */
void note_technique(document &file, const item &from)
{
    const item extensions = from.get("extensions");

    if (from.get("technique") || extensions.get("KHR_techniques_webgl") || extensions.get("KHR_technique_webgl"))
        sheen_note(&file.notes, SHEEN_NOTE_WARNING,
                   "%s: its techniques of WebGL are not read, nor the colours and textures that they show",
                   file.path());
}

} // namespace

uint64_t texcoord_of(const item &material)
{
    const item texture = texture_of(material);

    return transform_of(texture).get("texCoord").whole(texture.get("texCoord").whole(0));
}

material read_material(document &file, const item &from, struct sheen_polygons &out)
{
    const item glossy = glossy_of(from), texture = texture_of(from);
    const item factor = glossy ? glossy.get("diffuseFactor") : from.get("pbrMetallicRoughness").get("baseColorFactor");
    double rgba[4] = {1, 1, 1, 1};
    material made;

    made.name = from.get("name").text("");
    factor.reals(rgba, 4);
    for (size_t k = 0; k < 3; k++)
        made.factor[k] = rgba[k];
    if (texture) {
        made.picture = read_picture(file, texture.get("index"), cutoff_of(from, rgba[3]), out);
        read_transform(transform_of(texture), made.uv);
    }
    if (!texture && !factor)
        note_technique(file, from);
    return made;
}

} // namespace gltf
