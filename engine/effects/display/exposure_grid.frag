#version 460
// Brightness of one block of the picture: 4 x 4 points of it, log luminance and how many counted.
#include "engine/effects/display/display.h"

layout(set = 1, binding = 0) uniform sampler2D radiance;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec2 sum;

void main()
{
    sum = vec2(0.0);
    vec2 block = 1.0 / vec2(kExposureWidth, kExposureHeight);
    ivec2 size = textureSize(radiance, 0);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            vec2 at = uv + (vec2(x, y) - 1.5) * 0.25 * block;
            sum += exposureSample(texelFetch(radiance, clamp(ivec2(at * vec2(size)), ivec2(0), size - 1), 0).rgb);
        }
}
