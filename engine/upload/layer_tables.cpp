#include "engine/upload/layer_tables.hpp"
#include "shaders/layer.h"
#include <span>
#include <vector>

namespace afterglow
{
using namespace shared;

namespace
{
GpuImage uploadTable(Gpu& gpu, const std::string& name, const ImageShape& shape, std::span<const float> values)
{
    std::vector<glm::uint16> texels;
    for (float value : values) texels.push_back(packHalf1x16(value));
    GpuImage image = gpu.memory.image(name, shape);
    gpu.memory.upload(image, texels.data(), texels.size() * sizeof(texels[0]));
    return image;
}
}

GpuImage uploadLayerRatio(Gpu& gpu)
{
    // Texel (rough, index) of layer k holds the cosines 4 k to 4 k + 3
    std::vector<float> texels;
    for (int layer = 0; layer < kLayerCosines / 4; ++layer)
        for (int row = 0; row < kLayerIndices * kLayerRoughness; ++row) {
            const float* first = kLayerRatio + row * kLayerCosines + 4 * layer;
            texels.insert(texels.end(), first, first + 4);
        }
    const ImageShape shape{.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                           .size = {kLayerRoughness, kLayerIndices, 1},
                           .layers = kLayerCosines / 4,
                           .kind = ImageKind::array};
    return uploadTable(gpu, "layer ratio", shape, texels);
}

GpuImage uploadLayerMean(Gpu& gpu)
{
    const uvec3 size(kLayerRoughness, kLayerMeanIndices, 1);
    return uploadTable(gpu, "layer mean", {.format = VK_FORMAT_R16_SFLOAT, .size = size}, kLayerMean);
}
}
