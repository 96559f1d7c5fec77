// Neighbouring texels share what their paths find. A path ends its first ray at a point of the level, or in the sky; every neighbour that
// sees the point takes its light too, so that a texel has the light of sixteen paths for the price of one and of fifteen shadow rays, which
// travel as a packet.
// This work is based on: Bekaert et al. 2002 (path reuse), Veach 1997 (balance heuristic, multi-sample model).
#pragma once
#include "baker/tracer.hpp"

namespace afterglow
{
// Of each category of light, for each path: they are even over all paths, and travel as packets. Room of `./run bench`, 64 paths a texel:
// squared error times time is 1, 0.77, 0.74 with 1, 2, 4 of them.
constexpr int kLightSamples = 4;

// White surfaces, as a loop over all of them wants them; `origin`: the position pushed off its surface. What a packet lacks faces nothing.
struct WhiteLanes {
    Lanes3 position, origin, normal, geometricNormal;

    void set(int i, vec3 at, vec3 from, vec3 shading, vec3 geometric);
};

struct Neighbours {
    int count = 0;
    WhiteLanes white;                         // points of texels
    Ray rays[kPacket];                        // the first of each path, cosine-distributed
    Sampler random[kPacket];                  // of everything after it
    uint lightSeed[kPacket] = {}, sample = 0; // of the light samples: equal seeds are one set, of which each path takes the next
    Hit hits[kPacket];                        // where the rays end
    Lanes3 irradiance;                        // / pi: one sample of each
    bool directional = false;
    Lanes3 turn; // its luminance times directionOf() each part's direction (shaders/lightmap.h), if directional

    bool tells = false;
    Bsdf base[kPacket]; // of the surfaces that the texels are of, if it tells of them
    Lanes3 more;        // what falls on these, by what their layer lets in, times their gain, of all lights of `beyond`; less `irradiance`

    void begin();
    void gain(int i, vec3 direction, vec3 light); // that comes from there
    void gain(const Lanes3& direction, const Lanes3& light);
    void bend(const Lanes3& direction, const Lanes3& light); // the part of gain() for `turn`
};

// Fills `hits`, `irradiance` and `turn`. `here` holds the lights whose direct part is asked for, `beyond` those that paths meet.
void gather(Tracer here, Tracer beyond, Neighbours& group);
}
