#include "engine/app/heat.hpp"
#include <algorithm>

namespace afterglow
{
Image8 heat(const Image& map)
{
    constexpr float stops[5][3] = {
        {0.0f, 0.0f, 0.02f}, {0.32f, 0.07f, 0.48f}, {0.72f, 0.21f, 0.47f}, {0.98f, 0.54f, 0.38f}, {0.99f, 0.99f, 0.75f}};
    Image8 picture;
    picture.width = map.width, picture.height = map.height, picture.channels = 3;
    for (float error : map.pixels) {
        const float at = std::clamp(error, 0.0f, 1.0f) * 4.0f;
        const int stop = std::min(int(at), 3);
        for (int c = 0; c < 3; ++c) {
            const float value = stops[stop][c] + (stops[stop + 1][c] - stops[stop][c]) * (at - float(stop));
            picture.pixels.push_back(std::uint8_t(value * 255.0f + 0.5f));
        }
    }
    return picture;
}
}
