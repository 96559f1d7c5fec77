// What the rays around a pixel met, as the pixel's own ray would. Rays are traced for every `divisor`-th pixel.
// The includer declares, before this line: reflection, depthTexture, tracedTexture, kRays.
#ifndef AFTERGLOW_NEIGHBOURS_GLSL
#define AFTERGLOW_NEIGHBOURS_GLSL
#include "shaders/camera.h"

struct Met {
    float distance_; // m along the mirrored ray
    float share;     // 0: the picture does not know
    float sharp;     // the same for this pixel's own ray, without a share of its neighbours'
    float bend;      // radians that the normal turns by from pixel to pixel
};

// How far the depth of the place at which a ray would end differs from what the picture shows there, as a share of the distance to the eye.
float misfit(vec3 end)
{
    vec4 clip = reflection.worldToClip * vec4(end, 1.0);
    vec2 at = ndcToUv(clip.xy / max(clip.w, 1e-9));
    if (!(clip.w > 0.0) || at != clamp(at, 0.0, 1.0)) return 1.0;
    vec2 corner = floor(at * vec2(reflection.size) - 0.5), f = at * vec2(reflection.size) - 0.5 - corner;
    ivec2 a = max(ivec2(corner), ivec2(0)), b = min(ivec2(corner) + 1, reflection.size - 1);
    vec2 above = vec2(texelFetch(depthTexture, a, 0).r, texelFetch(depthTexture, ivec2(b.x, a.y), 0).r);
    vec2 below = vec2(texelFetch(depthTexture, ivec2(a.x, b.y), 0).r, texelFetch(depthTexture, b, 0).r);
    // Between the pixels on a slope, on the nearest of them at an edge
    vec2 row = mix(above, below, f.y), nearest = f.y < 0.5 ? above : below;
    vec2 depths = vec2(mix(row.x, row.y, f.x), f.x < 0.5 ? nearest.x : nearest.y);
    vec2 apart = abs(depths * clip.w / max(clip.z, 1e-9) - 1.0);
    return min(apart.x, apart.y);
}

// Four neighbours by how near they are and whether they lie on the same surface. Across an edge of what is met their distances do not mix:
// of their mean and of each, that one counts at which this pixel's own ray ends on what the picture shows there.
Met metAround(ivec2 pixel, float depth, vec3 normal, vec3 position, vec3 direction)
{
    const float kFits = 0.01;     // of the distance to the eye
    const float kAlike = 0.05;    // of a distance
    const float kFarAway = kRays ? 0.0 : 0.001; // the weight of a neighbour that only counts where no nearer one lies on the same surface
    vec2 at = vec2(pixel) / float(reflection.divisor);
    ivec2 corner = ivec2(floor(at)), last = textureSize(tracedTexture, 0) - 1;
    vec2 f = at - vec2(corner);
    float weights[4], distances[4], shares[4];
    float sum = 0.0, sharp = 0.0, bend = 0.0, bends = 0.0, nearest = kFloatMax, farthest = 0.0, least = 1.0;
    Met met = Met(0.0, 0.0, 0.0, 0.0);
    for (int k = 0; k < 4; ++k) {
        uvec4 texel = texelFetch(tracedTexture, min(corner + ivec2(k & 1, k >> 1), last), 0);
        float apart = abs(uintBitsToFloat(texel.z) - depth) / max(depth, 1e-9);
        vec3 there = octahedralDecode(unpackUnorm2x16(texel.w));
        float aligned = max(dot(there, normal), 0.0);
        aligned *= aligned;
        vec2 across = mix(1.0 - f, f, vec2(k & 1, k >> 1));
        float alike = aligned * aligned / (1e-3 + apart * apart), weight = (across.x * across.y + kFarAway) * alike;
        sum += weight;
        bends += alike;
        bend += alike * length(there - normal);
        distances[k] = uintBitsToFloat(texel.x);
        shares[k] = uintBitsToFloat(texel.y);
        weights[k] = weight * shares[k];
        met.share += weights[k];
        met.distance_ += weights[k] * distances[k];
        sharp += weights[k] * shares[k];
        if (!(across.x * across.y > 0.0)) continue;
        least = min(least, shares[k]);
        if (!(weights[k] > 0.0)) continue;
        nearest = min(nearest, distances[k]);
        farthest = max(farthest, distances[k]);
    }
    if (!(met.share > 0.0)) return met;
    met.distance_ /= met.share;
    sharp /= met.share; // of those that met anything
    met.share /= sum;
    met.sharp = met.share;
    met.bend = bend / (bends * float(reflection.divisor)); // their mean distance is one ray, within a fifth
    bool missed = least < 0.5 * met.share;
    if (farthest <= (1.0 + kAlike) * nearest && !missed) return met;

    met.sharp = sharp;
    float best = misfit(position + direction * met.distance_);
    for (int k = 0; k < 4; ++k) {
        if (!(weights[k] > 0.0)) continue;
        float miss = misfit(position + direction * distances[k]);
        if (miss < best) {
            best = miss;
            met.distance_ = distances[k];
            met.sharp = shares[k];
        }
    }
    if (missed) met.sharp *= clamp(2.0 - best / kFits, 0.0, 1.0);
    return met;
}

#endif
