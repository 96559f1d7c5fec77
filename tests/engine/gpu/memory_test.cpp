// Memory: every byte counted, every hole reused, nothing left behind.
#include "engine/gpu/readback.hpp"
#include "tests/engine/gpu/validated.hpp"
#include <numeric>

namespace afterglow
{
TEST_F(Validated, MemoryReturnsToNothing)
{
    {
        const GpuBuffer a = gpu.memory.buffer("a", 1000, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
        const GpuImage b = gpu.memory.image("b", {VK_FORMAT_R8G8B8A8_UNORM, {64, 64, 1}});
        EXPECT_GE(gpu.memory.bytes(), 1000u + 64 * 64 * 4);
        EXPECT_GE(gpu.memory.reserved(), gpu.memory.bytes());
    }
    EXPECT_EQ(gpu.memory.bytes(), 0u);
    EXPECT_EQ(gpu.memory.reserved(), 0u);
}

TEST_F(Validated, MemoryManySmallThingsShareOneBlockAndHolesAreReused)
{
    std::vector<GpuBuffer> buffers;
    for (int i = 0; i < 100; ++i) buffers.push_back(gpu.memory.buffer("small", 4096, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
    const std::uint64_t oneBlock = gpu.memory.reserved();
    EXPECT_EQ(oneBlock, 64ull << 20);
    for (int i = 0; i < 100; i += 2) buffers[static_cast<std::size_t>(i)] = GpuBuffer();
    for (int i = 0; i < 100; i += 2)
        buffers[static_cast<std::size_t>(i)] = gpu.memory.buffer("again", 4096, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    EXPECT_EQ(gpu.memory.reserved(), oneBlock);
    // No two overlap: each keeps the number written to it.
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::vector<std::uint32_t> data(1024, static_cast<std::uint32_t>(i));
        gpu.memory.upload(buffers[i], data.data(), 4096);
    }
    for (std::size_t i = 0; i < buffers.size(); ++i) EXPECT_EQ(readback(gpu.memory, buffers[i])[4092], i);
}

TEST_F(Validated, MemoryLargeThingsGetABlockOfTheirOwn)
{
    const GpuBuffer large = gpu.memory.buffer("large", 70ull << 20, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    EXPECT_LT(gpu.memory.reserved(), 72ull << 20);
}

TEST_F(Validated, MemoryBufferOfNothingIsStillABuffer)
{
    const GpuBuffer none = gpu.memory.buffer("no lights", 0, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    EXPECT_NE(none.address, 0u);
    gpu.memory.upload(none, nullptr, 0);
}

TEST_F(Validated, MemoryFreshImagesAreZero)
{
    const GpuImage image = gpu.memory.image("fresh", {VK_FORMAT_R32G32B32A32_SFLOAT, {5, 3, 1}, 2, 2, ImageKind::array});
    for (const float value : readback(gpu.memory, image, 1, 1).pixels) EXPECT_EQ(value, 0.0f);
    const GpuImage light = gpu.memory.image("light", {VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, {4, 4, 1}});
    for (const float value : readback(gpu.memory, light).pixels) EXPECT_EQ(value, 0.0f);
    const GpuImage depth = gpu.memory.image("depth", {VK_FORMAT_D32_SFLOAT, {4, 4, 1}}, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    for (const float value : readback(gpu.memory, depth).pixels) EXPECT_EQ(value, 0.0f);
}

TEST_F(Validated, MemoryMipsAreAverages)
{
    // 4x4 of 0..15: its mean is 7.5, the mean of its upper left quarter (0 + 1 + 4 + 5) / 4 = 2.5.
    const GpuImage image = gpu.memory.image("mips", {VK_FORMAT_R32_SFLOAT, {4, 4, 1}, mipCount({4, 4})});
    std::vector<float> data(16);
    std::iota(data.begin(), data.end(), 0.0f);
    gpu.memory.upload(image, data.data(), 64);
    gpu.memory.makeMips(image);
    EXPECT_EQ(image.shape.mips, 3u);
    EXPECT_NEAR(readback(gpu.memory, image, 1).pixels[0], 2.5f, 1e-5f);
    EXPECT_NEAR(readback(gpu.memory, image, 2).pixels[0], 7.5f, 1e-5f);
}

TEST(ImageShape, BytesAreTheSumOverMipsAndLayers)
{
    // 4x2, 2x1, 1x1: 8 + 2 + 1 texels, 6 layers, 4 bytes.
    EXPECT_EQ(imageBytes({VK_FORMAT_R8G8B8A8_UNORM, {4, 2, 1}, 3, 6, ImageKind::cube}), 11u * 6 * 4);
    EXPECT_EQ(mipCount({1280, 720}), 11u);
    EXPECT_EQ(mipCount({1, 1}), 1u);
}
}
