// The samples of each pixel, summed.
#ifndef AFTERGLOW_TRUTH_SUMS_GLSL
#define AFTERGLOW_TRUTH_SUMS_GLSL
#include "shaders/constants.h"

layout(set = 1, binding = 8, rgba32f) uniform image2D sum;
layout(set = 1, binding = 9, rgba32f) uniform image2D lost; // of the sum, by rounding

// Kahan's sum: of millions of samples as exact as of one. Samples that are not finite are dropped.
void add(inout vec3 gathered, inout vec3 missed, vec3 value)
{
    if (!(dot(value, value) < kFloatMax)) return;
    precise vec3 wanted = value - missed;
    precise vec3 grown = gathered + wanted;
    precise vec3 taken = grown - gathered;
    precise vec3 excess = taken - wanted;
    gathered = grown;
    missed = excess;
}

#endif
