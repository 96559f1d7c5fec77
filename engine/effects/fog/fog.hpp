// Fog over a lit picture: dimming and glow in closed form, single scattering by a march through the shadow maps, remembered over frames.
#pragma once
#include "engine/effects/fog/fog.h"
#include "engine/effects/layers.hpp"
#include "engine/effects/shadows.hpp"
#include "engine/effects/view.hpp"

namespace afterglow
{
// What a frame leaves for the next.
struct FogMemory {
    View view;
    uint frames = 0;     // drawn so far
    uint remembered = 0; // frames whose march counts
};

// `memory` null: an eye that is there for one picture, as behind a mirror, remembers nothing; its march moves on with the view's frames.
Texture fog(Graph& graph, FogMemory* memory, const View& view, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level,
            const vec3& ambient, const Texture& image, const FogParameters& parameters, Layers* layers = nullptr);
}
