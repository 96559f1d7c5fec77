#version 460
// Visibility by few rays: what its neighbours on the same surface say, as far as it is noise that tells it from them.
#include "engine/effects/local_fit.h"
#include "engine/effects/occlusion/plane.glsl"

layout(push_constant, scalar) uniform Push { OcclusionDenoise push; };
layout(set = 1, binding = 0, scalar) uniform Occlusion { OcclusionFrame frame; };
layout(set = 1, binding = 1) uniform sampler2D seenTexture;
layout(set = 1, binding = 2) uniform sampler2D noiseTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 smoothed;

// Variance around the pixel, by nine of its neighbours.
float noiseAround(ivec2 here, ivec2 last)
{
    float sum = 0.0;
    for (int y = -kFitReach; y <= kFitReach; y += kFitReach)
        for (int x = -kFitReach; x <= kFitReach; x += kFitReach) sum += texelFetch(noiseTexture, clamp(here + ivec2(x, y), ivec2(0), last), 0).r;
    return sum / 9.0;
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(seenTexture, 0) - 1;
    smoothed = texelFetch(seenTexture, here, 0);
    float noise = noiseAround(here, last);
    if (!(smoothed.y > 0.0) || noise == 0.0) return;
    LocalFit fit = emptyFit();
    for (int y = -kFitReach; y <= kFitReach; ++y)
        for (int x = -kFitReach; x <= kFitReach; ++x) {
            ivec2 at = here + ivec2(x, y);
            if (at != clamp(at, ivec2(0), last)) continue;
            vec4 other = texelFetch(seenTexture, at, 0);
            if (!(other.y > 0.0)) continue;
            float weight = fitWeight(x, y) * onPlane(smoothed, vec2(ivec2(x, y) * int(frame.p.divisor)), other.y, frame);
            addTo(fit, weight, vec2(x, y), vec4(other.x - smoothed.x, vec3(0.0)));
        }
    smoothed.x = clamp(smoothed.x + fitted(fit, vec4(noise, vec3(0.0)), push.frames).x, 0.0, 1.0);
}
