// Planar reflection: a mirror or still water shows what an eye behind it sees, in place of what probes would say.
#pragma once
#include "engine/effects/layers.hpp"
#include "engine/effects/virtual_view.hpp"

namespace afterglow
{
// Adds what the flats of `pictures` mirror to `image`, in that part of their surfaces; their draws are marked in eye.mirrored, so lighting
// has left that part out.
void planar(Graph& graph, const View& eye, const GBuffer& surfaces, const GpuScene& scene, const std::vector<VirtualPicture>& pictures,
            FlatPart part, const Texture& image, const Layers& layers);
}
