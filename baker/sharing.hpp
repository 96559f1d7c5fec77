// What one texel's path found, given to all neighbours that see it.
//
// Of the light L(y) that texel j's path found at y, texel i takes the share p_i(y) / sum_k p_k(y), where p_k(y) is the area density with
// which texel k's own ray would have ended at y: 0 where it does not see it. That is the balance heuristic over all rays which could have
// found y, and since a ray's density is that of irradiance / pi, no factor is left over: shares add up to 1, none is large. Media on the way
// dim it, and in p_k the chance to pass them. Unbiased. What depends on where y is seen from (its reflections) stays with its own texel, as
// does the light of media.
#pragma once
#include "baker/gather.hpp"

namespace afterglow
{
struct Find {
    bool sky = false;
    vec3 position{0.0f}; // of y, pushed off its surface
    vec3 normal{0.0f};   // on the side that was met; of the sky, from it to us
    Surface surface;
    Hit hit;
    vec3 matte{0.0f}; // radiance of the surface's base, by what its layer lets out
    bool any = false;
};

// Gives what texel j's path found to all who see it.
void share(Tracer beyond, Neighbours& group, int j, const Find& find);
}
