#version 460
// Path tracing, a few samples of every pixel: they are added to those that are there, and the mean of all is handed on. One path after the
// other, as baker/reference.cpp does: of one seed both draw the same random numbers.
#include "engine/effects/truth/tracer.glsl"

layout(local_size_x = kTruthGroup, local_size_y = kTruthGroup) in;
layout(push_constant, scalar) uniform Push { TruthPush push; };
layout(set = 1, binding = 8, rgba32f) uniform image2D sum;
layout(set = 1, binding = 9, rgba32f) writeonly uniform image2D mean;

void main()
{
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.picture.size))) return;
    vec3 gathered = push.first > 0u ? imageLoad(sum, ivec2(pixel)).rgb : vec3(0.0);
    uint last = push.first + push.count;
    for (uint i = push.first; i < last; ++i) {
        Sampler random = pixelSampler(frame.picture, pixel, i);
        Ray ray = pixelRay(frame.picture, pixel, next2(random));
        Tracer tracer = Tracer(frame.lights);
        Hit hit = unknownHit();
        if (kPortals) hit = hitThroughPortals(tracer, PortalSet(0u), ray, frame.picture.portalDepth);
        vec3 value = radianceAlong(Tracer(0u), tracer, ray, hit, 0.0, random); // a camera sees no lamp
        if (dot(value, value) < kFloatMax) gathered += value; // samples that are not finite are dropped
    }
    imageStore(sum, ivec2(pixel), vec4(gathered, float(last)));
    imageStore(mean, ivec2(pixel), vec4(gathered / float(last), 1.0));
}
