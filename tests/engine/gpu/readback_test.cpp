// What was uploaded comes back, whatever its shape.
#include "engine/gpu/readback.hpp"
#include "tests/engine/gpu/validated.hpp"

namespace afterglow
{
TEST_F(Validated, ReadbackOfEachLayerAndMip)
{
    const ImageShape shape{VK_FORMAT_R32G32_SFLOAT, {4, 4, 1}, 2, 6, ImageKind::cube};
    const GpuImage cube = gpu.memory.image("cube", shape);
    std::vector<float> face(2 * 2 * 2); // mip 1
    for (std::uint32_t layer = 0; layer < 6; ++layer) {
        face[0] = static_cast<float>(layer);
        face[3] = -1.0f;
        gpu.memory.upload(cube, face.data(), face.size() * 4, 1, layer, 1);
    }
    for (std::uint32_t layer = 0; layer < 6; ++layer) {
        const Image image = readback(gpu.memory, cube, 1, layer);
        EXPECT_EQ(image.width, 2);
        EXPECT_EQ(image.height, 2);
        EXPECT_EQ(image.channels, 2);
        EXPECT_EQ(image.pixels[0], static_cast<float>(layer));
        EXPECT_EQ(image.pixels[3], -1.0f);
    }
}

TEST_F(Validated, ReadbackOfAVolumeStacksItsSlices)
{
    const GpuImage volume = gpu.memory.image("volume", {VK_FORMAT_R8_UNORM, {2, 2, 3}, 1, 1, ImageKind::volume});
    const std::uint8_t data[12] = {0, 0, 0, 0, 51, 51, 51, 51, 255, 255, 255, 255};
    gpu.memory.upload(volume, data, sizeof(data));
    const Image image = readback(gpu.memory, volume);
    EXPECT_EQ(image.height, 6);
    EXPECT_FLOAT_EQ(image.at(1, 3)[0], 0.2f);
    EXPECT_FLOAT_EQ(image.at(0, 5)[0], 1.0f);
}

TEST_F(Validated, ReadbackOfBytesKeepsThem)
{
    const GpuImage picture = gpu.memory.image("picture", {VK_FORMAT_R8G8B8A8_UNORM, {2, 1, 1}});
    const std::uint8_t data[8] = {1, 2, 3, 4, 250, 251, 252, 253};
    gpu.memory.upload(picture, data, 8);
    const Image8 image = readback8(gpu.memory, picture);
    EXPECT_EQ(image.pixels, std::vector<std::uint8_t>(data, data + 8));
}
}
