#version 460
// A step of the wavefront, 4: light that passed is added; where a path has ended its slot begins the pixel's next sample, or its next
// pixel's first.
#include "engine/effects/truth/wave_step.glsl"

void main()
{
    uint slot;
    if (!dequeue(push.from, slot)) return;
    Slot beside;
    Path path = load(slot, beside);
    vec3 direct = vec3(0.0);
    for (uint i = 0u; i < beside.shadows; ++i) direct += shadows[slot * kDirectCategories + i].carried;
    path.radiance += direct;
    if (beside.goesOn != 0u) {
        beside.shadows = 0u;
        store(slot, path, beside);
        enqueue(1u - push.from, slot);
        return;
    }
    ivec2 place = ivec2(placeOf(beside.pixel));
    vec3 gathered = imageLoad(sum, place).rgb, missed = imageLoad(lost, place).rgb;
    add(gathered, missed, path.radiance);
    imageStore(sum, place, vec4(gathered, 1.0));
    imageStore(lost, place, vec4(missed, 1.0));

    uint index = sampleIndexOf(path.random) + 1u;
    if (index == push.samples.first + push.samples.count) {
        index = push.samples.first;
        beside.pixel += push.slots;
    }
    if (beside.pixel >= frame.picture.size.x * frame.picture.size.y) return;
    beginSample(slot, beside.pixel, index);
    enqueue(1u - push.from, slot);
}
