// The sky as a light on the CPU (shaders/sky_light.h).
#pragma once
#include "engine/scene/sky.hpp"
#include "shaders/light.h"

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
    bool sampled() const { return !table_.rows.empty(); }
    void leaveUnsampled() { table_ = {}; }

private:
    const Sky& sky_;
    SkyTable table_;
};
}
