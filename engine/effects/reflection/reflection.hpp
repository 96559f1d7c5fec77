// Reflection over a lit picture: what glossy surfaces mirror of the picture itself or of the level, in place of what they mirrored of the
// probes.
#pragma once
#include "engine/effects/lit.hpp"
#include "engine/effects/reflection/reflection.h"
#include "engine/effects/shading.hpp"

namespace afterglow
{
enum class ReflectionMethod {
    screen, // the picture is marched; the probes keep what it does not show
    ray     // ray queries from every pixel that mirrors; their hits are lit anew. Needs level.scene.rays
};

// A new picture, the same to the bit where nothing is known. What lighting mirrored was that of the cubemaps, by the split sum; without
// them (parts.reflections) it was the point's own irradiance. `layers`: the part that is mirrored is kept in step, when asked for.
Lit reflection(Graph& graph, const View& view, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level, const Lit& lit,
               const LightingParts& parts, ReflectionMethod method, const ReflectionParameters& parameters, Layers* layers = nullptr);
}
