// A schedule becomes commands: barriers as derived, then what each kind of pass does.
#include "engine/core/error.hpp"
#include "engine/graph/draw.hpp"
#include "engine/graph/frame_commands.hpp"

namespace afterglow
{
void recordBarriers(VkCommandBuffer commands, const std::vector<Barrier>& barriers, const Objects& objects)
{
    if (barriers.empty()) return;
    std::vector<VkImageMemoryBarrier2> images;
    VkMemoryBarrier2 memory{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2}; // buffers: one for all of them
    for (const Barrier& barrier : barriers) {
        const GpuImage* image = objects.images[barrier.physical];
        if (!image) {
            memory.srcStageMask |= barrier.before.stages;
            memory.srcAccessMask |= barrier.before.access;
            memory.dstStageMask |= barrier.after.stages;
            memory.dstAccessMask |= barrier.after.access;
            continue;
        }
        VkImageMemoryBarrier2 info{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
        info.srcStageMask = barrier.before.stages;
        info.srcAccessMask = barrier.before.access;
        info.dstStageMask = barrier.after.stages;
        info.dstAccessMask = barrier.after.access;
        info.oldLayout = barrier.before.layout;
        info.newLayout = barrier.after.layout;
        info.srcQueueFamilyIndex = info.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        info.image = image->image;
        const ImageRange& r = barrier.range;
        info.subresourceRange = {aspectOf(image->shape.format), r.mip, r.mips, r.layer, r.layers};
        images.push_back(info);
    }
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = memory.dstStageMask ? 1 : 0;
    dependency.pMemoryBarriers = &memory;
    dependency.imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size());
    dependency.pImageMemoryBarriers = images.data();
    vkCmdPipelineBarrier2(commands, &dependency);
}

void recordEverythingSeen(VkCommandBuffer commands)
{
    VkMemoryBarrier2 memory{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    memory.srcStageMask = memory.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    memory.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    memory.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &memory;
    vkCmdPipelineBarrier2(commands, &dependency);
}

// One recorder a pass: what its steps share.
struct Recorder {
    FrameCommands& frame;
    const PassData& pass;
    const Pipeline* pipeline;
    const Graph& graph;
    const Schedule& schedule;
    const Objects& objects;
    VkDescriptorSet scene;
    PassStats& stats;

    const GpuImage& image(const Access& access) const { return *objects.images[schedule.physicalOf[access.resource]]; }
    const GpuBuffer& buffer(std::uint32_t resource) const { return *objects.buffers[schedule.physicalOf[resource]]; }
    VkCommandBuffer commands() const { return frame.commands; }

    void bind(VkPipelineBindPoint point) const
    {
        const VkDescriptorSet own = frame.bind(*pipeline, pass, graph, schedule, objects);
        vkCmdBindPipeline(commands(), point, pipeline->pipeline);
        if (scene) vkCmdBindDescriptorSets(commands(), point, pipeline->layout, 0, 1, &scene, 0, nullptr);
        vkCmdBindDescriptorSets(commands(), point, pipeline->layout, 1, 1, &own, 0, nullptr);
    }

    Draw makeDraw() const
    {
        Draw draw;
        draw.commands = commands();
        draw.pipeline = pipeline;
        draw.pass = pass.name;
        return draw;
    }

    void bindAndPush(VkPipelineBindPoint point) const
    {
        bind(point);
        if (pipeline->pushBytes) makeDraw().pushBytes(pass.pushed.data(), pass.pushed.size());
    }

    void trace() const
    {
        bindAndPush(VK_PIPELINE_BIND_POINT_RAY_TRACING_KHR);
        const ShaderTable& table = pipeline->table;
        const VkStridedDeviceAddressRegionKHR noCallables{};
        const glm::uvec3& size = pass.threads;
        frame.device.cmdTraceRays(commands(), &table.begin, &table.misses, &table.hits, &noCallables, size.x, size.y, size.z);
    }

    void compute() const
    {
        bindAndPush(VK_PIPELINE_BIND_POINT_COMPUTE);
        for (const Access& access : pass.accesses)
            if (access.use == Use::indirect) return vkCmdDispatchIndirect(commands(), buffer(access.resource).buffer, pass.groupsAt);
        glm::uvec3 groups;
        for (int axis = 0; axis < 3; ++axis) {
            groups[axis] = (pass.threads[axis] + pipeline->groupSize[axis] - 1) / pipeline->groupSize[axis];
            check(groups[axis] <= frame.device.limits.maxComputeWorkGroupCount[axis],
                  "pass " + pass.name + " asks for more work groups than the device dispatches at once: let each invocation do more");
        }
        vkCmdDispatch(commands(), groups.x, groups.y, groups.z);
    }

    VkRenderingAttachmentInfo attachment(const Access& access) const
    {
        VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
        const ImageRange r = resolve(access.range, image(access).shape);
        check(r.layers == 1, "pass " + pass.name + " draws to several layers at once: choose one by Texture::layer");
        info.imageView = image(access).viewOf({r.mip, 1, r.layer, 1}, ImageKind::flat);
        info.imageLayout = layoutOf(pass, access);
        info.storeOp = access.use == Use::depthTest ? VK_ATTACHMENT_STORE_OP_NONE : VK_ATTACHMENT_STORE_OP_STORE;
        // A full-screen pass overwrites every pixel of its area; a raster pass starts from the clear value.
        const bool overwrites = pass.kind == PassKind::fullscreen && access.use == Use::color && pass.key.blend == Blend::none;
        info.loadOp = reads(access.use) ? VK_ATTACHMENT_LOAD_OP_LOAD
                      : overwrites      ? VK_ATTACHMENT_LOAD_OP_DONT_CARE
                                        : VK_ATTACHMENT_LOAD_OP_CLEAR;
        if (isDepthUse(access.use))
            info.clearValue.depthStencil = {access.clear.x, 0};
        else
            for (int c = 0; c < 4; ++c) info.clearValue.color.float32[c] = access.clear[c];
        return info;
    }

    void raster() const
    {
        std::vector<VkRenderingAttachmentInfo> colors;
        VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
        glm::uvec2 size(0);
        bool hasDepth = false;
        for (const Access& access : pass.accesses) {
            if (!isColorUse(access.use) && !isDepthUse(access.use)) continue;
            if (access.resource == kNoResource) {
                colors.push_back({VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO});
                continue;
            }
            const glm::uvec2 own(mipSize(image(access).shape, access.range.mip));
            check(size == glm::uvec2(0) || size == own, "pass " + pass.name + " has attachments of different sizes");
            size = own;
            hasDepth = hasDepth || isDepthUse(access.use);
            if (isDepthUse(access.use))
                depth = attachment(access);
            else
                colors.push_back(attachment(access));
        }
        check(size.x > 0, "pass " + pass.name + " draws to nothing: declare a write to a texture");
        VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
        info.renderArea.extent = {size.x, size.y};
        info.layerCount = 1;
        info.colorAttachmentCount = static_cast<std::uint32_t>(colors.size());
        info.pColorAttachments = colors.data();
        info.pDepthAttachment = hasDepth ? &depth : nullptr;
        vkCmdBeginRendering(commands(), &info);
        bind(VK_PIPELINE_BIND_POINT_GRAPHICS);
        Draw draw = makeDraw();
        draw.area(glm::uvec4(0, 0, size));
        draw.frontsOnly(false);
        if (pass.key.depthBias) vkCmdSetDepthBias(commands(), pass.biasConstant, 0, pass.biasSlope);
        if (!pass.pushed.empty()) draw.pushBytes(pass.pushed.data(), pass.pushed.size());
        if (pass.kind == PassKind::fullscreen)
            draw.vertices(3);
        else if (pass.draw)
            pass.draw(draw);
        vkCmdEndRendering(commands());
        stats.draws = draw.draws;
        stats.triangles = draw.triangles;
    }

    void copy() const
    {
        const Access& from = pass.accesses[0];
        const Access& to = pass.accesses[1];
        const auto layers = [&](const Access& a) {
            return VkImageSubresourceLayers{aspectOf(image(a).shape.format), a.range.mip, a.range.layer, 1};
        };
        const auto corner = [&](const Access& a) {
            const glm::ivec3 size(mipSize(image(a).shape, a.range.mip));
            return VkOffset3D{size.x, size.y, size.z};
        };
        VkImageBlit blit{};
        blit.srcSubresource = layers(from);
        blit.dstSubresource = layers(to);
        blit.srcOffsets[1] = corner(from);
        blit.dstOffsets[1] = corner(to);
        const bool same = mipSize(image(from).shape, from.range.mip) == mipSize(image(to).shape, to.range.mip);
        vkCmdBlitImage(commands(), image(from).image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image(to).image,
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, same ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
    }
};

void recordPass(FrameCommands& frame, const PassData& pass, const Pipeline* pipeline, const Graph& graph, const Schedule& schedule,
                const Objects& objects, VkDescriptorSet scene, PassStats& stats)
{
    const Recorder recorder{frame, pass, pipeline, graph, schedule, objects, scene, stats};
    switch (pass.kind) {
    case PassKind::compute:
        return recorder.compute();
    case PassKind::trace:
        return recorder.trace();
    case PassKind::fullscreen:
    case PassKind::raster:
        return recorder.raster();
    case PassKind::copy:
        return recorder.copy();
    case PassKind::fill:
        return vkCmdFillBuffer(frame.commands, recorder.buffer(pass.accesses[0].resource).buffer, 0, VK_WHOLE_SIZE, pass.value);
    }
}
}
