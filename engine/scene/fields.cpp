#include "engine/scene/fields.hpp"
#include "engine/scene/document.hpp"
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

[[noreturn]] void wrong(const char* key, const char* what) { throw Malformed(std::string("\"") + key + "\" is not " + what); }

template <int N>
glm::vec<N, double> numbers(const json& object, const char* key, glm::vec<N, double> fallback)
{
    const json& value = member(object, key);
    if (value.is_null()) return fallback;
    if (!value.is_array() || value.size() != N) wrong(key, "a list of numbers of the right length");
    for (int i = 0; i < N; ++i) {
        if (!value[i].is_number()) wrong(key, "a list of numbers");
        fallback[i] = value[i].get<double>();
    }
    return fallback;
}
}

const json& member(const json& object, const char* key)
{
    static const json absent;
    if (!object.is_object()) return absent;
    const auto found = object.find(key);
    return found == object.end() ? absent : *found;
}

const json& extension(const json& object, const char* name) { return member(member(object, "extensions"), name); }

const json& listOf(const json& gltf, const char* key)
{
    static const json empty = json::array();
    const json& list = member(gltf, key);
    if (list.is_null()) return empty;
    if (!list.is_array()) wrong(key, "a list");
    return list;
}

double number(const json& object, const char* key, double fallback)
{
    const json& value = member(object, key);
    if (value.is_null()) return fallback;
    if (!value.is_number()) wrong(key, "a number");
    return value.get<double>();
}

bool flag(const json& object, const char* key, bool fallback)
{
    const json& value = member(object, key);
    if (value.is_null()) return fallback;
    if (!value.is_boolean()) wrong(key, "true or false");
    return value.get<bool>();
}

std::string text(const json& object, const char* key, const std::string& fallback)
{
    const json& value = member(object, key);
    if (value.is_null()) return fallback;
    if (!value.is_string()) wrong(key, "text");
    return value.get<std::string>();
}

shared::dvec2 pair(const json& object, const char* key, shared::dvec2 fallback) { return numbers<2>(object, key, fallback); }
shared::dvec3 triple(const json& object, const char* key, shared::dvec3 fallback) { return numbers<3>(object, key, fallback); }
shared::dvec4 quadruple(const json& object, const char* key, shared::dvec4 fallback) { return numbers<4>(object, key, fallback); }

std::optional<std::size_t> index(const json& object, const char* key, std::size_t count)
{
    const json& value = member(object, key);
    if (value.is_null()) return std::nullopt;
    if (!value.is_number_unsigned()) wrong(key, "an index");
    if (value.get<std::uint64_t>() >= count)
        throw Malformed(std::string("\"") + key + "\" is " + std::to_string(value.get<std::uint64_t>()) + ", and there are only " +
                        std::to_string(count));
    return value.get<std::size_t>();
}

std::uint64_t size(const json& object, const char* key, std::uint64_t fallback)
{
    const json& value = member(object, key);
    if (value.is_null()) return fallback;
    if (!value.is_number_unsigned()) wrong(key, "a size");
    return value.get<std::uint64_t>();
}
}
