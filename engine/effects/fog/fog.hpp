// Fog over a lit picture: dimming in closed form, single scattering by a march through the shadow maps.
#pragma once
#include "engine/effects/fog/fog.h"
#include "engine/effects/shadows.hpp"
#include "engine/effects/view.hpp"

namespace afterglow
{
Texture fog(Graph& graph, const View& view, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level, const vec3& ambient,
            const Texture& image, const FogParameters& parameters);
}
