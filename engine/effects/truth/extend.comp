#version 460
// A step of the wavefront, 1: what does each path meet?
#include "engine/effects/truth/wave_step.glsl"

void main()
{
    uint slot;
    if (!dequeue(push.from, slot)) return;
    Slot beside;
    Path path = load(slot, beside);
    Tracer tracer = Tracer(frame.lights);
    if (kPortals) {
        // Only a camera sees through portals, and from there the path begins
        uint depth = path.surfaces + path.collisions == 0u ? frame.picture.portalDepth : 0u;
        Ray ray = path.ray;
        hits[slot] = hitThroughPortals(tracer, PortalSet(0u), ray, depth);
        if (ray != path.ray) {
            path.ray = ray;
            path.anchor = ray.origin;
            store(slot, path, beside);
        }
    } else {
        hits[slot] = closestHit(tracer, path.ray);
    }
}
