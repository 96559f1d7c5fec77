#include "baker/fireflies.hpp"
#include "baker/lanes.hpp"
#include "shaders/color.h"
#include <algorithm>
#include <map>

namespace afterglow
{
static constexpr int kAbout = 6;          // texels to each side: a path is shared by sixteen neighbours, which must be few among these
static constexpr int kMost = 2 * kPacket; // of them, of as many as two paths are shared by
static constexpr std::size_t kSquare = 4; // texels along a square that shares paths
static constexpr float kUnseen = 2.0f;    // times the median, at most, that the other half tells,
static constexpr float kNothing = 16.0f;  // or of the light the share of one in so many

// Visits the texels about one, of its own island, itself among them.
template <typename Each>
static void eachAbout(const Lightmap& lightmap, const Islands& islands, std::size_t here, const Each& each)
{
    const ivec2 size(lightmap.width, lightmap.height), at(int(here) % size.x, int(here) / size.x);
    const ivec2 from = max(at - kAbout, ivec2(0)), to = min(at + kAbout, size - 1);
    for (int y = from.y; y <= to.y; y++)
        for (int x = from.x; x <= to.x; x++)
            if (const std::size_t there = std::size_t(y * size.x + x); islands.of[there] == islands.of[here]) each(there);
}

// Of the texels about it the one of median light; itself where there are too few to say.
static std::size_t medianAbout(const Lightmap& lightmap, const Islands& islands, std::size_t here)
{
    std::vector<std::size_t> about;
    eachAbout(lightmap, islands, here, [&](std::size_t there) { about.push_back(there); });
    if (about.size() <= std::size_t(kMost)) return here;
    const auto middle = about.begin() + std::ptrdiff_t(about.size() / 2);
    std::nth_element(about.begin(), middle, about.end(),
                     [&](std::size_t a, std::size_t b) { return luminance(lightmap.texels[a]) < luminance(lightmap.texels[b]); });
    return *middle;
}

namespace
{
// A texel that is to be as its neighbour is.
struct Firefly {
    std::size_t texel;
    vec3 light, half;
    vec4 direction;
    float variance;
};

struct Sums {
    dvec3 light{0.0}, rare{0.0};                // of all texels; of fireflies, beyond their neighbours
    std::map<std::size_t, double> rareBySquare; // the luminance of those in each square of texels that share paths

    double squares() const
    {
        double sum = 0.0;
        for (const auto& [square, rare] : rareBySquare) sum += rare * rare;
        return sum;
    }
};
}

static std::vector<Firefly> fireflies(const Lightmap& lightmap, const TexelGuides& guides, const Islands& islands)
{
    std::vector<Firefly> candidates, found;
    std::vector<bool> isOne(islands.of.size(), false);
    for (std::size_t texel = 0; texel < islands.of.size(); texel++) {
        const float light = luminance(lightmap.texels[texel]), apart = std::abs(luminance(guides.half[texel]));
        if (islands.of[texel] == 0 || !(apart > (1.0f - kUnseen / kFirefly) * light)) continue;
        const std::size_t median = medianAbout(lightmap, islands, texel);
        const float usual = luminance(lightmap.texels[median]);
        if (!(light > kFirefly * usual && light - apart <= max(kUnseen * usual, light / kNothing))) continue;
        const vec4 direction = lightmap.direction.empty() ? vec4(0.0f) : lightmap.direction[median];
        candidates.push_back({texel, lightmap.texels[median], guides.half[median], direction, guides.variance[median]});
        isOne[texel] = true;
    }
    for (const Firefly& candidate : candidates) {
        int count = 0;
        eachAbout(lightmap, islands, candidate.texel, [&](std::size_t there) { count += isOne[there] ? 1 : 0; });
        if (count <= kMost) found.push_back(candidate);
    }
    return found;
}

std::vector<std::size_t> rareTexels(const Lightmap& lightmap, const TexelGuides& guides, const Islands& islands)
{
    std::vector<std::size_t> texels;
    for (const Firefly& firefly : fireflies(lightmap, guides, islands)) texels.push_back(firefly.texel);
    return texels;
}

// Of the texels that share paths, side by side.
static std::size_t squareOf(const Lightmap& lightmap, std::size_t texel)
{
    static_assert(kSquare * kSquare == kPacket);
    const std::size_t width = std::size_t(lightmap.width);
    return texel / width / kSquare * width + texel % width / kSquare;
}

std::vector<float> spreadFireflies(Lightmap& lightmap, TexelGuides& guides, const Islands& islands)
{
    const std::vector<Firefly> found = fireflies(lightmap, guides, islands);
    std::vector<Sums> sums(std::size_t(islands.count) + 1);
    for (std::size_t texel = 0; texel < islands.of.size(); texel++)
        sums[std::size_t(islands.of[texel])].light += dvec3(lightmap.texels[texel]);
    for (const Firefly& firefly : found) {
        Sums& island = sums[std::size_t(islands.of[firefly.texel])];
        const vec3 beyond = lightmap.texels[firefly.texel] - firefly.light;
        island.rare += dvec3(beyond);
        island.rareBySquare[squareOf(lightmap, firefly.texel)] += double(luminance(beyond));
    }

    std::vector<float> off(sums.size(), 0.0f);
    std::vector<vec3> brighter(sums.size(), vec3(1.0f));
    for (std::size_t i = 1; i < sums.size(); i++) {
        const dvec3 light = sums[i].light, rare = sums[i].rare;
        if (!(sums[i].squares() > 0.0) || any(greaterThan(rare, double(kRare) * light))) continue;
        const double all = double(luminance(vec3(light)));
        off[i] = float(sums[i].squares() / (all * all));
        for (int c = 0; c < 3; c++)
            if (light[c] > 0.0) brighter[i][c] = float(light[c] / (light[c] - rare[c]));
    }

    for (const Firefly& firefly : found) {
        if (!(off[std::size_t(islands.of[firefly.texel])] > 0.0f)) continue;
        lightmap.texels[firefly.texel] = firefly.light;
        if (!lightmap.direction.empty()) lightmap.direction[firefly.texel] = firefly.direction;
        guides.half[firefly.texel] = firefly.half;
        guides.variance[firefly.texel] = firefly.variance;
    }
    for (std::size_t texel = 0; texel < islands.of.size(); texel++) {
        const vec3 by = brighter[std::size_t(islands.of[texel])];
        lightmap.texels[texel] *= by;
        guides.half[texel] *= by;
        guides.variance[texel] *= luminance(by) * luminance(by);
    }
    return off;
}
}
