#version 460
// One level down: each pixel gathers its share of the finer level's light.
#include "engine/effects/bloom/bloom.h"

layout(constant_id = kBloomUneven) const bool kUneven = false;
layout(constant_id = kBloomFirst) const bool kFirst = false;
const int kTaps = kUneven ? 5 : 4;

layout(set = 1, binding = 0) uniform sampler2D fineTexture;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 light;

// Of the k-th tap in a coarse pixel, along one axis. The weights of an even axis hold at its borders too, where the outer tap is clamped.
float shareOf(int k, int fine, int coarse, int n, int m)
{
    if (!kUneven) return k == 0 || k == 3 ? 0.125 : 0.375;
    return fine >= 0 && fine < n ? bloomShare(fine, coarse, n, m) / float(n) : 0.0;
}

void main()
{
    ivec2 n = textureSize(fineTexture, 0), m = (n + 1) / 2;
    ivec2 coarse = ivec2(gl_FragCoord.xy);
    ivec2 first = coarse * 2 - 1;
    if (kUneven) first = ivec2(bloomFirstFine(coarse.x, n.x, m.x), bloomFirstFine(coarse.y, n.y, m.y));
    vec3 sum = vec3(0.0);
    for (int y = 0; y < kTaps; ++y) {
        vec3 row = vec3(0.0);
        for (int x = 0; x < kTaps; ++x) {
            ivec2 at = first + ivec2(x, y);
            vec3 texel = texelFetch(fineTexture, clamp(at, ivec2(0), n - 1), 0).rgb;
            row += shareOf(x, at.x, coarse.x, n.x, m.x) * (kFirst ? bloomInput(texel) : texel);
        }
        sum += row * shareOf(y, first.y + y, coarse.y, n.y, m.y);
    }
    light = vec4(sum, 1.0);
}
