// Set 0 as shaders/bindings.glsl declares it: one descriptor set for all passes, written once.
#pragma once
#include "engine/graph/executor.hpp"
#include "engine/upload/gpu_baked.hpp"
#include "engine/upload/gpu_scene.hpp"

namespace afterglow
{
class GpuLevel
{
public:
    GpuLevel(Gpu& gpu, GpuScene scene, GpuBaked baked);
    ~GpuLevel();
    GpuLevel(const GpuLevel&) = delete;
    GpuLevel& operator=(const GpuLevel&) = delete;

    GpuScene scene;
    GpuBaked baked;
    SceneSet set;

private:
    VkSampler sampler(const SceneTexture& how);
    VkBufferView view(const GpuBuffer& texels);
    Device& device_;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    std::vector<std::pair<std::uint32_t, VkSampler>> samplers_; // by their settings
    std::vector<VkBufferView> views_;
};
}
