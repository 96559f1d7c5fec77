// The tables of shaders/layer.h as textures, entry for texel.
#pragma once
#include "engine/gpu/gpu.hpp"

namespace afterglow
{
GpuImage uploadLayerRatio(Gpu& gpu);
GpuImage uploadLayerMean(Gpu& gpu);
}
