// The swapchain: the picture is blitted into it, the panel drawn on top, and the result shown. One frame at a time.
#include "engine/core/error.hpp"
#include "engine/gpu/transfer.hpp"
#include "engine/gpu/window_frame.hpp"
#include <algorithm>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_vulkan.h>

namespace afterglow
{
static VkSurfaceFormatKHR pickFormat(const Device& device)
{
    std::uint32_t count = 0;
    vk(vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical, device.surface, &count, nullptr));
    std::vector<VkSurfaceFormatKHR> formats(count);
    vk(vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical, device.surface, &count, formats.data()));
    // The picture is encoded already: no sRGB format, which would encode it again.
    for (const VkSurfaceFormatKHR& format : formats)
        if (format.format == VK_FORMAT_B8G8R8A8_UNORM || format.format == VK_FORMAT_R8G8B8A8_UNORM) return format;
    throw Error("this display takes no 8-bit pictures: draw to a file with `afterglow render`", Exit::noDevice);
}

// What the panel draws into: the swapchain image as the blit left it, ready to be shown afterwards.
static VkRenderPass makePass(VkDevice device, VkFormat format)
{
    VkAttachmentDescription color{};
    color.format = format;
    color.samples = VK_SAMPLE_COUNT_1_BIT;
    color.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    color.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    color.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    color.initialLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    color.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    VkSubpassDependency afterBlit{};
    afterBlit.srcSubpass = VK_SUBPASS_EXTERNAL;
    afterBlit.srcStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT;
    afterBlit.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    afterBlit.dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    afterBlit.dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    info.attachmentCount = 1;
    info.pAttachments = &color;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 1;
    info.pDependencies = &afterBlit;
    VkRenderPass pass = VK_NULL_HANDLE;
    vk(vkCreateRenderPass(device, &info, nullptr, &pass));
    return pass;
}

static VkSemaphore makeSemaphore(VkDevice device)
{
    const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkSemaphore semaphore = VK_NULL_HANDLE;
    vk(vkCreateSemaphore(device, &info, nullptr, &semaphore));
    return semaphore;
}

Screen::Screen(Window& window, Gpu& gpu) : window_(window), gpu_(gpu)
{
    const VkDevice device = gpu.device.device;
    check(gpu.device.surface, "the device was made without the window's options");
    format_ = pickFormat(gpu.device);
    pass_ = makePass(device, format_.format);
    acquired_ = makeSemaphore(device);
    const VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    vk(vkCreateFence(device, &fence, nullptr, &fence_));
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.queueFamilyIndex = gpu.device.queueFamily;
    vk(vkCreateCommandPool(device, &pool, nullptr, &pool_));
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool_;
    allocate.commandBufferCount = 1;
    vk(vkAllocateCommandBuffers(device, &allocate, &commands_));
    open();
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
    info.ImageCount = std::max(2u, static_cast<std::uint32_t>(targets_.size()));
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
#if IMGUI_VERSION_NUM >= 19030
    info.RenderPass = pass_;
    ImGui_ImplVulkan_Init(&info);
#else
    ImGui_ImplVulkan_Init(&info, pass_);
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
    close();
    vkDestroyDescriptorPool(device, descriptors_, nullptr);
    vkDestroyCommandPool(device, pool_, nullptr);
    vkDestroySemaphore(device, acquired_, nullptr);
    vkDestroyFence(device, fence_, nullptr);
    vkDestroyRenderPass(device, pass_, nullptr);
}

