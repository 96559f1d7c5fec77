#version 460
// Before each step: the queues that it fills are empty.
#include "engine/effects/truth/truth.h"
#include "shaders/trace.glsl"
vec3 unshadowed(Ray ray, vec3 carried) { return carried; } // none is asked here
#include "engine/effects/truth/wave.glsl"

layout(local_size_x = 1) in;

void main()
{
    for (uint i = 0u; i <= kShadowQueue; ++i)
        if (i != push.from) queues[i] = WaveQueue(uint[](0u, 1u, 1u), 0u);
}
