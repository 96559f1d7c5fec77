// The wavefront's memory, as all of its kernels see it: the estimator is one of them, cut into steps.
#ifndef AFTERGLOW_TRUTH_WAVE_GLSL
#define AFTERGLOW_TRUTH_WAVE_GLSL
#include "engine/effects/truth/truth.h"
#include "shaders/trace.glsl"

vec3 unshadowed(Ray ray, vec3 carried); // the includer says what becomes of a shadow ray
#include "engine/effects/truth/sums.glsl"
#include "engine/effects/truth/tracer.glsl"

layout(local_size_x = kWaveGroup) in;
layout(push_constant, scalar) uniform Push { WavePush push; };
layout(set = 1, binding = 10, scalar) buffer Queues { WaveQueue queues[]; };
layout(set = 1, binding = 11, scalar) buffer Queued { uint queued[]; };    // slots, slots, and shadow rays: three for each slot
layout(set = 1, binding = 12, scalar) buffer Paths { uvec4 paths[]; };     // vector by vector
layout(set = 1, binding = 13, scalar) buffer Hits { Hit hits[]; };         // of each slot
layout(set = 1, binding = 14, scalar) buffer Shadows { ShadowRay shadows[]; };

uint firstQueued(uint queue) { return queue * push.slots; }

void enqueue(uint queue, uint value)
{
    uint place = atomicAdd(queues[queue].count, 1u);
    if (place % kWaveGroup == 0u) atomicAdd(queues[queue].groups[0], 1u);
    queued[firstQueued(queue) + place] = value;
}

// Whose turn it is in this invocation; false: nobody's.
bool dequeue(uint queue, out uint value)
{
    uint place = gl_GlobalInvocationID.x;
    if (place >= queues[queue].count) return false;
    value = queued[firstQueued(queue) + place];
    return true;
}

// What a slot knows beside its path.
struct Slot {
    uint pixel;
    uint goesOn;  // 0: the path has ended
    uint shadows; // rays that it waits for
};

uint vectorOf(uint slot, uint i) { return i * push.slots + slot; }

void store(uint slot, Path path, Slot beside)
{
    uint flags = path.turned | path.seen << 1u | beside.goesOn << 2u | beside.shadows << 3u;
    paths[vectorOf(slot, 0u)] = uvec4(floatBitsToUint(path.ray.origin), floatBitsToUint(path.travelled));
    paths[vectorOf(slot, 1u)] = uvec4(floatBitsToUint(path.ray.direction), floatBitsToUint(path.pdf));
    paths[vectorOf(slot, 2u)] = uvec4(floatBitsToUint(path.throughput), path.surfaces);
    paths[vectorOf(slot, 3u)] = uvec4(floatBitsToUint(path.radiance), flags);
    paths[vectorOf(slot, 4u)] = uvec4(floatBitsToUint(path.anchor), path.collisions);
    paths[vectorOf(slot, 5u)] = uvec4(path.random.seed, path.random.index, path.random.dimension, beside.pixel);
}

Path load(uint slot, out Slot beside)
{
    uvec4 v0 = paths[vectorOf(slot, 0u)], v1 = paths[vectorOf(slot, 1u)], v2 = paths[vectorOf(slot, 2u)], v3 = paths[vectorOf(slot, 3u)],
          v4 = paths[vectorOf(slot, 4u)], v5 = paths[vectorOf(slot, 5u)];
    Path path;
    path.ray = Ray(uintBitsToFloat(v0.xyz), uintBitsToFloat(v1.xyz), kRayFar);
    path.travelled = uintBitsToFloat(v0.w);
    path.pdf = uintBitsToFloat(v1.w);
    path.throughput = uintBitsToFloat(v2.xyz);
    path.surfaces = v2.w;
    path.radiance = uintBitsToFloat(v3.xyz);
    path.turned = v3.w & 1u;
    path.seen = v3.w >> 1u & 1u;
    beside.goesOn = v3.w >> 2u & 1u;
    beside.shadows = v3.w >> 3u;
    path.anchor = uintBitsToFloat(v4.xyz);
    path.collisions = v4.w;
    path.random = Sampler(v5.x, v5.y, v5.z);
    beside.pixel = v5.w;
    return path;
}

uvec2 placeOf(uint pixel) { return uvec2(pixel % frame.picture.size.x, pixel / frame.picture.size.x); }

// The path of a pixel's sample begins at the camera.
void beginSample(uint slot, uint pixel, uint index)
{
    uvec2 place = placeOf(pixel);
    Sampler random = pixelSampler(frame.picture, place, index);
    Ray ray = pixelRay(frame.picture, place, next2(random));
    store(slot, beginPath(ray, 0.0, random), Slot(pixel, 1u, 0u));
}

#endif
