#version 460
// Surfaces in the colours of what lights them; grey below coloured spheres.
#include "engine/effects/indirect.glsl"
#include "engine/effects/probe_view/probe_view.h"
#include "engine/effects/view_ray.h"

layout(set = 1, binding = 0, scalar) readonly buffer Shown { ProbeViewFrame frame; };
layout(set = 1, binding = 1) uniform usampler2D surfaceTexture;
layout(set = 1, binding = 2) uniform sampler2D depthTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

const vec3 kGrey = vec3(0.25); // where no probe has a say

vec3 influenceAt(vec3 position)
{
    vec4 sum = vec4(0.0);
    float covered = 0.0;
    for (uint i = 0u; i < frame.reflections; ++i) {
        vec2 influence = reflectionInfluence(reflectionBoxes[i], position);
        sum += influence.y * vec4(colorOfNumber(i), 1.0);
        covered = max(covered, influence.x);
    }
    return sum.w > 0.0 ? mix(kGrey, sum.rgb / sum.w, covered) : kGrey;
}

float largestWeightAt(uint cell, vec3 position)
{
    vec3 fraction = probeFraction(probeCellAt(ProbeSet(1u), cell), position), most = max(fraction, 1.0 - fraction);
    return most.x * most.y * most.z;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthTexture, pixel, 0).r;
    vec3 position = worldFromDepth(uv, depth > 0.0 ? depth : 1.0, frame.clipToWorld);
    vec3 across = dFdx(position), down = dFdy(position);
    vec2 step_ = vec2(dFdx(uv.x), dFdy(uv.y));
    color = vec4(0.0);
    if (!(depth > 0.0)) return;
    GBufferTexel t = decodeGBuffer(texelFetch(surfaceTexture, pixel, 0));
    vec3 toEye = directionToEye(position, frame.eye), face = faceNormal(across, down, t.normal, toEye);
    // The place that lighting asks for
    vec3 at = leaving(position, cornerRounding(position, uv, step_, depth, frame.clipToWorld), towardEye(t.normal, face, toEye));
    vec3 shown = kGrey;
    if (frame.shown == kShowInfluence) {
        shown = influenceAt(position);
    } else if (frame.shown != kShowValidity) {
        uint cell = probeCellNumber(ProbeSet(1u), at);
        shown = frame.shown == kShowCells ? colorOfNumber(cell) : heatColor((largestWeightAt(cell, at) - 0.125) / 0.875);
    }
    color = vec4(shown * formOf(clamp(dot(face, toEye), 0.0, 1.0)), 1.0);
}
