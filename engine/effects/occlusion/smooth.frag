#version 460
// The mean of 4 x 4 neighbours, each turned another way, as far as they lie on one surface.
#include "engine/effects/occlusion/plane.glsl"

layout(set = 1, binding = 0, scalar) uniform Occlusion { OcclusionFrame frame; };
layout(set = 1, binding = 1) uniform sampler2D seenTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 smoothed;

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(seenTexture, 0) - 1;
    smoothed = texelFetch(seenTexture, here, 0);
    if (!(smoothed.y > 0.0)) return;
    vec2 sum = vec2(0.0);
    for (int y = -2; y < 2; ++y)
        for (int x = -2; x < 2; ++x) {
            ivec2 at = here + ivec2(x, y);
            if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
            vec4 other = texelFetch(seenTexture, at, 0);
            if (!(other.y > 0.0)) continue;
            float weight = onPlane(smoothed, vec2(ivec2(x, y) * int(frame.p.divisor)), other.y, frame);
            sum += weight * vec2(other.x, 1.0);
        }
    smoothed.x = sum.y > 0.0 ? sum.x / sum.y : smoothed.x;
}
