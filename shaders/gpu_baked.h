// The baked level as shaders see it: engine/upload/gpu_baked.cpp fills these from engine/baked, shaders/bindings.glsl declares them.
#ifndef AFTERGLOW_GPU_BAKED_H
#define AFTERGLOW_GPU_BAKED_H
#include "shaders/probe.h"
SHARED_BEGIN

// The proxy of a reflection probe (shaders/reflection.h).
struct ReflectionBox {
    vec3 position;
    float mips;
    vec3 lower;
    vec3 upper;
};

// The split-sum table: n.v across, perceptual roughness down, 0 and 1 at the centres of the outermost texels.
const int kSplitSumSize = 32;
FN vec2 splitSumUv(float mu, float roughness)
{
    return (clamp(vec2(mu, roughness), 0.0f, 1.0f) * float(kSplitSumSize - 1) + 0.5f) / float(kSplitSumSize);
}

SHARED_END
#endif
