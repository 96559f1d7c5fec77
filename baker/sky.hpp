// The sky as a light: its radiance by direction, and for an image the choice of directions in proportion to it.
#pragma once
#include "engine/scene/scene.hpp"
#include "shaders/light.h"
#include <vector>

namespace afterglow
{
class SkyLight
{
public:
    explicit SkyLight(const Sky& sky);
    vec3 radiance(vec3 direction) const;

    // A direction with pdf in proportion to luminance * solid angle; pdf 0 for a uniform sky: there BSDF sampling is as good and casts no
    // extra ray.
    LightSample sample(vec2 u) const;
    float pdf(vec3 direction) const;
    bool shines() const { return sky_.radiance != vec3(0.0f); }
    bool sampled() const { return !rows_.empty(); }

private:
    const Sky& sky_;
    std::vector<float> rows_;    // cumulative over rows, ends at 1; empty: uniform or black
    std::vector<float> columns_; // cumulative within each row
};
}
