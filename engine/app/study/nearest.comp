#version 460
// Rays in, what each meets first out: a ray's price on this device, nothing shaded.
#include "shaders/trace.glsl"

layout(local_size_x = 64) in;
layout(set = 1, binding = 0, scalar) readonly buffer Rays { Ray rays[]; };
layout(set = 1, binding = 1, scalar) writeonly buffer Hits { Hit hits[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i < rays.length()) hits[i] = closestHit(rays[i]);
}
