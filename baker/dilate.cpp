#include "baker/dilate.hpp"
#include "shaders/probe.h"

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

void dilate(ProbeVolume& volume)
{
    const ivec3 n = volume.count;
    for (std::size_t i = 0; i < volume.validity.size(); i++)
        if (volume.validity[i] == 0.0f) volume.irradiance[i] = shZero();
    for (bool filled = true; filled;) {
        filled = false;
        const std::vector<float> before = volume.validity;
        for (int here = 0; here < n.x * n.y * n.z; here++) {
            if (before[std::size_t(here)] != 0.0f) continue;
            const ivec3 at(here % n.x, here / n.x % n.y, here / (n.x * n.y));
            Sh9 sum = shZero();
            float count = 0.0f;
            for (int step = 0; step < 27; step++) {
                const ivec3 there = at + ivec3(step % 3, step / 3 % 3, step / 9) - 1;
                if (there != clamp(there, ivec3(0), n - 1)) continue;
                const std::size_t neighbour = std::size_t(probeIndex(there, n));
                if (before[neighbour] == 0.0f) continue;
                for (int c = 0; c < 9; c++) sum.c[c] += volume.irradiance[neighbour].c[c];
                count += 1.0f;
            }
            if (count == 0.0f) continue;
            for (int c = 0; c < 9; c++) volume.irradiance[std::size_t(here)].c[c] = sum.c[c] / count;
            volume.validity[std::size_t(here)] = kProbeBorrowed;
            filled = true;
        }
    }
}
}
