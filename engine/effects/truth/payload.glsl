// What a shadow ray carries from program to program; one that asks for the nearest surface carries its Hit (shaders/ray.h).
#ifndef AFTERGLOW_TRUTH_PAYLOAD_GLSL
#define AFTERGLOW_TRUTH_PAYLOAD_GLSL
#include "shaders/ray.h"

struct Passed {
    vec3 share;   // of light, through all that let it through
    uint arrived; // 1: nothing ended the ray
};

#endif
