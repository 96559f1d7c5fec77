// A probe volume as one 3D texture that any GPU filters.
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/baked/ktx2.hpp"

namespace afterglow
{
// Layout. A probe is 28 numbers: the nine coefficients of shaders/sh.h, r g b each, then validity. They lie in seven slabs along z, four
// numbers a texel: numbers 4 s .. 4 s + 3 of probe (i, j, k) are the texel (i, j, s * n.z + k) of a texture of n.x * n.y * 7 n.z. Inside a
// slab, hardware filtering is the interpolation between probes (keep half a texel away from the slab's first and last z).
constexpr int kProbeSlabs = 7;

// rgba16f, or rgba32f where a coefficient is beyond half's range. Keys: ag_name, ag_to_world (columns of the 4 x 4, in the level's own
// coordinates; `origin` is the scene's).
Ktx2 probeTexture(const ProbeVolume& volume, dvec3 origin = dvec3(0.0));

// Throws Error when the texture is not a probe volume.
ProbeVolume readProbes(const Ktx2& texture, const std::string& what, dvec3 origin = dvec3(0.0));
}
