#version 460
// The wavefront begins: a path in each slot, empty sums where the picture is new.
#include "engine/effects/truth/truth.h"
#include "shaders/trace.glsl"
vec3 unshadowed(Ray ray, vec3 carried) { return carried; } // none is asked here
#include "engine/effects/truth/wave.glsl"

layout(local_size_x = kWaveGroup) in;

void main()
{
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= frame.picture.size.x * frame.picture.size.y) return;
    if (push.samples.first == 0u) {
        imageStore(sum, ivec2(placeOf(pixel)), vec4(0.0));
        imageStore(lost, ivec2(placeOf(pixel)), vec4(0.0));
    }
    if (pixel < kShadowQueue + 1u) queues[pixel] = WaveQueue(uint[](0u, 1u, 1u), 0u);
    if (pixel >= push.slots) return;
    if (pixel == 0u) queues[0] = WaveQueue(uint[]((push.slots + kWaveGroup - 1u) / kWaveGroup, 1u, 1u), push.slots);
    queued[pixel] = pixel;
    beginSample(pixel, pixel, push.samples.first);
}
