// Lighting: from the G-buffer to radiance, direct light by the law of each surface, indirect light as the bake says.
#pragma once
#include "engine/effects/layers.hpp"
#include "engine/effects/shadows.hpp"
#include "engine/effects/view.hpp"

namespace afterglow
{
// Which of the bake's products, and of the level's features, this frame reads.
struct LightingParts {
    bool lightmaps = false, probes = false, reflections = false, clear = false, fog = false;
};

// Sky as the level says; ambient: radiance from everywhere where nothing baked says better.
struct Surroundings {
    vec3 ambient{0.0f};
    vec3 skyRadiance{0.0f};
    float skyRotation = 0.0f; // radians
};

// Mean radiance of a sky over all directions.
vec3 meanSky(const Sky& sky);

// Scene-linear radiance toward the eye, RGBA16F; a = 0 where the sky shows. `visibility` of the light from everywhere, R16F, 1 = open, dims
// what no lightmap lights; absent: nothing hides. `layers`: what the radiance consists of, when asked for.
Texture lighting(Graph& graph, const View& view, const GBuffer& surfaces, const Shadows& shadows, const Texture& visibility,
                 const GpuLevel& level, const Surroundings& surroundings, const LightingParts& parts, Layers* layers = nullptr);
}
