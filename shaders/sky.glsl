// The sky's radiance from a direction, for passes that read the scene's set.
#ifndef AFTERGLOW_SKY_GLSL
#define AFTERGLOW_SKY_GLSL
#include "shaders/bindings.glsl"
#include "shaders/light.h"

// Level 0 always: the map's own derivative is endless where its two ends meet.
vec3 skyRadianceFrom(vec3 direction, vec3 tint, float rotation, bool hasImage)
{
    if (!hasImage) return tint;
    return tint * textureLod(skyImage, skyUv(direction, rotation), 0.0).rgb;
}

#endif
