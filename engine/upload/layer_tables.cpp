#include "engine/upload/layer_tables.hpp"
#include "shaders/layer.h"
#include <iterator>
#include <vector>

namespace afterglow
{
using namespace shared;

namespace
{
GpuImage uploadTable(Gpu& gpu, const std::string& name, const ImageShape& shape, const float* begin, const float* end)
{
    std::vector<glm::uint16> texels;
    for (const float* value = begin; value != end; ++value) texels.push_back(packHalf1x16(*value));
    GpuImage image = gpu.memory.image(name, shape);
    gpu.memory.upload(image, texels.data(), texels.size() * sizeof(texels[0]));
    return image;
}
}

GpuImage uploadLayerRatio(Gpu& gpu)
{
    const uvec3 size(kLayerCosines, kLayerRoughness, kLayerIndices);
    return uploadTable(gpu, "layer ratio", {.format = VK_FORMAT_R16_SFLOAT, .size = size, .kind = ImageKind::volume},
                       std::begin(kLayerRatio), std::end(kLayerRatio));
}

GpuImage uploadLayerMean(Gpu& gpu)
{
    const uvec3 size(kLayerRoughness, kLayerMeanIndices, 1);
    return uploadTable(gpu, "layer mean", {.format = VK_FORMAT_R16_SFLOAT, .size = size}, std::begin(kLayerMean), std::end(kLayerMean));
}
}
