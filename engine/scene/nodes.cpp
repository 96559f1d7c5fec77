#include "engine/scene/nodes.hpp"
#include "engine/scene/fields.hpp"
#include "engine/scene/placement.hpp"
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

struct Step {
    std::size_t node;
    dmat4 parent;
};

std::size_t nodeAt(const json& list, std::size_t i, std::size_t count)
{
    if (!list[i].is_number_unsigned() || list[i].get<std::uint64_t>() >= count)
        throw Malformed("a node is named " + list[i].dump() + ", and there are only " + std::to_string(count));
    return list[i].get<std::size_t>();
}

// The nodes that are nobody's child.
json parentless(const json& nodes)
{
    std::vector<bool> child(nodes.size(), false);
    for (const json& node : nodes) {
        const json& children = listOf(node, "children");
        for (std::size_t c = 0; c < children.size(); ++c) child[nodeAt(children, c, nodes.size())] = true;
    }
    json roots = json::array();
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!child[i]) roots.push_back(i);
    return roots;
}

bool withinReach(const dmat4& toWorld)
{
    for (int axis = 0; axis < 4; ++axis)
        for (int row = 0; row < 3; ++row)
            if (!(std::abs(toWorld[axis][row]) <= double(kLargestCoordinate))) return false;
    return true;
}
}

void walkNodes(const Document& document, const json& scene, Dropped& dropped,
               const std::function<void(std::size_t node, const dmat4& toWorld)>& visit)
{
    const json& nodes = listOf(*document.json, "nodes");
    std::vector<Step> ahead; // a stack: the tree may be deeper than the machine's
    std::vector<bool> seen(nodes.size(), false);
    const auto push = [&](const json& children, const dmat4& parent) {
        for (std::size_t c = children.size(); c-- > 0;) ahead.push_back({nodeAt(children, c, nodes.size()), parent});
    };
    push(scene.is_null() ? parentless(nodes) : listOf(scene, "nodes"), dmat4(1.0));
    while (!ahead.empty()) {
        const Step step = ahead.back();
        ahead.pop_back();
        if (seen[step.node]) {
            ++dropped["nodes met twice"];
            continue;
        }
        seen[step.node] = true;
        const dmat4 toWorld = step.parent * localTransform(nodes[step.node]);
        if (!withinReach(toWorld)) {
            ++dropped["nodes beyond 1e18 m"];
            continue;
        }
        visit(step.node, toWorld);
        push(listOf(nodes[step.node], "children"), toWorld);
    }
}
}
