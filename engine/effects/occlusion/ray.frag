#version 460
// Rays into the hemisphere over the surface, cosine-weighted. The 16 pixels of a square of 4 x 4 share one sequence, of which each has its
// own part, and so do the 16 around any pixel: what the next pass averages is one even set of directions.
#include "engine/effects/occlusion/seen.glsl"
#include "engine/effects/view_ray.h"
#include "shaders/color.h"
#include "shaders/random.h"
#include "shaders/sampling.h"
#include "shaders/trace.glsl"

layout(push_constant, scalar) uniform Push { OcclusionTrace push; };
layout(constant_id = kOcclusionNoise) const bool kNoise = false;
layout(location = 1) out float noise; // standard deviation of the visibility, twice

void main()
{
    noise = 0.0;
    SeenPoint p;
    if (!seenPoint(p)) return;
    float cornerError = max(cornerRounding(p.position, positionAt(vec2(p.pixel + ivec2(1, 0)), p.depth)),
                            cornerRounding(p.position, positionAt(vec2(p.pixel + ivec2(0, 1)), p.depth)));
    float meetingError_ = rayErrors[decodeGBuffer(texelFetch(surfaceTexture, p.pixel, 0)).material];
    PixelPoint from = PixelPoint(push.eye + p.position, cornerError, p.normal, p.face, length(p.position), meetingError_);
    vec3 origin = leaving(from, frame.pixelToEye, frame.eye);
    Frame local = makeFrame(p.normal);
    uint part = turnIndex(ivec2(gl_FragCoord.xy), 0) * frame.p.rays;
    float open = 0.0, squared = 0.0;
    for (uint k = 0u; k < frame.p.rays; ++k) {
        Sampler random = makeSampler(push.seed, part + k);
        vec3 way = toWorld(local, sampleCosineHemisphere(next2(random)));
        float passed = luminance(transmittance(Ray(origin, way, frame.p.range)));
        open += passed;
        squared += passed * passed;
    }
    float share = 1.0 / float(frame.p.rays);
    seen.x = open * share;
    if (kNoise) noise = 2.0 * sqrt(max(squared * share - seen.x * seen.x, 0.0) / float(frame.p.rays - 1u));
}
