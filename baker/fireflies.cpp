#include "baker/fireflies.hpp"
#include "baker/lanes.hpp"
#include "shaders/color.h"
#include <algorithm>

namespace afterglow
{
static constexpr int kAbout = 6;       // texels to each side: a path is shared by sixteen neighbours, which must be few among these
static constexpr float kUnseen = 2.0f; // times the median, at most, that the other half tells

// Of the texels about it of its own island, the one of median light; itself where there are too few to say.
static std::size_t medianAbout(const Lightmap& lightmap, const Islands& islands, ivec2 at)
{
    const std::size_t here = std::size_t(at.y * lightmap.width + at.x);
    std::vector<std::size_t> about;
    const ivec2 size(lightmap.width, lightmap.height), from = max(at - kAbout, ivec2(0)), to = min(at + kAbout, size - 1);
    for (int y = from.y; y <= to.y; y++)
        for (int x = from.x; x <= to.x; x++)
            if (const std::size_t there = std::size_t(y * size.x + x); islands.of[there] == islands.of[here]) about.push_back(there);
    if (about.size() < std::size_t(2 * kAbout + 1)) return here;
    const auto middle = about.begin() + std::ptrdiff_t(about.size() / 2);
    std::nth_element(about.begin(), middle, about.end(),
                     [&](std::size_t a, std::size_t b) { return luminance(lightmap.texels[a]) < luminance(lightmap.texels[b]); });
    return *middle;
}

namespace
{
struct Firefly {
    std::size_t texel, median;
};

struct Sums {
    dvec3 light{0.0}, rare{0.0}; // of all texels; of fireflies, beyond their medians
    double squares = 0.0;        // of those, their luminance
};
}

static std::vector<Firefly> fireflies(const Lightmap& lightmap, const TexelGuides& guides, const Islands& islands)
{
    std::vector<Firefly> found;
    for (int y = 0; y < lightmap.height; y++)
        for (int x = 0; x < lightmap.width; x++) {
            const std::size_t texel = std::size_t(y * lightmap.width + x);
            const float light = luminance(lightmap.texels[texel]), apart = std::abs(luminance(guides.half[texel]));
            if (islands.of[texel] == 0 || !(apart > (1.0f - kUnseen / kFirefly) * light)) continue;
            const std::size_t median = medianAbout(lightmap, islands, ivec2(x, y));
            const float usual = luminance(lightmap.texels[median]);
            if (light > kFirefly * usual && light - apart <= kUnseen * usual) found.push_back({texel, median});
        }
    return found;
}

std::vector<float> spreadFireflies(Lightmap& lightmap, TexelGuides& guides, const Islands& islands)
{
    const std::vector<Firefly> found = fireflies(lightmap, guides, islands);
    std::vector<Sums> sums(std::size_t(islands.count) + 1);
    for (std::size_t texel = 0; texel < islands.of.size(); texel++)
        sums[std::size_t(islands.of[texel])].light += dvec3(lightmap.texels[texel]);
    for (const auto& [texel, median] : found) {
        Sums& island = sums[std::size_t(islands.of[texel])];
        const vec3 beyond = lightmap.texels[texel] - lightmap.texels[median];
        island.rare += dvec3(beyond);
        island.squares += double(luminance(beyond)) * double(luminance(beyond));
    }

    std::vector<float> off(sums.size(), 0.0f);
    std::vector<vec3> brighter(sums.size(), vec3(1.0f)); // 1: nothing is spread
    for (std::size_t i = 1; i < sums.size(); i++) {
        const double light = double(luminance(vec3(sums[i].light)));
        if (!(sums[i].squares > 0.0) || double(luminance(vec3(sums[i].rare))) > double(kRare) * light) continue;
        off[i] = float(kPacket * sums[i].squares / (light * light));
        for (int c = 0; c < 3; c++)
            if (sums[i].light[c] > sums[i].rare[c]) brighter[i][c] = float(sums[i].light[c] / (sums[i].light[c] - sums[i].rare[c]));
    }

    const Lightmap before = found.empty() ? Lightmap{} : lightmap;
    for (const auto& [texel, median] : found) {
        if (!(off[std::size_t(islands.of[texel])] > 0.0f)) continue;
        lightmap.texels[texel] = before.texels[median];
        if (!before.direction.empty()) lightmap.direction[texel] = before.direction[median];
        guides.half[texel] = guides.half[median];
        guides.variance[texel] = guides.variance[median];
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
