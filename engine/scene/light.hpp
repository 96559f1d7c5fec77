// KHR_lights_punctual: a light of the file, placed by a node.
#pragma once
#include "engine/scene/document.hpp"
#include "engine/scene/repair.hpp"
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace afterglow
{
// The light shines along the node's -z; the node's scale does not matter. Nothing when it has no power or no direction (counted).
std::optional<Light> readLight(const nlohmann::json& source, const dmat4& toWorld, Dropped& dropped);
}
