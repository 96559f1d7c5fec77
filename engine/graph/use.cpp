// The table of uses.
#include "engine/graph/use.hpp"
#include <iterator>

namespace afterglow
{
constexpr VkPipelineStageFlags2 kOfTheShaders = 0;
constexpr VkPipelineStageFlags2 kAttach = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags2 kDepthTests = VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr VkPipelineStageFlags2 kCommands = VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT; // of dispatches, too
constexpr VkPipelineStageFlags2 kCopy = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;

constexpr VkAccessFlags2 kSample = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
constexpr VkAccessFlags2 kLoad = VK_ACCESS_2_SHADER_STORAGE_READ_BIT, kStore = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
constexpr VkAccessFlags2 kDraw = VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 kTest = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
constexpr VkAccessFlags2 kDepthWrite = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;

constexpr VkImageLayout kSampledLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
constexpr VkImageLayout kStorageLayout = VK_IMAGE_LAYOUT_GENERAL;
constexpr VkImageLayout kColorLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
constexpr VkImageLayout kDepthLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
constexpr VkImageLayout kTestLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL;
constexpr VkImageLayout kNoLayout = VK_IMAGE_LAYOUT_UNDEFINED;

constexpr VkImageUsageFlags kAlways = 0; // every image may be sampled and copied
constexpr VkImageUsageFlags kStorage = VK_IMAGE_USAGE_STORAGE_BIT;
constexpr VkImageUsageFlags kColor = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
constexpr VkImageUsageFlags kDepth = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;

// In the order of Use.
static constexpr UseFacts kFacts[] = {
    // reads, writes, stages, access, layout, usage
    {true, false, kOfTheShaders, kSample, kSampledLayout, kAlways},                                      // sampled
    {false, true, kOfTheShaders, kStore, kStorageLayout, kStorage},                                      // stored
    {true, true, kOfTheShaders, kLoad | kStore, kStorageLayout, kStorage},                               // storedModify
    {false, true, kAttach, kDraw, kColorLayout, kColor},                                                 // color
    {true, true, kAttach, kDraw, kColorLayout, kColor},                                                  // colorModify
    {false, true, kDepthTests, kTest | kDepthWrite, kDepthLayout, kDepth},                               // depth
    {true, true, kDepthTests, kTest | kDepthWrite, kDepthLayout, kDepth},                                // depthModify
    {true, false, kDepthTests, kTest, kTestLayout, kDepth},                                              // depthTest
    {true, false, kOfTheShaders, kLoad | VK_ACCESS_2_UNIFORM_READ_BIT, kNoLayout, kAlways},              // bufferRead
    {false, true, kOfTheShaders, kStore, kNoLayout, kAlways},                                            // bufferWrite
    {true, true, kOfTheShaders, kLoad | kStore, kNoLayout, kAlways},                                     // bufferModify
    {true, false, kCommands, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, kNoLayout, kAlways},                 // indirect
    {true, false, kCopy, VK_ACCESS_2_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kAlways},  // copyFrom
    {false, true, kCopy, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, kAlways}, // copyTo
};
static_assert(std::size(kFacts) == static_cast<std::size_t>(Use::copyTo) + 1, "each use has its row");

const UseFacts& factsOf(Use use) { return kFacts[static_cast<std::size_t>(use)]; }

bool reads(Use use) { return factsOf(use).reads; }
bool writes(Use use) { return factsOf(use).writes; }
bool isColorUse(Use use) { return use == Use::color || use == Use::colorModify; }
bool isDepthUse(Use use) { return use == Use::depth || use == Use::depthModify || use == Use::depthTest; }
bool isBinding(Use use) { return factsOf(use).stages == kOfTheShaders; }
}
