// A few samples of a pixel's paths, added to those that are there; the mean of all is handed on. One path after the other, as
// baker/reference.cpp does: of one seed both draw the same random numbers.
#ifndef AFTERGLOW_TRUTH_PIXEL_GLSL
#define AFTERGLOW_TRUTH_PIXEL_GLSL
vec3 unshadowed(Ray ray, vec3 carried) { return carried * transmittance(ray); }

#include "engine/effects/truth/sums.glsl"
#include "engine/effects/truth/tracer.glsl"

layout(push_constant, scalar) uniform Push { TruthPush push; };
layout(set = 1, binding = 10, rgba32f) writeonly uniform image2D mean;

void samplePixel(uvec2 pixel)
{
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
        add(gathered, missed, value);
    }
    imageStore(sum, ivec2(pixel), vec4(gathered, 1.0));
    imageStore(lost, ivec2(pixel), vec4(missed, 1.0));
    imageStore(mean, ivec2(pixel), vec4(gathered / float(last), 1.0));
}

#endif
