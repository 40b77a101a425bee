/*
 * gltf_color.cpp - colours of glTF materials.
 */
#include <cmath>

#include "gltf.h"

namespace gltf
{

uint8_t srgb(double linear)
{
    const double x = linear > 0 ? std::fmin(linear, 1) : 0; /* NaN: 0 */
    const double curve = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;

    return static_cast<uint8_t>(255 * curve + 0.5);
}

/* Metal and roughness, or, in older files, specular and glossiness beside it or in its place. */
material read_material(document &file, const item &from)
{
    const item metallic = from.get("pbrMetallicRoughness");
    const item glossy = from.get("extensions").get("KHR_materials_pbrSpecularGlossiness");
    const item factor = glossy ? glossy.get("diffuseFactor") : metallic.get("baseColorFactor");
    double rgba[4] = {1, 1, 1, 1};
    material out;

    out.name = from.get("name").text("");
    factor.reals(rgba, 4);
    for (size_t k = 0; k < 3; k++)
        out.factor[k] = rgba[k];
    if (glossy ? glossy.get("diffuseTexture") : metallic.get("baseColorTexture"))
        sheen_note(&file.notes, SHEEN_NOTE_ON_COLORS,
                   "%s: has colours in textures, which are not read; the materials' own are used", file.path());
    return out;
}

} // namespace gltf
