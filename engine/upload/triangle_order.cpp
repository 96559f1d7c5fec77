#include "engine/upload/triangle_order.hpp"
#include <algorithm>
#include <limits>
#include <numeric>

namespace afterglow
{
namespace
{
// Half the area of the box around them.
float areaAround(const std::vector<Extent>& extents, const uint* begin, const uint* end)
{
    vec3 lower = extents[*begin].lower, upper = extents[*begin].upper;
    for (const uint* i = begin; i != end; ++i) {
        lower = min(lower, extents[*i].lower);
        upper = max(upper, extents[*i].upper);
    }
    const vec3 e = upper - lower;
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

void halve(const std::vector<Extent>& extents, int axis, uint* begin, uint* middle, uint* end)
{
    const auto twiceMiddle = [&](uint i) { return extents[i].lower[axis] + extents[i].upper[axis]; };
    std::nth_element(begin, middle, end, [&](uint a, uint b) { // ties by index: the same order on every machine
        return twiceMiddle(a) != twiceMiddle(b) ? twiceMiddle(a) < twiceMiddle(b) : a < b;
    });
}
}

std::vector<uint> medianOrder(const std::vector<Extent>& extents)
{
    std::vector<uint> order(extents.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<std::pair<uint*, uint*>> open{{order.data(), order.data() + order.size()}};
    while (!open.empty()) {
        const auto [begin, end] = open.back();
        open.pop_back();
        if (end - begin < 3) continue;
        uint* const middle = begin + (end - begin + 1) / 2; // the left half holds first .. (first + last) / 2
        int best = 0;
        float least = std::numeric_limits<float>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            halve(extents, axis, begin, middle, end);
            const float area = areaAround(extents, begin, middle) + areaAround(extents, middle, end);
            if (!(area < least)) continue;
            least = area;
            best = axis;
        }
        if (best != 2) halve(extents, best, begin, middle, end);
        open.push_back({begin, middle});
        open.push_back({middle, end});
    }
    return order;
}
}
