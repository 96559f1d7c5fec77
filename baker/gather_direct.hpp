// Light that reaches neighbouring texels straight from the lights.
#pragma once
#include "baker/gather.hpp"

namespace afterglow
{
// Gives each texel kLightSamples of every category of `here`'s lights, and tells of those that are in `beyond` alone.
void gainDirect(Tracer here, Tracer beyond, Neighbours& group);
inline bool areSame(Tracer here, Tracer beyond) { return here.lights->size() == beyond.lights->size(); } // those are a part of these

// By which a texel's own rays find light, beside those samples: what multiple importance sampling weighs by. Its heuristics ask for ratios alone.
inline float rarity(float pdf) { return pdf / float(kLightSamples); }
}
