#include "engine/upload/split_sum.hpp"
#include "shaders/fresnel.h"
#include "shaders/gpu_baked.h"
#include "shaders/microfacet.h"
#include <vector>

namespace afterglow
{
using namespace shared;

vec2 splitSum(float mu, float roughness)
{
    const vec2 alpha = max(roughnessToAlpha(roughness, 0.0f), vec2(kMirrorAlpha));
    const float z = max(mu, 1e-4f);
    const vec3 o(sqrt(1.0f - z * z), 0.0f, z);
    const int count = 1024;
    float energy = 0.0f, bias = 0.0f;
    for (int k = 0; k < count; ++k) {
        // Roberts' R2 sequence: powers of 1/p and 1/p^2, p the plastic number
        const vec2 u(float(fract(0.5 + k * 0.7548776662466927)), float(fract(0.5 + k * 0.5698402909980532)));
        const vec3 h = sampleGgxVisible(o, alpha, u);
        const vec3 i = 2.0f * dot(o, h) * h - o;
        if (!(i.z > 0.0f)) continue;
        const float weight = ggxG2(o, i, alpha) / ggxG1(o, alpha); // value * cosine / pdf, without Fresnel
        energy += weight;
        bias += weight * schlickWeight(dot(o, h));
    }
    return vec2(energy - bias, bias) / float(count);
}

GpuImage uploadSplitSum(Gpu& gpu)
{
    std::vector<u16vec2> texels;
    for (int y = 0; y < kSplitSumSize; ++y)
        for (int x = 0; x < kSplitSumSize; ++x) {
            const vec2 value = splitSum(float(x) / (kSplitSumSize - 1), float(y) / (kSplitSumSize - 1));
            texels.emplace_back(packHalf1x16(value.x), packHalf1x16(value.y));
        }
    GpuImage image = gpu.memory.image("split sum", {.format = VK_FORMAT_R16G16_SFLOAT, .size = {kSplitSumSize, kSplitSumSize, 1}});
    gpu.memory.upload(image, texels.data(), texels.size() * sizeof(texels[0]));
    return image;
}
}
