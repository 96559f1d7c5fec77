// Lighting: from the G-buffer to radiance, direct light by the law of each surface, indirect light as the bake says.
#pragma once
#include "engine/effects/lit.hpp"
#include "engine/effects/shading.hpp"

namespace afterglow
{
// Sky as the level says; ambient: radiance from everywhere where nothing baked says better.
struct Surroundings {
    vec3 ambient{0.0f};
    vec3 skyRadiance{0.0f};
    float skyRotation = 0.0f; // radians
};

// Mean radiance of a sky over all directions.
vec3 meanSky(const Sky& sky);

// `visibility` of the light from everywhere, R16F, 1 = open, dims what no lightmap lights; absent: nothing hides. `layers`: what the light
// consists of, when asked for.
Lit lighting(Graph& graph, const View& view, const GBuffer& surfaces, const Shadows& shadows, const Texture& visibility,
             const GpuLevel& level, const Surroundings& surroundings, const LightingParts& parts, Layers* layers = nullptr);

// Clear surfaces over the picture of all that is not clear; they mirror the probes. `lit` is what lighting() left, its radiance the picture.
void clearSurfaces(Graph& graph, const View& view, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level, const Lit& lit,
                   const LightingParts& parts, Layers* layers = nullptr);
}
