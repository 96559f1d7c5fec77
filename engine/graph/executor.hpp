// Runs graphs on the GPU, frame after frame. Keeps pipelines, images and histories between frames: a frame of the same structure as
// the last allocates nothing.
#pragma once
#include "engine/core/image.hpp"
#include "engine/gpu/gpu.hpp"
#include "engine/graph/schedule.hpp"
#include <memory>

namespace afterglow
{
// Set 0, the same for all passes: filled and owned by the upload layer. Null handles: no shader may use set 0.
struct SceneSet {
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE;
};

struct PassStats {
    std::string name;
    double milliseconds = 0; // GPU time between two timestamps
    std::vector<std::string> reads, writes;
    std::uint64_t bytes = 0; // of the frame's own memory that it writes
    std::uint64_t draws = 0, triangles = 0;
};

struct FrameStats {
    std::vector<PassStats> passes; // of one name: summed
    std::vector<std::string> culled;
    double milliseconds = 0;     // GPU, first pass to last
    std::uint32_t pipelines = 0; // made since the start
    std::uint64_t gpuBytes = 0;  // living buffers and images, the scene's included
    std::uint64_t draws = 0, triangles = 0;
};

class Executor
{
public:
    explicit Executor(Gpu& gpu);
    ~Executor();
    Executor(const Executor&) = delete;
    Executor& operator=(const Executor&) = delete;

    // Compiles, records, submits and waits. Throws Error when a shader does not compile or does not fit what its pass declares.
    FrameStats run(const Graph& graph, const SceneSet& scene = {});

    // Outputs of the last run.
    const GpuImage& image(const Texture& output) const;
    const GpuBuffer& buffer(const Buffer& output) const;
    Image download(const Texture& output) const;
    std::vector<std::uint8_t> download(const Buffer& output) const;

    Gpu& gpu;

private:
    struct State;
    std::unique_ptr<State> state_;
};
}
