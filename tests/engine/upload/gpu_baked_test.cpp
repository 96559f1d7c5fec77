#include "engine/gpu/readback.hpp"
#include "engine/upload/gpu_baked.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"

namespace afterglow
{
using GpuBakedTest = Validated;

TEST_F(GpuBakedTest, LightmapsKeepTheirValues)
{
    // Shared exponent: an error of 2^-9 of the largest channel at most; black stays black.
    Scene scene;
    Baked baked = bakedEvenly(scene, vec3(0.0f));
    baked.lightmaps[0].texels[0] = vec3(0.3f, 1.7f, 12.0f);
    const GpuBaked uploaded = uploadBaked(gpu, baked, {});
    ASSERT_EQ(uploaded.lightmaps.size(), 1u);
    const Image page = readback(gpu.memory, uploaded.lightmaps[0]);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(page.at(0, 0)[c], baked.lightmaps[0].texels[0][c], 12.0f / 512.0f);
    EXPECT_EQ(page.at(1, 0)[0], 0.0f);
}

TEST_F(GpuBakedTest, WhatThePlanLeavesOffTakesNoMemory)
{
    Scene scene;
    Baked baked = bakedEvenly(scene, vec3(1.0f));
    baked.probes = evenProbes(vec3(-1), vec3(1), vec3(1.0f));
    baked.reflections.push_back(evenReflection(vec3(-1), vec3(1), vec3(1.0f)));
    const std::uint64_t before = gpu.memory.bytes();
    {
        const GpuBaked nothing = uploadBaked(gpu, baked, {.lightmaps = false, .probes = false, .reflections = false});
        EXPECT_EQ(gpu.memory.bytes(), before);
    }
    const GpuBaked all = uploadBaked(gpu, baked, {});
    EXPECT_GT(gpu.memory.bytes(), before);
    EXPECT_TRUE(all.probeTree && all.probes && all.probeStarts);
    EXPECT_EQ(all.reflections.size(), 1u);
}

TEST_F(GpuBakedTest, ReflectionsKeepEveryMipOfEveryFace)
{
    Scene scene;
    Baked baked = bakedEvenly(scene, vec3(0.0f));
    ReflectionProbe probe = evenReflection(vec3(-1), vec3(1), vec3(1.0f));
    probe.mips[1][4 * 4 * 4] = vec3(7.0f); // face +z, mip 1, first texel
    baked.reflections.push_back(probe);
    const GpuBaked uploaded = uploadBaked(gpu, baked, {});
    EXPECT_EQ(readback(gpu.memory, uploaded.reflections[0], 1, 4).at(0, 0)[0], 7.0f);
    EXPECT_EQ(readback(gpu.memory, uploaded.reflections[0], 1, 3).at(0, 0)[0], 1.0f);
    EXPECT_TRUE(uploaded.splitSum);
}
}
