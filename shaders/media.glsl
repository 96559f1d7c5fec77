// What the level's media leave of light along a ray, for passes that read the scene's set.
#ifndef AFTERGLOW_MEDIA_GLSL
#define AFTERGLOW_MEDIA_GLSL
#include "shaders/bindings.glsl"
#include "shaders/medium.h"

const uint kEveryMedium = 0xffffffffu;

vec3 mediaTransmittance(uint count, uint without, vec3 origin, vec3 direction, float limit)
{
    vec3 through = vec3(1.0);
    for (uint i = 0u; i < count; ++i)
        if (i != without) through *= transmittance(media[i], origin, direction, limit);
    return through;
}

#endif
