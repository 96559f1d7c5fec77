// One state of all accesses to the same texels.
#include "engine/graph/state.hpp"
#include "engine/core/error.hpp"

namespace afterglow
{
bool overlap(const Access& a, const Access& b)
{
    if (a.resource != b.resource) return false;
    const auto meets = [](std::uint32_t first, std::uint32_t count, std::uint32_t otherFirst, std::uint32_t otherCount) {
        return (!otherCount || first < otherFirst + otherCount) && (!count || otherFirst < first + count);
    };
    return meets(a.range.mip, a.range.mips, b.range.mip, b.range.mips) &&
           meets(a.range.layer, a.range.layers, b.range.layer, b.range.layers);
}

VkImageLayout layoutOf(const PassData& pass, const Access& access)
{
    const VkImageLayout alone = factsOf(access.use).layout;
    if (access.use != Use::sampled) return alone;
    VkImageLayout together = alone;
    for (const Access& other : pass.accesses) {
        if (!overlap(access, other)) continue;
        const bool drawn = (isColorUse(other.use) || isDepthUse(other.use)) && writes(other.use);
        check(!drawn, "pass " + pass.name + " samples the texels that it draws to");
        // What else the pass does to these texels is possible in its own layout alone; sampling is in any of them.
        if (together != VK_IMAGE_LAYOUT_GENERAL && other.use != Use::sampled) together = factsOf(other.use).layout;
    }
    return together;
}

static VkPipelineStageFlags2 shaderStages(PassKind kind)
{
    switch (kind) {
    case PassKind::compute:
        return VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    case PassKind::fullscreen:
        return VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
    case PassKind::raster:
        return VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
    case PassKind::trace:
        return VK_PIPELINE_STAGE_2_RAY_TRACING_SHADER_BIT_KHR;
    default:
        return VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    }
}

State stateOf(const PassData& pass, const Access& access)
{
    State sum{VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE, layoutOf(pass, access)};
    for (const Access& other : pass.accesses) {
        if (!overlap(access, other)) continue; // itself, at least, does
        const UseFacts& facts = factsOf(other.use);
        sum.stages |= facts.stages ? facts.stages : shaderStages(pass.kind);
        sum.access |= facts.access;
    }
    return sum;
}
}
