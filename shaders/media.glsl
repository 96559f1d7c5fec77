// The media of a level, for passes that read the scene's set: what shaders/media.h asks for.
#ifndef AFTERGLOW_MEDIA_GLSL
#define AFTERGLOW_MEDIA_GLSL
#include "shaders/bindings.glsl"

struct Air {
    uint count;
};
uint mediumCount(Air air) { return air.count; }
Medium mediumAt(Air air, uint i) { return media[i]; }
vec4 mediumPlaneAt(Air air, uint i) { return mediumPlanes[i]; }

#include "shaders/media.h"

#endif
