// The tree of nodes, from the roots of a scene downwards.
#pragma once
#include "engine/scene/document.hpp"
#include "engine/scene/repair.hpp"
#include <functional>
#include <nlohmann/json_fwd.hpp>

namespace afterglow
{
// Calls visit(node, toWorld) for each node of the scene, parents first, children in order; for every node when the file has no scene. A
// node that is met again (two parents, or a circle) is visited once; one beyond 1e18 m is left out with its children. Both are counted.
void walkNodes(const Document& document, const nlohmann::json& scene, Dropped& dropped,
               const std::function<void(std::size_t node, const dmat4& toWorld)>& visit);
}
