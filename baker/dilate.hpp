// Carries light to where none was measured: into the padding around charts, so that filtering never meets a texel without data, and to
// the probes inside solids.
#pragma once
#include "engine/baked/baked.hpp"

namespace afterglow
{
// Fills texels without data from the mean of their neighbours with data, ring after ring; baked texels never change.
void dilate(Lightmap& lightmap, int rings = 4);

// Every invalid probe borrows the mean of its 26 neighbours that know something, ring after ring, and is marked (kProbeBorrowed of
// shaders/probe.h). In a volume without a valid probe all are black, with validity 0.
void dilate(ProbeVolume& volume);
}
