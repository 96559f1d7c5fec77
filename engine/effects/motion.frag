#version 460
// Where the surface that this pixel shows was in the last frame; what is hidden, or cut away by its alpha, leaves no mark.
#include "engine/effects/motion.h"

layout(set = 1, binding = 0) uniform sampler2D depthTexture;
layout(location = 0) in vec4 last;
layout(location = 0) out vec4 motion;

const float kSameDepth = 1e-5; // share of it: two projections of one triangle round differently

void main()
{
    float depth = texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r;
    if (abs(gl_FragCoord.z - depth) > kSameDepth * depth) discard;
    motion = placeThen(last);
}
