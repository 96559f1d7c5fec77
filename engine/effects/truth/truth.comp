#version 460
// Path tracing, a few samples of every pixel: they are added to those that are there, and the mean of all is handed on. One path after the
// other, as baker/reference.cpp does: of one seed both draw the same random numbers.
#include "engine/effects/truth/tracer.glsl"

layout(local_size_x = kTruthGroup, local_size_y = kTruthGroup) in;
layout(push_constant, scalar) uniform Push { TruthPush push; };
layout(set = 1, binding = 8, rgba32f) uniform image2D sum;
layout(set = 1, binding = 9, rgba32f) uniform image2D lost; // of the sum, by rounding
layout(set = 1, binding = 10, rgba32f) writeonly uniform image2D mean;

// Kahan's sum: of millions of samples as exact as of one.
void add(inout vec3 gathered, inout vec3 missed, vec3 value)
{
    precise vec3 wanted = value - missed;
    precise vec3 grown = gathered + wanted;
    precise vec3 taken = grown - gathered;
    precise vec3 excess = taken - wanted;
    gathered = grown;
    missed = excess;
}

void main()
{
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.picture.size))) return;
    bool more = push.first > 0u;
    vec3 gathered = more ? imageLoad(sum, ivec2(pixel)).rgb : vec3(0.0);
    vec3 missed = more ? imageLoad(lost, ivec2(pixel)).rgb : vec3(0.0);
    uint last = push.first + push.count;
    for (uint i = push.first; i < last; ++i) {
        Sampler random = pixelSampler(frame.picture, pixel, i);
        Ray ray = pixelRay(frame.picture, pixel, next2(random));
        Tracer tracer = Tracer(frame.lights);
        Hit hit = unknownHit();
        if (kPortals) hit = hitThroughPortals(tracer, PortalSet(0u), ray, frame.picture.portalDepth);
        vec3 value = radianceAlong(Tracer(0u), tracer, ray, hit, 0.0, random); // a camera sees no lamp
        if (dot(value, value) < kFloatMax) add(gathered, missed, value); // samples that are not finite are dropped
    }
    imageStore(sum, ivec2(pixel), vec4(gathered, 1.0));
    imageStore(lost, ivec2(pixel), vec4(missed, 1.0));
    imageStore(mean, ivec2(pixel), vec4(gathered / float(last), 1.0));
}
