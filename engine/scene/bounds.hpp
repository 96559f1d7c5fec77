// A box in the world, in double precision, that grows around what is put into it.
#pragma once
#include "engine/scene/repair.hpp"
#include <algorithm>
#include <limits>

namespace afterglow
{
struct Box {
    dvec3 lower{std::numeric_limits<double>::infinity()}, upper{-std::numeric_limits<double>::infinity()}; // m

    bool empty() const { return !(lower.x <= upper.x); }
    bool hollow() const { return !(lower.x < upper.x && lower.y < upper.y && lower.z < upper.z); } // no inside
};

inline void grow(Box& box, dvec3 point)
{
    box.lower = min(box.lower, point);
    box.upper = max(box.upper, point);
}

inline void grow(Box& box, const Box& other)
{
    box.lower = min(box.lower, other.lower);
    box.upper = max(box.upper, other.upper);
}

// Every point of it is within kLargestCoordinate of the origin.
inline bool withinReach(const Box& box)
{
    const dvec3 reach = max(abs(box.lower), abs(box.upper));
    return std::max({reach.x, reach.y, reach.z}) <= double(kLargestCoordinate);
}
}
