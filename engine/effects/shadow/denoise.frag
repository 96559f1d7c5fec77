#version 460
// The shares of four lights, of which each ray of few knew a part: by what their neighbours on the same surface say, as far as that is noise.
#include "engine/effects/depth_apart.h"
#include "engine/effects/local_fit.h"
#include "engine/effects/shadow/shadow.h"
#include "engine/effects/slope.glsl"

layout(push_constant, scalar) uniform Push { ShadowDenoise push; };
layout(set = 1, binding = 0) uniform sampler2D depthTexture;
layout(set = 1, binding = 1) uniform sampler2D sharesTexture;
layout(set = 1, binding = 2) uniform sampler2D noiseTexture;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 reaches;

ivec2 last;
float depthAt(ivec2 pixel) { return texelFetch(depthTexture, clamp(pixel, ivec2(0), last), 0).r; }

float slopeAlong(ivec2 axis, ivec2 pixel, float depth)
{
    return slopeOf(depthAt(pixel - axis), depth, depthAt(pixel + axis), pixel != max(pixel, axis), pixel + axis != min(pixel + axis, last));
}

// Variance of the shares around the pixel, by nine of its neighbours.
vec4 noiseAround(ivec2 pixel)
{
    vec4 sum = vec4(0.0);
    for (int y = -kFitReach; y <= kFitReach; y += kFitReach)
        for (int x = -kFitReach; x <= kFitReach; x += kFitReach) {
            vec4 twice = texelFetch(noiseTexture, clamp(pixel + ivec2(x, y), ivec2(0), last), 0);
            sum += twice * twice;
        }
    return sum * (0.25 / 9.0);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    last = textureSize(sharesTexture, 0) - 1;
    reaches = texelFetch(sharesTexture, pixel, 0);
    vec4 noise = noiseAround(pixel) * kStratified;
    float depth = depthAt(pixel);
    if (noise == vec4(0.0) || !(depth > 0.0)) return;
    vec2 slope = vec2(slopeAlong(ivec2(1, 0), pixel, depth), slopeAlong(ivec2(0, 1), pixel, depth));
    float apart = push.pixel * (push.metres.x > 0.0 ? push.metres.x / depth : 1.0);
    LocalFit fit = emptyFit();
    for (int y = -kFitReach; y <= kFitReach; ++y)
        for (int x = -kFitReach; x <= kFitReach; ++x) {
            ivec2 at = pixel + ivec2(x, y);
            if (at != clamp(at, ivec2(0), last)) continue;
            float there = texelFetch(depthTexture, at, 0).r;
            if (!(there > 0.0) || depthApart(there, depth + dot(slope, vec2(x, y)), push.metres) > apart) continue;
            addTo(fit, fitWeight(x, y), vec2(x, y), texelFetch(sharesTexture, at, 0) - reaches);
        }
    reaches = clamp(reaches + fitted(fit, noise, push.frames), 0.0, 1.0);
}
