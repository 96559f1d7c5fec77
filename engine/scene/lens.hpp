// A camera of the file, placed by a node.
#pragma once
#include "engine/scene/document.hpp"
#include "engine/scene/repair.hpp"
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace afterglow
{
// Its scale is taken off and its handedness kept right. Nothing when no picture can be made with it (counted): a field of view of 0 or 180
// degrees, a near plane at 0, a node that is flat.
std::optional<Camera> readCamera(const nlohmann::json& source, const dmat4& toWorld, Dropped& dropped);
}
