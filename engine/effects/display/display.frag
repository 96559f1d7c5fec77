#version 460
// Exposure, tone curve, sRGB.
#include "engine/effects/display/display.h"

layout(push_constant, scalar) uniform Push { DisplayPush push; };
layout(set = 1, binding = 0) uniform sampler2D radiance;
layout(set = 1, binding = 1) uniform sampler2D measured;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

void main()
{
    float exposure = push.exposure > 0.0 ? push.exposure : texelFetch(measured, ivec2(0), 0).r;
    vec3 exposed = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb * exposure;
    color = vec4(srgbEncode(toneMap(exposed, push.curve)), 1.0);
}