void Screen::open()
{
    const Device& d = gpu_.device;
    VkSurfaceCapabilitiesKHR can;
    vk(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(d.physical, d.surface, &can));
    asked_ = window_.size();
    extent_ = {std::clamp(asked_.x, can.minImageExtent.width, can.maxImageExtent.width),
               std::clamp(asked_.y, can.minImageExtent.height, can.maxImageExtent.height)};
    VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    info.surface = d.surface;
    info.minImageCount = can.maxImageCount ? std::min(can.minImageCount + 1, can.maxImageCount) : can.minImageCount + 1;
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = extent_;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.preTransform = can.currentTransform;
    info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR; // the one that every device has
    info.clipped = VK_TRUE;
    vk(vkCreateSwapchainKHR(d.device, &info, nullptr, &swapchain_));

    std::uint32_t count = 0;
    vk(vkGetSwapchainImagesKHR(d.device, swapchain_, &count, nullptr));
    std::vector<VkImage> images(count);
    vk(vkGetSwapchainImagesKHR(d.device, swapchain_, &count, images.data()));
    for (VkImage image : images) {
        Target target{image, VK_NULL_HANDLE, VK_NULL_HANDLE, makeSemaphore(d.device)};
        VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
        view.image = image;
        view.viewType = VK_IMAGE_VIEW_TYPE_2D;
        view.format = format_.format;
        view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vk(vkCreateImageView(d.device, &view, nullptr, &target.view));
        VkFramebufferCreateInfo framebuffer{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
        framebuffer.renderPass = pass_;
        framebuffer.attachmentCount = 1;
        framebuffer.pAttachments = &target.view;
        framebuffer.width = extent_.width;
        framebuffer.height = extent_.height;
        framebuffer.layers = 1;
        vk(vkCreateFramebuffer(d.device, &framebuffer, nullptr, &target.framebuffer));
        targets_.push_back(target);
    }
}

void Screen::close()
{
    const VkDevice device = gpu_.device.device;
    for (const Target& target : targets_) {
        vkDestroyFramebuffer(device, target.framebuffer, nullptr);
        vkDestroyImageView(device, target.view, nullptr);
        vkDestroySemaphore(device, target.drawn, nullptr);
    }
    targets_.clear();
    vkDestroySwapchainKHR(device, swapchain_, nullptr);
    swapchain_ = VK_NULL_HANDLE;
}

void Screen::record(VkCommandBuffer commands, const GpuImage& picture, std::uint32_t index)
{
    // The swapchain's image, as far as a copy needs to know it.
    VkImageMemoryBarrier2 toBlit{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    toBlit.srcStageMask = toBlit.dstStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    toBlit.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    toBlit.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    toBlit.srcQueueFamilyIndex = toBlit.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    toBlit.image = targets_[index].image;
    toBlit.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &toBlit;
    vkCmdPipelineBarrier2(commands, &dependency);

    changeLayout(commands, picture, {}, kRestLayout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkImageBlit blit{};
    blit.srcSubresource = blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    blit.srcOffsets[1] = {static_cast<std::int32_t>(picture.shape.size.x), static_cast<std::int32_t>(picture.shape.size.y), 1};
    blit.dstOffsets[1] = {static_cast<std::int32_t>(extent_.width), static_cast<std::int32_t>(extent_.height), 1};
    vkCmdBlitImage(commands, picture.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, targets_[index].image,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
    changeLayout(commands, picture, {}, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kRestLayout);

    VkRenderPassBeginInfo begin{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
    begin.renderPass = pass_;
    begin.framebuffer = targets_[index].framebuffer;
    begin.renderArea.extent = extent_;
    vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
    vkCmdEndRenderPass(commands);
}

void Screen::show(const GpuImage& picture, const std::function<void(Panel&)>& draw)
{
    const Device& d = gpu_.device;
    const glm::uvec2 size = window_.size();
    if (!size.x || !size.y) return; // minimized
    if (size != asked_) {
        vk(vkDeviceWaitIdle(d.device));
        close();
        open();
    }
    std::uint32_t index = 0;
    const VkResult acquired = vkAcquireNextImageKHR(d.device, swapchain_, UINT64_MAX, acquired_, VK_NULL_HANDLE, &index);
    if (acquired == VK_ERROR_OUT_OF_DATE_KHR) { // resized this moment: the next frame fits again
        asked_ = {};
        return;
    }
    checkVulkan("vkAcquireNextImageKHR", acquired);

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
    record(commands_, picture, index);
    vk(vkEndCommandBuffer(commands_));

    VkSemaphoreSubmitInfo wait{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO}, signal = wait;
    wait.semaphore = acquired_;
    wait.stageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    signal.semaphore = targets_[index].drawn;
    signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    buffer.commandBuffer = commands_;
    VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit.waitSemaphoreInfoCount = submit.commandBufferInfoCount = submit.signalSemaphoreInfoCount = 1;
    submit.pWaitSemaphoreInfos = &wait;
    submit.pCommandBufferInfos = &buffer;
    submit.pSignalSemaphoreInfos = &signal;
    vk(vkQueueSubmit2(d.queue, 1, &submit, fence_));

    VkPresentInfoKHR present{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    present.waitSemaphoreCount = present.swapchainCount = 1;
    present.pWaitSemaphores = &targets_[index].drawn;
    present.pSwapchains = &swapchain_;
    present.pImageIndices = &index;
    const VkResult shown = vkQueuePresentKHR(d.queue, &present);
    vk(vkWaitForFences(d.device, 1, &fence_, VK_TRUE, UINT64_MAX));
    vk(vkResetFences(d.device, 1, &fence_));
    if (shown == VK_ERROR_OUT_OF_DATE_KHR)
        asked_ = {};
    else
        checkVulkan("vkQueuePresentKHR", shown);
}
}
