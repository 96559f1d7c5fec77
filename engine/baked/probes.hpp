// The tree of irradiance probes as two textures.
#pragma once
#include "engine/baked/ktx2.hpp"
#include "engine/baked/probe_tree.hpp"
#include <span>

namespace afterglow
{
// Layout. irradiance.ktx2 holds a probe in nine texels of a row: the nine coefficients of shaders/sh.h, r g b each, the lobe, its axis, and
// where in the box ag_lower..ag_upper the probe stands: 36 numbers. Of ag_order 1 it is four texels: four coefficients, the place. rgba16f,
// or rgba32f where one is beyond half's range. ag_count: of probes. irradiance_tree.ktx2 is a list of rgba32f texels, rows one after the
// other: ag_nodes nodes of two (normal, offset; below, above, 0, 0), then ag_cells cells of four (lower, 1 / extent, its eight probes).
// Positions are relative to ag_origin, in the level's own coordinates.
std::vector<vec4> probeTexels(const ProbeTree& tree, std::span<const vec3> places, int order); // `places`: the last numbers of each
std::vector<vec4> probeTreeTexels(std::span<const ProbeNode> nodes, std::span<const ProbeCell> cells);

Ktx2 probeTexture(const ProbeTree& tree);
Ktx2 probeTreeTexture(const ProbeTree& tree, dvec3 origin);

// Throws Error when the textures are not such a pair. `what` names the files in the sentence. `origin`: the scene's.
ProbeTree readProbes(const Ktx2& probes, const Ktx2& tree, const std::string& what, dvec3 origin);
}
