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
// Differences beyond about three standard errors are light, not noise. Relative RMSE at 16, 64, 256 paths against 8192, Cornell box and still
// life: no filter 15.8, 7.6, 4.0 and 5.1, 2.6, 1.33 %; two of them 13.2, 7.1, 4.0 and 4.8, 2.5, 1.31; three 12.3, 6.8, 4.0 and 4.8, 2.5, 1.32;
// four 12.2, 6.8, 4.0 and 4.8, 2.5, 1.33.
static constexpr float kLightSigmas = 3.0f;
static constexpr float kSightHeight = 0.25f;                                  // texels above the surface
static constexpr float kKernel[3] = {3.0f / 8.0f, 1.0f / 4.0f, 1.0f / 16.0f}; // B3 spline

struct Page {
    const Lightmap& lightmap;
    const TexelGuides& guides;
    const Islands islands;
    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(lightmap.width) + std::size_t(x); }
    bool baked(int x, int y) const
    {
        return x >= 0 && y >= 0 && x < lightmap.width && y < lightmap.height && lightmap.valid[at(x, y)] == 1;
    }
};

Islands islandsOf(const Lightmap& lightmap)
{
    Islands islands{std::vector<int>(lightmap.valid.size(), 0)};
    const ivec2 size(lightmap.width, lightmap.height);
    std::vector<ivec2> open;
    for (int start = 0; start < size.x * size.y; start++) {
        if (lightmap.valid[std::size_t(start)] != 1 || islands.of[std::size_t(start)] != 0) continue;
        islands.of[std::size_t(start)] = ++islands.count;
        open.assign(1, ivec2(start % size.x, start / size.x));
        while (!open.empty()) {
            const ivec2 at = open.back();
            open.pop_back();
            for (int step = 0; step < 9; step++) {
                const ivec2 to = at + ivec2(step % 3, step / 3) - 1;
                if (to != clamp(to, ivec2(0), size - 1)) continue;
                const std::size_t texel = std::size_t(to.y * size.x + to.x);
                if (lightmap.valid[texel] != 1 || islands.of[texel] != 0) continue;
                islands.of[texel] = islands.count;
                open.push_back(to);
            }
        }
    }
    return islands;
}

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

std::uint64_t denoiseRows(int height) { return std::uint64_t(kLevels) * std::uint64_t(height); }

// How alike two texels are: 1 of one surface and one light, 0 of strangers. The same both ways round.
static float likeness(const Page& page, std::size_t here, std::size_t there, float size, float tolerance)
{
    const TexelGuides& guides = page.guides;
    if (page.islands.of[here] != page.islands.of[there]) return 0.0f; // another chart, however near
    const vec3 offset = guides.position[there] - guides.position[here];
    const float plane = max(abs(dot(offset, guides.normal[here])), abs(dot(offset, guides.normal[there]))) / max(size, 1e-12f);
    const float facing = max(dot(guides.normal[here], guides.normal[there]), 0.0f);
    const float light = abs(luminance(page.lightmap.texels[there]) - luminance(page.lightmap.texels[here])) / (tolerance + 1e-12f);
    return std::pow(facing, kNormalPower) * std::exp(-plane - light * light);
}

void denoise(Lightmap& lightmap, const TexelGuides& guides, const Sight& sight, int threads, const Advance& advance)
{
    const Page page{lightmap, guides, islandsOf(lightmap)};
    const std::size_t count = lightmap.texels.size();
    std::vector<float> sizes(count), variance = guides.variance, steady(count), nextVariance(count);
    std::vector<vec3> next(count);
    std::vector<vec4> nextDirection = lightmap.direction;
    const auto everyBakedTexel = [&](auto&& of) {
        parallelFor(std::size_t(lightmap.height), threads, [&](std::size_t y) {
            for (int x = 0; x < lightmap.width; x++)
                if (page.baked(x, int(y))) of(x, int(y), page.at(x, int(y)));
        });
    };
    everyBakedTexel([&](int x, int y, std::size_t here) { sizes[here] = texelSize(page, x, y); });
    for (int level = 0; level < kLevels; level++) {
        const int step = 1 << level;
        next = lightmap.texels, nextVariance = variance, nextDirection = lightmap.direction;
        everyBakedTexel([&](int x, int y, std::size_t here) { steady[here] = steadyVariance(page, variance, x, y); });
        parallelFor(std::size_t(lightmap.height), threads, [&](std::size_t row) {
            const int y = int(row);
            for (int x = 0; x < lightmap.width; x++) {
                if (!page.baked(x, y)) continue;
                const std::size_t here = page.at(x, y);
                // Each pair of texels swaps light: what one gains the other loses, and the page keeps all that its paths brought
                const float mine = luminance(lightmap.texels[here]);
                vec3 gained(0.0f), turned(0.0f); // `turned`: directions, each as bright as it is
                float given = 0.0f, squares = 0.0f;
                for (int j = -2; j <= 2; j++)
                    for (int i = -2; i <= 2; i++) {
                        if ((i == 0 && j == 0) || !page.baked(x + i * step, y + j * step)) continue;
                        const std::size_t there = page.at(x + i * step, y + j * step);
                        if ((lightmap.texels[there] == vec3(0.0f)) != (lightmap.texels[here] == vec3(0.0f)) &&
                            !sight(guides.position[here], guides.position[there], kSightHeight * sizes[here] * guides.normal[here]))
                            continue; // no light has come to one of them, and a wall stands between
                        const float tolerance = kLightSigmas * std::sqrt(max(steady[here], steady[there]));
                        const float weight =
                            kKernel[abs(i)] * kKernel[abs(j)] * likeness(page, here, there, max(sizes[here], sizes[there]), tolerance);
                        gained += weight * (lightmap.texels[there] - lightmap.texels[here]);
                        if (!nextDirection.empty())
                            turned += weight * (luminance(lightmap.texels[there]) * vec3(lightmap.direction[there]) -
                                                mine * vec3(lightmap.direction[here]));
                        squares += weight * weight * variance[there];
                        given += weight;
                    }
                next[here] = lightmap.texels[here] + gained;
                nextVariance[here] = (1.0f - given) * (1.0f - given) * variance[here] + squares;
                const float light = luminance(next[here]);
                if (!nextDirection.empty() && light > 0.0f)
                    nextDirection[here] = directionAbout((mine * vec3(lightmap.direction[here]) + turned) / light, guides.normal[here]);
            }
            advance(1);
        });
        lightmap.texels.swap(next);
        lightmap.direction.swap(nextDirection);
        variance.swap(nextVariance);
    }
}
}
