#include "engine/scene/places.hpp"
#include <algorithm>
#include <numeric>
#include <tuple>

namespace afterglow
{
std::vector<uint> firstOfPlace(std::span<const Vertex> vertices)
{
    std::vector<uint> order(vertices.size()), first(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto place = [&](uint v) { return std::tuple(vertices[v].position.x, vertices[v].position.y, vertices[v].position.z); };
    std::sort(order.begin(), order.end(), [&](uint a, uint b) { return std::tuple(place(a), a) < std::tuple(place(b), b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool again = i > 0 && place(order[i]) == place(order[i - 1]);
        first[order[i]] = again ? first[order[i - 1]] : order[i];
    }
    return first;
}
}
