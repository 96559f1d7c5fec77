#version 460
// One level down: each pixel gathers its share of the finer level's light.
#include "engine/effects/bloom/bloom.h"

layout(constant_id = kBloomUneven) const bool kUneven = false;
layout(constant_id = kBloomFirst) const bool kFirst = false;
const int kTaps = kUneven ? 5 : 4;

layout(set = 1, binding = 0) uniform sampler2D fineTexture;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 light;

void main()
{
    ivec2 n = textureSize(fineTexture, 0), m = (n + 1) / 2;
    ivec2 coarse = ivec2(gl_FragCoord.xy);
    ivec2 first = ivec2(bloomFirstFine(coarse.x, n.x, m.x), bloomFirstFine(coarse.y, n.y, m.y));
    vec3 sum = vec3(0.0);
    for (int y = 0; y < kTaps; ++y) {
        vec3 row = vec3(0.0);
        for (int x = 0; x < kTaps; ++x) {
            ivec2 at = first + ivec2(x, y);
            vec3 texel = texelFetch(fineTexture, clamp(at, ivec2(0), n - 1), 0).rgb;
            float share = at.x >= 0 && at.x < n.x ? bloomShare(at.x, coarse.x, n.x, m.x) : 0.0;
            row += share * (kFirst ? bloomInput(texel) : texel);
        }
        int fine = first.y + y;
        sum += row * (fine >= 0 && fine < n.y ? bloomShare(fine, coarse.y, n.y, m.y) : 0.0);
    }
    light = vec4(sum / (float(n.x) * float(n.y)), 1.0);
}
