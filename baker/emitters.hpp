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

    // A point of an emitter, likelier the more power leaves there, and its normal.
    struct Point {
        vec3 position, normal;
    };
    Point point(float choice, vec2 u) const;

    bool empty() const { return cumulative_.empty(); }

private:
    struct Emitter { // what a sample needs, together in memory
        uint triangle;
        vec3 corner, edge1, edge2; // m
        vec3 normal;
        vec3 emission;          // radiance; of a textured triangle its factor
        float density;          // probability of the choice / area, 1/m2
        bool bothSides, varies; // varies: by texture or alpha
    };
    std::size_t choose(float u) const;

    const World& world_;
    std::vector<Emitter> emitters_;
    std::vector<float> cumulative_; // over emitters_, ends at 1
    std::vector<uint> guide_;       // where to start looking: the first emitter whose cumulative value exceeds i / guide_.size()
    std::vector<float> density_;    // the same per world triangle; empty when nothing emits
};
}
