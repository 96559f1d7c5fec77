// Neighbouring texels share what their paths find. A path ends its first ray at a point of the level, or in the sky; every neighbour that
// sees the point takes its light too, so that a texel has the light of sixteen paths for the price of one and of fifteen shadow rays, which
// travel as a packet.
// This work is based on: Bekaert et al. 2002 (path reuse), Veach 1997 (balance heuristic).
#pragma once
#include "baker/tracer.hpp"

namespace afterglow
{
struct Neighbours {
    int count = 0;
    Surface white[kPacket];   // points of texels: whiteSurface()
    Ray rays[kPacket];        // the first of each path: cosineRay()
    Sampler random[kPacket];  // of everything after it
    Hit hits[kPacket];        // where the rays end
    vec3 irradiance[kPacket]; // / pi: one sample of each
    bool directional = false;
    dvec3 turn[kPacket]; // its luminance times directionOf() each part's direction (shaders/lightmap.h), if directional

    void begin(int i) { irradiance[i] = vec3(0.0f), turn[i] = dvec3(0.0); }
    void gain(int i, vec3 direction, vec3 light); // that comes from there
    void bend(int i, vec3 direction, vec3 light); // the part of gain() for `turn`
};

// Fills `hits`, `irradiance` and `turn`. `here` holds the lights whose direct part is asked for, `beyond` those that paths meet.
//
// Of the light L(y) that texel j's path found at y, texel i takes the share p_i(y) / sum_k p_k(y), where p_k(y) is the area density with
// which texel k's own ray would have ended at y: 0 where it does not see it. That is the balance heuristic over all rays which could have
// found y, and since a ray's density is that of irradiance / pi, no factor is left over: shares add up to 1, none is large. Media on the way
// dim it, and in p_k the chance to pass them. Unbiased. What depends on where y is seen from (its reflections) stays with its own texel, as
// does the light of media.
void gather(Tracer here, Tracer beyond, Neighbours& group);
}
