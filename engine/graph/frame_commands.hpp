// Inside of row 3: one frame's command buffer, descriptors and timestamps, and the recording of a schedule into them.
#pragma once
#include "engine/graph/kept.hpp"

namespace afterglow
{
class FrameCommands
{
public:
    explicit FrameCommands(Device& device);
    ~FrameCommands();
    FrameCommands(const FrameCommands&) = delete;
    FrameCommands& operator=(const FrameCommands&) = delete;

    void begin(std::size_t passes);
    void submit(); // and wait

    // The set 1 of a pass: its binding accesses in their order.
    VkDescriptorSet bind(const Pipeline& pipeline, const PassData& pass, const Graph& graph, const Schedule& schedule,
                         const Objects& objects);

    void timestamp();
    std::vector<double> milliseconds() const; // between neighbouring timestamps; after submit

    Device& device;
    VkCommandBuffer commands = VK_NULL_HANDLE;

private:
    VkDescriptorSet allocate(VkDescriptorSetLayout layout);
    void addPool();
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    VkQueryPool queries_ = VK_NULL_HANDLE;
    std::uint32_t capacity_ = 0, stamps_ = 0;
    std::vector<VkDescriptorPool> descriptors_;
    std::size_t descriptorPool_ = 0;      // the one in use
    std::array<VkSampler, 3> samplers_{}; // by Sampler
};

// What a pass draws and dispatches, without its barriers.
void recordPass(FrameCommands& frame, const PassData& pass, const Pipeline* pipeline, const Graph& graph, const Schedule& schedule,
                const Objects& objects, VkDescriptorSet scene, PassStats& stats);
void recordEverythingSeen(VkCommandBuffer commands); // all that was written before, by whatever comes next
void recordBarriers(VkCommandBuffer commands, const std::vector<Barrier>& barriers, const Objects& objects);
}
