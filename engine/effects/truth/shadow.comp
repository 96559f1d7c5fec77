#version 460
// A step of the wavefront, 3: what of its light does each shadow ray let pass?
#include "engine/effects/truth/wave_step.glsl"

void main()
{
    uint i;
    if (!dequeue(kShadowQueue, i)) return;
    ShadowRay shadow = shadows[i];
    shadows[i].carried = shadow.carried * transmittance(Ray(shadow.origin, shadow.direction, shadow.far));
}
