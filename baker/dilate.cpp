#include "baker/dilate.hpp"
#include <algorithm>

namespace afterglow
{
void dilate(Lightmap& lightmap, const std::vector<uint>& owner, int rings)
{
    std::vector<std::size_t> waiting, filled;
    for (std::size_t i = 0; i < lightmap.valid.size(); i++)
        if (lightmap.valid[i] == 0) waiting.push_back(i);
    for (int ring = 0; ring == 0 || !filled.empty(); ring++) {
        filled.clear();
        std::erase_if(waiting, [&](std::size_t i) { return lightmap.valid[i] != 0 || (owner[i] == kNobody && ring >= rings); });
        for (std::size_t here : waiting) {
            const int x = int(here % std::size_t(lightmap.width)), y = int(here / std::size_t(lightmap.width));
            vec3 sum(0.0f);
            vec4 direction(0.0f);
            float count = 0.0f;
            for (int diagonal = 0; diagonal < 2 && count == 0.0f; diagonal++) // what lies straight beside it comes first
                for (int k = 0; k < 9; k++) {
                    const int i = x + k % 3 - 1, j = y + k / 3 - 1;
                    if (i < 0 || j < 0 || i >= lightmap.width || j >= lightmap.height || (i != x && j != y) != (diagonal == 1)) continue;
                    std::size_t there = std::size_t(j) * std::size_t(lightmap.width) + std::size_t(i);
                    if (lightmap.valid[there] == 0 || (owner[here] != kNobody && owner[there] != owner[here])) continue;
                    sum += lightmap.texels[there];
                    if (!lightmap.direction.empty()) direction += lightmap.direction[there];
                    count += 1.0f;
                }
            if (count == 0.0f) continue;
            lightmap.texels[here] = sum / count;
            if (!lightmap.direction.empty()) lightmap.direction[here] = direction / count;
            filled.push_back(here);
        }
        for (std::size_t here : filled) lightmap.valid[here] = 2; // a ring is no neighbour of its own
    }
}
}
