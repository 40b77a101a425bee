/*
 * gltf_json.cpp - values of a glTF file's JSON, with the names that messages use for them.
 */
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "gltf.h"

namespace gltf
{

void refuse(const char *format, ...)
{
    char text[512];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    throw refusal{text};
}

void refuse_json(const char *what)
{
    const char *at = strstr(what, "line "); /* the message contains "line 3, column 5: " */

    refuse("%.*s%snot JSON, or not all of it", at ? static_cast<int>(strcspn(at, ":")) : 0, at ? at : "",
           at ? ": " : "");
}

item::item(const nlohmann::json *value, std::string name)
    : value_(value && !value->is_null() ? value : nullptr), name_(std::move(name))
{
}

item item::get(const char *key) const
{
    if (value_ && !value_->is_object())
        refuse("%s is not an object", name());
    std::string name = name_.empty() ? key : name_ + "." + key;
    if (!value_)
        return item(nullptr, name);
    auto found = value_->find(key);
    return item(found == value_->end() ? nullptr : &*found, name);
}

size_t item::size() const
{
    if (value_ && !value_->is_array())
        refuse("%s is not an array", name());
    return value_ ? value_->size() : 0;
}

item item::at(size_t index) const
{
    if (index >= size())
        refuse("%s[%zu]: there are %zu", name(), index, size());
    return item(&(*value_)[index], name_ + "[" + std::to_string(index) + "]");
}

/* 24.0 is a whole number too, because some programs write all their whole numbers like that. */
uint64_t item::whole(uint64_t absent) const
{
    constexpr double most = 9007199254740992.0;

    if (!value_)
        return absent;
    double number = value_->is_number() ? value_->get<double>() : -1;
    if (!(number >= 0 && number <= most) || number != std::floor(number))
        refuse("%s is not a whole number from 0 on", name());
    return static_cast<uint64_t>(number);
}

uint64_t item::whole() const
{
    if (!value_)
        refuse("%s is missing", name());
    return whole(0);
}

double item::real(double absent) const
{
    if (!value_)
        return absent;
    if (!value_->is_number())
        refuse("%s is not a number", name());
    return value_->get<double>();
}

void item::reals(double *out, size_t count) const
{
    if (!value_)
        return;
    if (size() != count)
        refuse("%s has %zu numbers, not %zu", name(), size(), count);
    for (size_t i = 0; i < count; i++)
        out[i] = at(i).real(0);
}

std::string item::text(const char *absent) const
{
    if (!value_)
        return absent;
    if (!value_->is_string())
        refuse("%s is not a string", name());
    return value_->get<std::string>();
}

std::string item::word() const
{
    return !value_ ? "" : value_->is_string() ? value_->get<std::string>() : value_->dump();
}

bool item::flag() const
{
    if (value_ && !value_->is_boolean())
        refuse("%s is neither true nor false", name());
    return value_ && value_->get<bool>();
}

} // namespace gltf
