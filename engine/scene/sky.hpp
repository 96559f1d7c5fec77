// By what directions are chosen of a sky that is an image (shaders/sky_light.h).
#pragma once
#include "engine/scene/scene.hpp"

namespace afterglow
{
// In proportion to the luminance that lookups show, times solid angle.
struct SkyTable {
    std::vector<float> rows;    // cumulative over rows, ends at 1; empty: uniform or black
    std::vector<float> columns; // cumulative within each row
};
SkyTable skyTable(const Image& image);
}
