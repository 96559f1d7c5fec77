#version 460
// A step of the wavefront, 2: each path goes on from what it met, and says which shadow rays it waits for.
#include "engine/effects/truth/wave.glsl"

uint slot;
Slot beside;
vec3 unshadowed(Ray ray, vec3 carried)
{
    uint i = slot * kDirectCategories + beside.shadows++;
    shadows[i] = ShadowRay(ray.origin, ray.direction, ray.far, carried);
    enqueue(kShadowQueue, i);
    return vec3(0.0); // what of it passes is added when the step is over
}

void main()
{
    if (!dequeue(push.from, slot)) return;
    Path path = load(slot, beside);
    beside.shadows = 0u;
    beside.goesOn = advance(Tracer(0u), Tracer(frame.lights), hits[slot], path) ? 1u : 0u; // a camera sees no lamp
    store(slot, path, beside);
}
