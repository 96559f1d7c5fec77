// This work is based on: Dammertz et al. 2010 (edge-avoiding a-trous wavelets), Schied et al. 2017 (variance guidance, their eq. 3 to 5).
#include "baker/denoise.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/color.h"
#include "shaders/lightmap.h"
#include <cmath>

namespace afterglow
{
static constexpr int kLevels = 5;            // reach of the last: 2 * 2^4 texels
static constexpr float kNormalPower = 64.0f; // cos^64: half weight at 8 degrees
static constexpr float kLightSigmas = 3.0f;  // differences of more than about three standard errors are light, not noise
static constexpr float kSightHeight = 0.25f; // texels above the surface
static constexpr float kKernel[3] = {3.0f / 8.0f, 1.0f / 4.0f, 1.0f / 16.0f}; // B3 spline

struct Page {
    const Lightmap& lightmap;
    const TexelGuides& guides;
    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(lightmap.width) + std::size_t(x); }
    bool baked(int x, int y) const
    {
        return x >= 0 && y >= 0 && x < lightmap.width && y < lightmap.height && lightmap.valid[at(x, y)] == 1;
    }
};

// Edge of a texel in the world, from its baked neighbours; 0 when it has none.
static float texelSize(const Page& page, int x, int y)
{
    float smallest = kFloatMax;
    for (ivec2 d : {ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1)})
        if (page.baked(x + d.x, y + d.y))
            smallest = min(smallest, distance(page.guides.position[page.at(x, y)], page.guides.position[page.at(x + d.x, y + d.y)]));
    return smallest < kFloatMax ? smallest : 0.0f;
}

// Variance smoothed over 3x3: a single texel's own is as noisy as its value.
static float steadyVariance(const Page& page, const std::vector<float>& variance, int x, int y)
{
    float sum = 0.0f, weights = 0.0f;
    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++) {
            if (!page.baked(x + i, y + j)) continue;
            float weight = (i == 0 ? 0.5f : 0.25f) * (j == 0 ? 0.5f : 0.25f);
            sum += weight * variance[page.at(x + i, y + j)];
            weights += weight;
        }
    return weights > 0.0f ? sum / weights : 0.0f;
}

std::uint64_t denoiseRows(const Lightmap& lightmap) { return std::uint64_t(kLevels) * std::uint64_t(lightmap.height); }

void denoise(Lightmap& lightmap, const TexelGuides& guides, const Sight& sight, int threads, const Advance& advance)
{
    Page page{lightmap, guides};
    std::vector<float> variance = guides.variance, nextVariance(variance.size());
    std::vector<vec3> next(lightmap.texels.size());
    std::vector<vec4> nextDirection = lightmap.direction;
    for (int level = 0; level < kLevels; level++) {
        int step = 1 << level;
        parallelFor(std::size_t(lightmap.height), threads, [&](std::size_t row) {
            int y = int(row);
            for (int x = 0; x < lightmap.width; x++) {
                std::size_t here = page.at(x, y);
                next[here] = lightmap.texels[here];
                nextVariance[here] = variance[here];
                if (!nextDirection.empty()) nextDirection[here] = lightmap.direction[here];
                if (!page.baked(x, y)) continue;
                float size = texelSize(page, x, y);
                float tolerance = kLightSigmas * std::sqrt(steadyVariance(page, variance, x, y));
                float mine = luminance(lightmap.texels[here]);
                vec3 sum(0.0f), turn(0.0f); // of directions, each as bright as it is
                float weights = 0.0f, squares = 0.0f;
                for (int j = -2; j <= 2; j++)
                    for (int i = -2; i <= 2; i++) {
                        if (!page.baked(x + i * step, y + j * step)) continue;
                        std::size_t there = page.at(x + i * step, y + j * step);
                        vec3 offset = guides.position[there] - guides.position[here];
                        float apart = float(step) * std::sqrt(float(i * i + j * j)) * size;
                        if (length(offset) > 1.5f * apart) continue; // another chart: near in the page, far in the world
                        if ((lightmap.texels[there] == vec3(0.0f)) != (lightmap.texels[here] == vec3(0.0f)) &&
                            !sight(guides.position[here], guides.position[there], kSightHeight * size * guides.normal[here]))
                            continue; // no light has come to one of them, and a wall stands between
                        float plane = abs(dot(offset, guides.normal[here])) / max(size, 1e-12f);
                        float facing = max(dot(guides.normal[here], guides.normal[there]), 0.0f);
                        float light = abs(luminance(lightmap.texels[there]) - mine) / (tolerance + 1e-12f);
                        float weight = kKernel[abs(i)] * kKernel[abs(j)] * std::pow(facing, kNormalPower) * std::exp(-plane - light);
                        if (i == 0 && j == 0) weight = kKernel[0] * kKernel[0];
                        sum += weight * lightmap.texels[there];
                        if (!nextDirection.empty())
                            turn += weight * luminance(lightmap.texels[there]) * vec3(lightmap.direction[there]);
                        squares += weight * weight * variance[there];
                        weights += weight;
                    }
                next[here] = sum / weights;
                if (!nextDirection.empty() && luminance(sum) > 0.0f)
                    nextDirection[here] = directionAbout(turn / luminance(sum), guides.normal[here]);
                nextVariance[here] = squares / (weights * weights);
            }
            advance(1);
        });
        lightmap.texels.swap(next);
        lightmap.direction.swap(nextDirection);
        variance.swap(nextVariance);
    }
}
}
