// Maps of a sun that follow the eye: how large they are, and where they look.
#include "engine/effects/shadow/shadow.hpp"
#include "engine/effects/view_ray.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr float kMostGrowth = 4.0f; // from one cascade to the next
constexpr uint kMostCascades = 4;
constexpr float kStep = 0.125f; // of the half edge: a cascade is drawn again when what is in view has moved that far

// The middle of the ball of that radius which holds the most of the view around the eye. With `a` between the view's axis and its corner
// the view is a cone: up to 45 degrees the ball passes through the eye, beyond its equator is the cone's rim.
vec3 ballMiddle(const View& view, float radius, const vec3& levelMiddle)
{
    const vec2 still = -view.jitter / vec2(view.size); // a picture coordinate that does not tremble with the samples
    const ViewRay axis = viewRay(vec2(0.5f) + still, 0.0f, view.clipToWorld, view.eye);
    if (view.eye.w == 0.0f) // an orthographic eye has no near: what lies beside the level's middle
        return axis.origin + axis.direction * std::max(dot(levelMiddle - axis.origin, axis.direction), 0.0f);
    const float cosine = dot(axis.direction, viewRay(still, 0.0f, view.clipToWorld, view.eye).direction);
    const float cotangent = cosine / std::sqrt(std::max(1.0f - cosine * cosine, 1e-6f));
    return axis.origin + axis.direction * (radius * std::clamp(cotangent, 0.0f, 1.0f));
}
}

std::vector<float> cascadeHalves(float diagonal, const ShadowParameters& parameters)
{
    const float level = 0.5f * diagonal;
    const float finest = std::min(0.5f * float(parameters.cascadeTexels) * parameters.finestTexel, 0.5f * level);
    const uint count = std::clamp(uint(std::ceil(std::log(level / finest) / std::log(kMostGrowth))), 1u, kMostCascades);
    std::vector<float> halves;
    for (uint i = 0; i < count; ++i) halves.push_back(finest * std::pow(level / finest, float(i) / float(count)));
    return halves;
}

mat4 cascadeClip(const Cascade& cascade, const View& view)
{
    // Half a step may be lost to the grid, and the rim blends into the next map
    const float half = cascade.half, step = kStep * half;
    const vec3 middle = ballMiddle(view, half * (1.0f - 0.5f * kStep - kCascadeBlend), cascade.levelMiddle);
    const auto row = [&](int i) { return vec3(cascade.level[0][i], cascade.level[1][i], cascade.level[2][i]); };
    const vec2 level(1.0f / length(row(0)), 1.0f / length(row(1))); // half edges of the level's map, m
    const vec2 ends = ceil(max(level - half, vec2(0.0f)) / step) * step;
    const vec2 at = clamp(round(vec2(cascade.level * vec4(middle, 1.0f)) * level / step) * step, -ends, ends);
    mat4 closer(1.0f); // from the level's clip space; its depth stays, so that what stands before the box casts into it
    closer[0][0] = level.x / half;
    closer[1][1] = level.y / half;
    closer[3] = vec4(-at / half, 0.0f, 1.0f);
    return mat4(dmat4(closer) * dmat4(cascade.level));
}
}
