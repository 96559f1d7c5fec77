#version 460
// The exposure that shows the picture's mean log luminance, without its extremes, as middle grey. One group: a histogram of a grid of
// points.
#include "engine/effects/display/display.h"

layout(constant_id = kExposureAdapts) const bool kAdapts = false;
layout(local_size_x = kExposureThreads) in;
layout(push_constant, scalar) uniform Push { ExposurePush push; };
layout(set = 1, binding = 0) uniform sampler2D radiance;
layout(set = 1, binding = 1) uniform sampler2D last;
layout(set = 1, binding = 2, r32f) writeonly uniform image2D exposure;

shared uint counts[kExposureBins];
shared uint fractions[kExposureBins]; // sum of the places within the bin, in steps of 1 / kExposureFine

void main()
{
    uint thread = gl_LocalInvocationID.x;
    for (uint bin = thread; bin < kExposureBins; bin += kExposureThreads) counts[bin] = fractions[bin] = 0u;
    barrier();
    ivec2 size = textureSize(radiance, 0);
    for (uint i = thread; i < kExposureColumns * kExposureRows; i += kExposureThreads) {
        vec2 at = (vec2(i % kExposureColumns, i / kExposureColumns) + 0.5) / vec2(kExposureColumns, kExposureRows);
        float place = exposurePlace(texelFetch(radiance, ivec2(at * vec2(size)), 0).rgb);
        if (place < 0.0) continue;
        atomicAdd(counts[uint(place)], 1u);
        atomicAdd(fractions[uint(place)], uint(fract(place) * kExposureFine));
    }
    barrier();
    if (thread != 0u) return;

    float all = 0.0;
    for (uint bin = 0u; bin < kExposureBins; ++bin) all += float(counts[bin]);
    float before = 0.0, taken = 0.0, sum = 0.0;
    for (uint bin = 0u; bin < kExposureBins; ++bin) {
        float count = float(counts[bin]);
        float share = exposureTaken(before, count, kExposureTrimmed * all, (1.0 - kExposureTrimmed) * all);
        before += count;
        taken += share;
        if (share > 0.0) sum += share * (float(bin) + float(fractions[bin]) / (kExposureFine * count));
    }
    float now = exposureFromMean(taken > 0.0 ? sum / taken : 0.0, taken);
    if (kAdapts) now = adaptedExposure(texelFetch(last, ivec2(0), 0).r, now, push.adapt);
    imageStore(exposure, ivec2(0), vec4(now));
}
