// Toon: the surfaces of some materials answer light in steps.
#pragma once
#include "engine/effects/lit.hpp"
#include "engine/effects/shading.hpp"
#include "engine/effects/toon/toon.h"

namespace afterglow
{
struct ToonRamps {
    std::vector<ToonRamp> ofMaterial;
    std::vector<ToonStep> steps; // of all ramps
};

// As the level says; without a word of the level no material is in steps.
ToonRamps toonRamps(const Scene& scene, const ToonParameters& parameters);

// Over what lighting left, where surfaces are in steps; they then mirror nothing.
void toon(Graph& graph, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level, const Lit& lit, const LightingParts& parts,
          const ToonRamps& ramps, const Layers* layers = nullptr);
}
