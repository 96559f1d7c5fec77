// Inside of row 3: what the accesses of a pass ask of the GPU, as barriers say it.
#pragma once
#include "engine/graph/pass.hpp"

namespace afterglow
{
struct State {
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_NONE;
    VkAccessFlags2 access = VK_ACCESS_2_NONE;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    bool operator==(const State&) const = default;
};

// Of some texels, or of a buffer: of all accesses of the pass to them at once. Stages and accesses add up, layouts agree.
State stateOf(const PassData& pass, const Access& access);

// The layout in which the accesses of one pass to the same texels agree.
VkImageLayout layoutOf(const PassData& pass, const Access& access);

// The two share texels, or a buffer.
bool overlap(const Access& a, const Access& b);
}
