// A scene that both tracers are asked about.
#pragma once
#include "shaders/random.h"
#include "shaders/sampling.h"
#include "tests/shaders/tracing.hpp"

namespace afterglow
{
class Trace : public TracesRays
{
protected:
    Scene scene;

    // Rays from random points of the box, uniform in direction.
    static std::vector<Ray> raysIn(vec3 lower, vec3 upper, uint count, float far = kRayFar)
    {
        std::vector<Ray> rays;
        for (uint i = 0; i < count; ++i) {
            shared::Sampler random = makeSampler(7u, i);
            const vec2 xy = next2(random);
            const vec3 at(xy.x, xy.y, next1(random));
            rays.push_back({mix(lower, upper, at), sampleUniformSphere(next2(random)), far});
        }
        return rays;
    }

    void turned(const mat4& toWorld)
    {
        for (Object& object : scene.objects) object.toWorld = dmat4(toWorld);
    }
};
}
