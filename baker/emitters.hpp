// Emissive triangles as lights, chosen in proportion to their power.
#pragma once
#include "baker/world.hpp"
#include "shaders/light.h"

namespace afterglow
{
class Emitters
{
public:
    explicit Emitters(const World& world);

    // A point on an emitter, uniform over its area; pdf in solid angle about `from`, 0 when nothing emits.
    LightSample sample(vec3 from, float choice, vec2 u) const;

    // The pdf with which sample() finds what `ray` hit.
    float pdf(const Ray& ray, const Hit& hit, const Surface& surface) const;

    bool empty() const { return cumulative_.empty(); }

private:
    const World& world_;
    std::vector<uint> triangles_;
    std::vector<float> cumulative_; // over triangles_, ends at 1
    std::vector<float> density_;    // per world triangle: probability / area, 1/m2; empty when nothing emits
};
}
