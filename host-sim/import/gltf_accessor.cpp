/*
 * gltf_accessor.cpp - numbers out of a glTF file's views: every component type, normalized or not, and sparse.
 */
#include <cstring>

#include "gltf.h"

namespace gltf
{

namespace
{

enum component {
    I8 = 5120,
    U8 = 5121,
    I16 = 5122,
    U16 = 5123,
    U32 = 5125,
    F32 = 5126
};

size_t size_of(uint64_t component, const item &whom)
{
    switch (component) {
    case I8:
    case U8:
        return 1;
    case I16:
    case U16:
        return 2;
    case U32:
    case F32:
        return 4;
    }
    refuse("%s: componentType %llu does not exist in glTF 2.0", whom.name(),
           static_cast<unsigned long long>(component));
}

/* Little-endian, like everything in glTF. */
double load(const uint8_t *at, uint64_t component)
{
    uint32_t low = at[0];

    if (component == I8)
        return static_cast<int8_t>(low);
    if (component == U8)
        return low;
    low |= static_cast<uint32_t>(at[1]) << 8;
    if (component == I16)
        return static_cast<int16_t>(low);
    if (component == U16)
        return low;
    low |= static_cast<uint32_t>(at[2]) << 16 | static_cast<uint32_t>(at[3]) << 24;
    if (component == U32)
        return low;
    float value;
    static_assert(sizeof value == sizeof low);
    std::memcpy(&value, &low, sizeof value);
    return static_cast<double>(value);
}

/* Rows of numbers in a view. */
struct rows {
    view data; /* from the first row on */
    size_t stride;
    uint64_t component;
    bool normalize;
};

/* No product overflows: a count above the view's bytes is refused, and the stride is at most 255. */
rows find_rows(document &file, const item &holder, uint64_t component, size_t parts, uint64_t count, const item &whom)
{
    const item number = holder.get("bufferView");
    const size_t row = parts * size_of(component, whom);
    const uint64_t stride = file.entry("bufferViews", number).get("byteStride").whole(row);
    const uint64_t offset = holder.get("byteOffset").whole(0);
    const view data = file.bytes_of(number);

    if (stride < row || stride > 255)
        refuse("%s: its view's byteStride is %llu, its elements take %zu", whom.name(),
               static_cast<unsigned long long>(stride), row);
    if (count > data.size() || (count > 0 && offset + (count - 1) * stride + row > data.size()))
        refuse("%s: %llu elements reach beyond the %zu bytes of bufferViews[%llu]", whom.name(),
               static_cast<unsigned long long>(count), data.size(), static_cast<unsigned long long>(number.whole()));
    return {data.subspan(count > 0 ? offset : 0), static_cast<size_t>(stride), component, false};
}

void copy_row(const rows &from, size_t index, double *to, size_t parts)
{
    const size_t size = from.component == U8 || from.component == I8     ? 1
                        : from.component == U16 || from.component == I16 ? 2
                                                                         : 4;

    for (size_t k = 0; k < parts; k++) {
        const double raw = load(&from.data[index * from.stride + k * size], from.component);
        to[k] = from.normalize ? normalized(raw, from.component) : raw;
    }
}

/* Replaces some elements: `sparse` has a list of their indices and a list of their values. */
void read_sparse(document &file, const item &sparse, uint64_t component, bool normalize, table &to)
{
    const uint64_t count = sparse.get("count").whole();
    const item indices = sparse.get("indices"), values = sparse.get("values");
    const rows which = find_rows(file, indices, indices.get("componentType").whole(), 1, count, indices);
    rows what = find_rows(file, values, component, to.parts, count, values);

    what.normalize = normalize;
    for (size_t i = 0; i < count; i++) {
        double index;
        copy_row(which, i, &index, 1);
        if (!(index >= 0 && index < static_cast<double>(to.count)))
            refuse("%s: element %.0f of %zu", indices.name(), index, to.count);
        copy_row(what, i, &to.numbers[static_cast<size_t>(index) * to.parts], to.parts);
    }
}

} // namespace

double normalized(double raw, uint64_t component)
{
    switch (component) {
    case I8:
        return raw < -127 ? -1 : raw / 127;
    case U8:
        return raw / 255;
    case I16:
        return raw < -32767 ? -1 : raw / 32767;
    case U16:
        return raw / 65535;
    case U32:
        return raw / 4294967295.0;
    }
    return raw;
}

size_t parts_of(const item &accessor, const char *types)
{
    static const struct {
        const char *name;
        size_t parts;
    } all[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    const std::string type = accessor.get("type").text("");

    for (const auto &one : all) {
        if (type == one.name && std::strstr(types, one.name))
            return one.parts;
    }
    refuse("%s: its type is %s, not %s", accessor.name(), type.empty() ? "missing" : type.c_str(), types);
}

table read_accessor(document &file, const item &number, const char *types)
{
    const item accessor = file.entry("accessors", number);
    const uint64_t component = accessor.get("componentType").whole(), count = accessor.get("count").whole();
    const bool normalize = accessor.get("normalized").flag();
    table out;

    out.parts = parts_of(accessor, types);
    if (out.parts == 16 && component != F32)
        refuse("%s: matrices of other numbers than floats", accessor.name());
    out.count = count;
    if (accessor.get("bufferView")) {
        rows from = find_rows(file, accessor, component, out.parts, count, accessor);
        from.normalize = normalize;
        out.numbers.resize(count * out.parts);
        for (size_t i = 0; i < count; i++)
            copy_row(from, i, &out.numbers[i * out.parts], out.parts);
    } else {
        file.take(count, out.parts * sizeof(double), accessor);
        out.numbers.resize(count * out.parts); /* zeros */
    }
    if (const item sparse = accessor.get("sparse"))
        read_sparse(file, sparse, component, normalize, out);
    return out;
}

} // namespace gltf
