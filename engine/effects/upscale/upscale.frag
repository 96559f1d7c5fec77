#version 460
// The cubic through 4 x 4 samples, held within the range of the four around the point: an edge stays sharp and gets no halo.
#include "engine/effects/upscale/upscale.h"

layout(push_constant, scalar) uniform Push { UpscalePush push; };
layout(set = 1, binding = 0) uniform sampler2D imageTexture;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 upscaled;

void main()
{
    ivec2 size = textureSize(imageTexture, 0);
    vec2 at = uv * vec2(size) - push.jitter - 0.5;
    ivec2 corner = ivec2(floor(at));
    vec4 wx = cubicWeights(at.x - float(corner.x)), wy = cubicWeights(at.y - float(corner.y));
    vec4 sum = vec4(0.0), least = vec4(0.0), most = vec4(0.0);
    for (int y = 0; y < 4; ++y) {
        vec4 row = vec4(0.0);
        for (int x = 0; x < 4; ++x) {
            vec4 texel = texelFetch(imageTexture, clamp(corner + ivec2(x, y) - 1, ivec2(0), size - 1), 0);
            row += wx[x] * texel;
            bool around = (x == 1 || x == 2) && (y == 1 || y == 2), first = x == 1 && y == 1;
            if (first) least = most = texel;
            if (around) {
                least = min(least, texel);
                most = max(most, texel);
            }
        }
        sum += wy[y] * row;
    }
    upscaled = clamp(sum, least, most);
}
