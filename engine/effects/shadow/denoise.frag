#version 460
// The shares of four lights, of which each ray of few knew a part: by what their neighbours on the same surface say, as far as that is
// noise.
#include "engine/effects/depth_apart.h"
#include "engine/effects/local_fit.glsl"
#include "engine/effects/shadow/shadow.h"
#include "engine/effects/slope.glsl"

layout(push_constant, scalar) uniform Push { ShadowDenoise push; };
layout(set = 1, binding = 0) uniform sampler2D depthTexture;
layout(set = 1, binding = 1) uniform sampler2D sharesTexture;
layout(set = 1, binding = 2) uniform sampler2D noiseTexture;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 reaches;

ivec2 last;
float depth, apart; // of the pixel; m: how far off its plane a neighbour may lie
vec2 slope;
float depthAt(ivec2 pixel) { return texelFetch(depthTexture, clamp(pixel, ivec2(0), last), 0).r; }

float slopeAlong(ivec2 axis, ivec2 pixel)
{
    return slopeOf(depthAt(pixel - axis), depth, depthAt(pixel + axis), pixel != max(pixel, axis), pixel + axis != min(pixel + axis, last));
}

float speaksFor(ivec2 at, ivec2 away, vec4 shares)
{
    float there = texelFetch(depthTexture, at, 0).r;
    return there > 0.0 && depthApart(there, depth + dot(slope, vec2(away)), push.metres) <= apart ? 1.0 : 0.0;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    last = textureSize(sharesTexture, 0) - 1;
    reaches = texelFetch(sharesTexture, pixel, 0);
    vec4 noise = noiseAround(noiseTexture, pixel) * kStratified;
    depth = depthAt(pixel);
    if (noise == vec4(0.0) || !(depth > 0.0)) return;
    slope = vec2(slopeAlong(ivec2(1, 0), pixel), slopeAlong(ivec2(0, 1), pixel));
    apart = push.pixel * (push.metres.x > 0.0 ? push.metres.x / depth : 1.0);
    reaches = clamp(reaches + fitted(fitAround(sharesTexture, pixel, reaches), noise, push.frames), 0.0, 1.0);
}
