// The planes of what reaches into a region: what may part it.
#pragma once
#include "baker/region.hpp"
#include "baker/world.hpp"

namespace afterglow
{
// That triangles of a region lie in.
struct Plane {
    dvec3 normal;
    double offset;             // m
    double area = 0.0;         // m2, of those triangles, within the region
    double leastSection = 0.0; // m2: the region's section by the plane is no smaller
};

// Of those of `triangles` that reach further into the region than `thin` m, which are kept; in an order that is always the same.
std::vector<Plane> planesIn(const World& world, const Region& region, double thin, std::vector<uint>& triangles);
}
