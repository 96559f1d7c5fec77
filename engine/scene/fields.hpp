// Typed reads of glTF's JSON: an absent field is its default, a field of the wrong type is Malformed, an index stays inside its list.
#pragma once
#include "shaders/glsl.h"
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace afterglow
{
// The member, or null when the object does not have it (or is no object).
const nlohmann::json& member(const nlohmann::json& object, const char* key);
const nlohmann::json& extension(const nlohmann::json& object, const char* name);

// The list of that name at the top of the file; null elements are never in it.
const nlohmann::json& listOf(const nlohmann::json& gltf, const char* key);

double number(const nlohmann::json& object, const char* key, double fallback);
bool flag(const nlohmann::json& object, const char* key, bool fallback);
std::string text(const nlohmann::json& object, const char* key, const std::string& fallback = "");
shared::dvec2 pair(const nlohmann::json& object, const char* key, shared::dvec2 fallback);
shared::dvec3 triple(const nlohmann::json& object, const char* key, shared::dvec3 fallback);
shared::dvec4 quadruple(const nlohmann::json& object, const char* key, shared::dvec4 fallback);

// An index into a list of `count` elements; absent: nothing.
std::optional<std::size_t> index(const nlohmann::json& object, const char* key, std::size_t count);

// A size or offset in a file, at least 0.
std::uint64_t size(const nlohmann::json& object, const char* key, std::uint64_t fallback);
}
