// Screen-space reflection over a lit picture: what glossy surfaces mirror of the picture itself, in place of what they mirrored of the probes.
#pragma once
#include "engine/effects/lit.hpp"
#include "engine/effects/reflection/reflection.h"

namespace afterglow
{
// A new picture, the same to the bit where the screen knows nothing. `cubemaps`: what lighting mirrored was theirs, by the split sum; without
// them it was the point's own irradiance. `layers`: the part that is mirrored is kept in step, when asked for.
Lit reflection(Graph& graph, const View& view, const GBuffer& surfaces, const Lit& lit, bool cubemaps,
               const ReflectionParameters& parameters, Layers* layers = nullptr);
}
