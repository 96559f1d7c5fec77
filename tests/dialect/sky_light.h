// The smallest sky that shaders/sky_light.h can be compiled with: a uniform one.
#ifndef AFTERGLOW_TEST_DIALECT_SKY_LIGHT_H
#define AFTERGLOW_TEST_DIALECT_SKY_LIGHT_H
#include "shaders/glsl.h"
SHARED_BEGIN

struct SkyMap {
    ivec2 size;
    vec3 tint;
    float rotation;
    uint sampled;
};

FN vec3 skyTexel(SkyMap, ivec2) { return vec3(0.0f); }
FN float skyRow(SkyMap, int) { return 1.0f; }
FN float skyColumn(SkyMap, ivec2) { return 1.0f; }

SHARED_END
#endif
