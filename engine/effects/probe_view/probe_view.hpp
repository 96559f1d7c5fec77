// Debug views of irradiance and reflection probes: where they stand, what they hold, and who asks them. Off, there is nothing of it.
#pragma once
#include "engine/baked/probe_tree.hpp"
#include "engine/effects/probe_view/probe_view.h"
#include "engine/effects/view.hpp"

namespace afterglow
{
constexpr bool showsSpheres(uint shown) { return shown == kShowProbes || shown == kShowValidity; }
// Colours that are to be displayed as they are, whatever the exposure.
constexpr bool showsColors(uint shown) { return shown != kShowNothing && shown != kShowProbes; }

// A sphere for each probe, in their order.
std::vector<ProbeMark> probeMarks(const ProbeTree& tree);

// Puts spheres into the picture and into its depth; what is said by colours makes a picture of its own. `marks`: probeMarks(), of spheres
// alone.
Texture probeView(Graph& graph, const View& view, const GBuffer& surfaces, const GpuLevel& level, const GpuBuffer& marks,
                  const Texture& image, uint shown);
}
