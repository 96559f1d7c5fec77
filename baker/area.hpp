// Points that lie uniform over the area of a world's triangles, or as dense as their materials ask.
#pragma once
#include "baker/world.hpp"
#include "shaders/random.h"
#include <span>

namespace afterglow
{
struct AreaPoint {
    uint triangle;
    vec3 corners; // barycentric: shares of its three
    vec3 position;
};

class Area
{
public:
    explicit Area(const World& world, std::span<const float> densities = {}); // by material; none given: 1
    double whole() const { return upTo_.empty() ? 0.0 : upTo_.back(); }       // m2, times density
    AreaPoint point(Sampler& random) const;                                   // of a whole above 0; takes next1, then next2

private:
    const World& world_;
    std::vector<double> upTo_; // cumulative over the triangles
};
}
