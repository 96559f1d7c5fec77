#include "engine/scene/origin.hpp"

namespace afterglow
{
dvec3 originOf(const Box& box)
{
    constexpr double kNear = 2.0; // diagonals
    if (box.empty()) return dvec3(0.0);
    const dvec3 middle = 0.5 * (box.lower + box.upper);
    if (!(length(middle) > kNear * length(box.upper - box.lower))) return dvec3(0.0);
    return round(middle);
}
}
