#version 460
// Two pictures of one size in one, on either side of a line.
#include "engine/effects/truth/truth.h"

layout(push_constant, scalar) uniform Push { WipePush push; };
layout(set = 1, binding = 0) uniform sampler2D left;
layout(set = 1, binding = 1) uniform sampler2D right;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (abs(gl_FragCoord.x - push.line) < 0.5 * kWipeLine)
        color = vec4(0.0, 0.0, 0.0, 1.0);
    else
        color = vec4(gl_FragCoord.x < push.line ? texelFetch(left, pixel, 0).rgb : texelFetch(right, pixel, 0).rgb, 1.0);
}
