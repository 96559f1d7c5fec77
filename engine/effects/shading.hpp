// What the passes that light surfaces have in common: the variants and the first bindings of shading.glsl.
#pragma once
#include "engine/effects/shadows.hpp"
#include "engine/effects/view.hpp"

namespace afterglow
{
// Which of the bake's products, and of the level's features, this frame reads.
struct LightingParts {
    bool lightmaps = false;
    bool directional = false; // lightmaps tell the normals of a normal map apart
    bool probes = false, reflections = false, fog = false;
    bool mirrored = false; // say what the interfaces mirror, too
};

// `frame`: Lit::frame.
void shade(Pass& pass, const Shadows& shadows, const Buffer& frame, const GpuLevel& level, const LightingParts& parts);
}
