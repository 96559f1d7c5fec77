#version 460
// Visibility by few rays: what its neighbours on the same surface say, as far as it is noise that tells it from them.
#include "engine/effects/local_fit.glsl"
#include "engine/effects/occlusion/plane.glsl"

layout(push_constant, scalar) uniform Push { OcclusionDenoise push; };
layout(set = 1, binding = 0, scalar) uniform Occlusion { OcclusionFrame frame; };
layout(set = 1, binding = 1) uniform sampler2D seenTexture;
layout(set = 1, binding = 2) uniform sampler2D noiseTexture;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 smoothed;

float speaksFor(ivec2 at, ivec2 away, vec4 other)
{
    return other.y > 0.0 ? onPlane(smoothed, vec2(away * int(frame.p.divisor)), other.y, frame) : 0.0;
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    smoothed = texelFetch(seenTexture, here, 0);
    float noise = noiseAround(noiseTexture, here).x;
    if (!(smoothed.y > 0.0) || noise == 0.0) return;
    LocalFit fit = fitAround(seenTexture, here, smoothed);
    smoothed.x = clamp(smoothed.x + fitted(fit, vec4(noise, vec3(0.0)), push.frames).x, 0.0, 1.0);
}
