// What the level's media do to light along a ray, in closed form: each is homogeneous in its box.
#ifndef AFTERGLOW_MEDIA_GLSL
#define AFTERGLOW_MEDIA_GLSL
#include "engine/effects/fog/fog.h"
#include "shaders/bindings.glsl"

const uint kEveryMedium = 0xffffffffu;

vec3 mediaTransmittance(uint count, uint without, vec3 origin, vec3 direction, float limit)
{
    vec3 through = vec3(1.0);
    for (uint i = 0u; i < count; ++i) {
        if (i == without) continue;
        Medium m = media[i];
        through *= transmittance(extinction(m), spanLength(boxSpan(origin, direction, m.lower, m.upper, limit)));
    }
    return through;
}

#endif
