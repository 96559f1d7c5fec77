// Portals: a surface that shows what its twin sees.
#pragma once
#include "engine/effects/layers.hpp"
#include "engine/effects/portal/portal.h"
#include "engine/effects/virtual_view.hpp"

namespace afterglow
{
// Puts what lies beyond the portals of `pictures` in their place in `image`, where that part of their surfaces is seen.
void portal(Graph& graph, const View& eye, const GBuffer& surfaces, const GpuScene& scene, const std::vector<VirtualPicture>& pictures,
            FlatPart part, const Texture& image, const Layers& layers);
}
