#version 460
// One level up: a level's own light, and a share of what the coarser one has spread.
#include "engine/effects/bloom/bloom.h"

layout(constant_id = kBloomUneven) const bool kUneven = false;
layout(constant_id = kBloomFirst) const bool kFirst = false;
const int kTaps = kUneven ? 3 : 2;

layout(push_constant, scalar) uniform Push { BloomPush push; };
layout(set = 1, binding = 0) uniform sampler2D fineTexture;
layout(set = 1, binding = 1) uniform sampler2D coarseTexture;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 light;

// Of the k-th tap in a fine pixel, along one axis; as on the way down.
float shareOf(int k, int fine, int coarse, int n, int m)
{
    if (!kUneven) return (fine & 1) == k ? 0.25 : 0.75;
    return bloomShare(fine, coarse, n, m) / float(m);
}

void main()
{
    ivec2 n = textureSize(fineTexture, 0), m = textureSize(coarseTexture, 0);
    ivec2 fine = ivec2(gl_FragCoord.xy);
    ivec2 first = ((fine + 1) >> 1) - 1; // spares the even axes a division by what only a dispatch knows
    if (kUneven) first = ivec2(bloomFirstCoarse(fine.x, n.x, m.x), bloomFirstCoarse(fine.y, n.y, m.y));
    vec3 sum = vec3(0.0);
    for (int y = 0; y < kTaps; ++y) {
        vec3 row = vec3(0.0);
        for (int x = 0; x < kTaps; ++x) {
            ivec2 at = first + ivec2(x, y);
            row += shareOf(x, fine.x, at.x, n.x, m.x) * texelFetch(coarseTexture, clamp(at, ivec2(0), m - 1), 0).rgb;
        }
        sum += row * shareOf(y, fine.y, first.y + y, n.y, m.y);
    }
    vec4 own = texelFetch(fineTexture, fine, 0);
    if (kFirst) own.rgb = bloomInput(own.rgb);
    light = vec4(mix(own.rgb, sum, push.share), own.a);
}
