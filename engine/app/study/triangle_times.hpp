// How long triangles take: rays through a tree of them, rays that ask each of them, and their raster.
#pragma once
#include "engine/app/study/study.hpp"

namespace afterglow
{
constexpr std::size_t kAsked = 128; // rays that ask every triangle

// `triangles`: of the level that is made for it. Where there is no device, none is asked.
Timing byEmbree(Gpu*, double triangles);
Timing byDevice(Gpu* gpu, double triangles);
Timing withoutTree(Gpu*, double triangles);
Timing rasterised(Gpu* gpu, double triangles);
}
