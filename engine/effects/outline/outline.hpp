// Outlines over a picture: the edges of the meshes that are lines for this eye, and the lines where objects pass through each other.
#pragma once
#include "engine/effects/layers.hpp"
#include "engine/effects/outline/outline.h"
#include "engine/effects/view.hpp"
#include "engine/upload/edges.hpp"

namespace afterglow
{
void outline(Graph& graph, const View& view, const GBuffer& surfaces, const GpuLevel& level, const GpuEdges& edges, const Texture& image,
             const OutlineParameters& parameters, const Layers* layers = nullptr);
}
