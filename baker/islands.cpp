#include "baker/islands.hpp"
#include "baker/world.hpp"
#include "shaders/color.h"

namespace afterglow
{
Sight sightIn(const World& world)
{
    return [&world](vec3 from, vec3 to, vec3 height) {
        const float apart = distance(from, to);
        return largestOf(world.transmittance({from + height, (to - from) / apart, apart})) > 0.0f;
    };
}

Islands islandsOf(const Lightmap& lightmap, const Joined& joined)
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
                const std::size_t here = std::size_t(at.y * size.x + at.x), texel = std::size_t(to.y * size.x + to.x);
                if (lightmap.valid[texel] != 1 || islands.of[texel] != 0 || !joined(here, texel)) continue;
                islands.of[texel] = islands.count;
                open.push_back(to);
            }
        }
    }
    return islands;
}

Islands islandsOf(const Lightmap& lightmap, const TexelGuides& guides, const Sight& sight)
{
    return islandsOf(lightmap, [&](std::size_t here, std::size_t there) {
        const float a = luminance(lightmap.texels[here]), b = luminance(lightmap.texels[there]);
        if (max(a, b) <= kMuch * min(a, b)) return true;
        const vec3 from = guides.position[here], to = guides.position[there];
        return from == to || sight(from, to, kSightHeight * distance(from, to) * guides.normal[here]);
    });
}
}
