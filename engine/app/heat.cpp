#include "engine/app/heat.hpp"
#include "shaders/heat.h"

namespace afterglow
{
Image8 heat(const Image& map)
{
    Image8 picture;
    picture.width = map.width, picture.height = map.height, picture.channels = 3;
    for (float error : map.pixels) {
        const glm::vec3 color = shared::heatColor(error);
        for (int c = 0; c < 3; ++c) picture.pixels.push_back(std::uint8_t(color[c] * 255.0f + 0.5f));
    }
    return picture;
}
}
