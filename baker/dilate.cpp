#include "baker/dilate.hpp"

namespace afterglow
{
void dilate(Lightmap& lightmap, int rings)
{
    for (int ring = 0; ring < rings; ring++) {
        std::vector<std::uint8_t> before = lightmap.valid;
        for (int y = 0; y < lightmap.height; y++)
            for (int x = 0; x < lightmap.width; x++) {
                std::size_t here = std::size_t(y) * std::size_t(lightmap.width) + std::size_t(x);
                if (before[here] != 0) continue;
                vec3 sum(0.0f);
                float count = 0.0f;
                for (int j = max(y - 1, 0); j <= min(y + 1, lightmap.height - 1); j++)
                    for (int i = max(x - 1, 0); i <= min(x + 1, lightmap.width - 1); i++) {
                        std::size_t there = std::size_t(j) * std::size_t(lightmap.width) + std::size_t(i);
                        if (before[there] == 0) continue;
                        sum += lightmap.texels[there];
                        count += 1.0f;
                    }
                if (count == 0.0f) continue;
                lightmap.texels[here] = sum / count;
                lightmap.valid[here] = 2;
            }
    }
}
}
