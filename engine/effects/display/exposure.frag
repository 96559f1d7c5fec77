#version 460
// The mean of the grid, as the factor that shows it as middle grey.
#include "engine/effects/display/display.h"

layout(set = 1, binding = 0) uniform sampler2D grid;
layout(location = 0) in vec2 uv;
layout(location = 0) out float exposure;

void main()
{
    vec2 sum = vec2(0.0);
    for (uint y = 0u; y < kExposureHeight; ++y)
        for (uint x = 0u; x < kExposureWidth; ++x) sum += texelFetch(grid, ivec2(x, y), 0).rg;
    exposure = exposureFromMean(sum);
}
