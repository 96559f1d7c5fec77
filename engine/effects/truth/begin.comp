#version 460
// The wavefront begins: a path in each slot, empty sums where the picture is new.
#include "engine/effects/truth/wave_step.glsl"

void main()
{
    uint slot = gl_GlobalInvocationID.x;
    if (slot >= push.slots) return;
    if (slot == 0u) queues[0] = WaveQueue(uint[]((push.slots + kWaveGroup - 1u) / kWaveGroup, 1u, 1u), push.slots);
    uint pixels = frame.picture.size.x * frame.picture.size.y;
    for (uint pixel = slot; push.samples.first == 0u && pixel < pixels; pixel += push.slots) {
        imageStore(sum, ivec2(placeOf(pixel)), vec4(0.0));
        imageStore(lost, ivec2(placeOf(pixel)), vec4(0.0));
    }
    queued[slot] = slot;
    beginSample(slot, slot, push.samples.first);
}
