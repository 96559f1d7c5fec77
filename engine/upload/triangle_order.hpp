// The order that makes a good tree of a driver that builds by halving: Mesa's lavapipe splits the list that it is given at
// (first + last) / 2, again and again, so the order is the tree. Drivers that sort for themselves lose nothing by it.
#pragma once
#include "engine/scene/scene.hpp"

namespace afterglow
{
struct Extent {
    vec3 lower, upper; // m
};

// A permutation of 0..size-1: halves by the median of the middles, along the axis that leaves the least area of both halves' boxes.
std::vector<uint> medianOrder(const std::vector<Extent>& extents);
}
