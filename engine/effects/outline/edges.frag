#version 460
// How much of a pixel a line covers, if its spine can be seen there: asked of the whole width alike, or a surface that bulges before its
// own silhouette would eat half of the line.
// This work is based on: Cole, Finkelstein 2010, "Two fast methods for high-quality line visibility".
#include "engine/effects/outline/outline.h"
#include "engine/effects/view_ray.h"
#include "shaders/media.glsl"

layout(set = 1, binding = 0, scalar) readonly buffer Outline { OutlineFrame frame; };
layout(set = 1, binding = 2) uniform sampler2D depthTexture;

layout(location = 0) flat in vec4 segment;
layout(location = 1) flat in vec2 depths;
layout(location = 0) out float covered;

// What the air leaves of the line, on average over the colours.
float clearness(vec2 spine, float depth)
{
    if (frame.media == 0u) return 1.0;
    ViewRay ray = viewRay(spine / vec2(frame.size), depth, frame.clipToWorld, frame.eye);
    return dot(mediaTransmittance(Air(frame.media), ray.origin, ray.direction, ray.distance), vec3(1.0 / 3.0));
}

void main()
{
    vec2 along = segment.zw - segment.xy, from = gl_FragCoord.xy - segment.xy;
    float reach = dot(along, along);
    float t = reach > 1e-12 ? clamp(dot(from, along) / reach, 0.0, 1.0) : 0.0;
    vec2 spine = segment.xy + t * along;
    float coverage = lineCoverage(distance(gl_FragCoord.xy, spine), frame.width);
    if (!(coverage > 0.0)) discard;

    ivec2 middle = ivec2(floor(spine));
    float farthest = 1.0, nearest = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            float drawn = texelFetch(depthTexture, clamp(middle + ivec2(x, y), ivec2(0), frame.size - 1), 0).r;
            farthest = min(farthest, drawn);
            nearest = max(nearest, drawn);
        }
    float depth = mix(depths.x, depths.y, t);
    if (!lineIsSeen(depth, farthest, nearest, frame.steepest)) discard;
    covered = coverage * clearness(spine, depth);
}
