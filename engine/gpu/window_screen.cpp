// A frame on the screen: the picture is blitted into the swapchain, the panels drawn on top, and the result shown. One frame at a time.
#include "engine/gpu/transfer.hpp"
#include "engine/gpu/window_frame.hpp"
#include <algorithm>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_vulkan.h>

namespace afterglow
{
Screen::Screen(Window& window, Gpu& gpu) : window_(window), gpu_(gpu), swapchain_(gpu.device, window.size())
{
    const VkDevice device = gpu.device.device;
    const VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    vk(vkCreateFence(device, &fence, nullptr, &fence_));
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.queueFamilyIndex = gpu.device.queueFamily;
    vk(vkCreateCommandPool(device, &pool, nullptr, &pool_));
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool_;
    allocate.commandBufferCount = 1;
    vk(vkAllocateCommandBuffers(device, &allocate, &commands_));
    startPanels();
}

void Screen::startPanels()
{
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 16};
    VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
    pool.maxSets = 16;
    pool.poolSizeCount = 1;
    pool.pPoolSizes = &size;
    vk(vkCreateDescriptorPool(gpu_.device.device, &pool, nullptr, &descriptors_));

    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // leaves no file behind
    ImGui_ImplGlfw_InitForVulkan(window_.frame_->glfw, true);
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = gpu_.device.instance;
    info.PhysicalDevice = gpu_.device.physical;
    info.Device = gpu_.device.device;
    info.QueueFamily = gpu_.device.queueFamily;
    info.Queue = gpu_.device.queue;
    info.DescriptorPool = descriptors_;
    info.MinImageCount = 2;
    info.ImageCount = std::max(2u, static_cast<std::uint32_t>(swapchain_.targets.size()));
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
#if IMGUI_VERSION_NUM >= 19030
    info.RenderPass = swapchain_.pass;
    ImGui_ImplVulkan_Init(&info);
#else
    ImGui_ImplVulkan_Init(&info, swapchain_.pass);
#endif
#if IMGUI_VERSION_NUM < 19000 // later ones upload their fonts by themselves
    gpu_.device.submit([](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
#endif
}

Screen::~Screen()
{
    const VkDevice device = gpu_.device.device;
    vkDeviceWaitIdle(device);
    ImGui_ImplVulkan_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    vkDestroyDescriptorPool(device, descriptors_, nullptr);
    vkDestroyCommandPool(device, pool_, nullptr);
    vkDestroyFence(device, fence_, nullptr);
}

void Screen::record(VkCommandBuffer commands, const GpuImage& picture, const Swapchain::Target& target)
{
    const VkExtent2D extent = swapchain_.extent;
    // The swapchain's image, as far as a copy needs to know it.
    VkImageMemoryBarrier2 toBlit{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    toBlit.srcStageMask = toBlit.dstStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    toBlit.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    toBlit.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    toBlit.srcQueueFamilyIndex = toBlit.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    toBlit.image = target.image;
    toBlit.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &toBlit;
    vkCmdPipelineBarrier2(commands, &dependency);

    changeLayout(commands, picture, {}, kRestLayout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkImageBlit blit{};
    blit.srcSubresource = blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    blit.srcOffsets[1] = {static_cast<std::int32_t>(picture.shape.size.x), static_cast<std::int32_t>(picture.shape.size.y), 1};
    blit.dstOffsets[1] = {static_cast<std::int32_t>(extent.width), static_cast<std::int32_t>(extent.height), 1};
    vkCmdBlitImage(commands, picture.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                   &blit, VK_FILTER_LINEAR);
    changeLayout(commands, picture, {}, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kRestLayout);

    VkRenderPassBeginInfo begin{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
    begin.renderPass = swapchain_.pass;
    begin.framebuffer = target.framebuffer;
    begin.renderArea.extent = extent;
    vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
    vkCmdEndRenderPass(commands);
}

void Screen::show(const GpuImage& picture, const std::function<void(Panel&)>& draw)
{
    const Device& d = gpu_.device;
    const glm::uvec2 size = window_.size();
    if (!size.x || !size.y) return; // minimized
    const auto index = swapchain_.acquire(size);
    if (!index) return;
    const Swapchain::Target& target = swapchain_.targets[*index];

    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    Panel panel;
    if (draw) draw(panel);
    ImGui::Render();

    vk(vkResetCommandPool(d.device, pool_, 0));
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    vk(vkBeginCommandBuffer(commands_, &begin));
    record(commands_, picture, target);
    vk(vkEndCommandBuffer(commands_));

    VkSemaphoreSubmitInfo wait{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO}, signal = wait;
    wait.semaphore = swapchain_.acquired;
    wait.stageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    signal.semaphore = target.drawn;
    signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    buffer.commandBuffer = commands_;
    VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit.waitSemaphoreInfoCount = submit.commandBufferInfoCount = submit.signalSemaphoreInfoCount = 1;
    submit.pWaitSemaphoreInfos = &wait;
    submit.pCommandBufferInfos = &buffer;
    submit.pSignalSemaphoreInfos = &signal;
    vk(vkQueueSubmit2(d.queue, 1, &submit, fence_));

    swapchain_.present(*index);
    vk(vkWaitForFences(d.device, 1, &fence_, VK_TRUE, UINT64_MAX));
    vk(vkResetFences(d.device, 1, &fence_));
}
}
