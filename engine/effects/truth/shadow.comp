#version 460
// A step of the wavefront, 3: what of its light does each shadow ray let pass?
#include "engine/effects/truth/truth.h"
#include "shaders/trace.glsl"
vec3 unshadowed(Ray ray, vec3 carried) { return carried; } // none is asked here
#include "engine/effects/truth/wave.glsl"

layout(local_size_x = kWaveGroup) in;

void main()
{
    uint i;
    if (!dequeue(kShadowQueue, i)) return;
    ShadowRay shadow = shadows[i];
    shadows[i].carried = shadow.carried * transmittance(Ray(shadow.origin, shadow.direction, shadow.far));
}
