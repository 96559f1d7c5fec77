// Emissive triangles as lights, chosen in proportion to their power (shaders/emitter_choice.h), of the level as Embree meets it.
#pragma once
#include "baker/lanes.hpp"
#include "baker/world.hpp"
#include "engine/scene/emitters.hpp"
#include "shaders/light.h"

namespace afterglow
{
class Emitters
{
public:
    explicit Emitters(const World& world);

    // A point on an emitter, uniform over its area; pdf in solid angle about `from`, 0 when nothing emits.
    LightSample sample(vec3 from, float choice, vec2 u) const;

    // The same for many at once. There are emitters.
    void sample(const Lanes3& from, const DrawLanes& draws, LightLanes& light) const;

    // The pdf with which sample() finds what `ray` hit.
    float pdf(const Ray& ray, const Hit& hit, const Surface& surface) const;

    // A point of an emitter, likelier the more power leaves there, and its normal.
    struct Point {
        vec3 position, normal;
    };
    Point point(float choice, vec2 u) const;

    bool empty() const { return table_.emitters.empty(); }

private:
    const World& world_;
    EmitterTable table_;
};
}
