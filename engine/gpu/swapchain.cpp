// Opened for a size of the window, and anew when that changes.
#include "engine/gpu/swapchain.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

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

Swapchain::Swapchain(const Device& device, glm::uvec2 size) : device_(device)
{
    check(device.surface, "the device was made without the window's options");
    format_ = pickFormat(device);
    pass = makePass(device.device, format_.format);
    acquired = makeSemaphore(device.device);
    open(size);
}

Swapchain::~Swapchain()
{
    close();
    vkDestroySemaphore(device_.device, acquired, nullptr);
    vkDestroyRenderPass(device_.device, pass, nullptr);
}

void Swapchain::open(glm::uvec2 size)
{
    const Device& d = device_;
    VkSurfaceCapabilitiesKHR can;
    vk(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(d.physical, d.surface, &can));
    asked_ = size;
    extent = {std::clamp(asked_.x, can.minImageExtent.width, can.maxImageExtent.width),
              std::clamp(asked_.y, can.minImageExtent.height, can.maxImageExtent.height)};
    VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    info.surface = d.surface;
    info.minImageCount = can.maxImageCount ? std::min(can.minImageCount + 1, can.maxImageCount) : can.minImageCount + 1;
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = extent;
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
        framebuffer.renderPass = pass;
        framebuffer.attachmentCount = 1;
        framebuffer.pAttachments = &target.view;
        framebuffer.width = extent.width;
        framebuffer.height = extent.height;
        framebuffer.layers = 1;
        vk(vkCreateFramebuffer(d.device, &framebuffer, nullptr, &target.framebuffer));
        targets.push_back(target);
    }
}

void Swapchain::close()
{
    const VkDevice device = device_.device;
    for (const Target& target : targets) {
        vkDestroyFramebuffer(device, target.framebuffer, nullptr);
        vkDestroyImageView(device, target.view, nullptr);
        vkDestroySemaphore(device, target.drawn, nullptr);
    }
    targets.clear();
    vkDestroySwapchainKHR(device, swapchain_, nullptr);
    swapchain_ = VK_NULL_HANDLE;
}

std::optional<std::uint32_t> Swapchain::acquire(glm::uvec2 size)
{
    if (size != asked_) {
        vk(vkDeviceWaitIdle(device_.device));
        close();
        open(size);
    }
    std::uint32_t index = 0;
    const VkResult result = vkAcquireNextImageKHR(device_.device, swapchain_, UINT64_MAX, acquired, VK_NULL_HANDLE, &index);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) {
        asked_ = {};
        return {};
    }
    checkVulkan("vkAcquireNextImageKHR", result);
    return index;
}

void Swapchain::present(std::uint32_t index)
{
    VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    info.waitSemaphoreCount = info.swapchainCount = 1;
    info.pWaitSemaphores = &targets[index].drawn;
    info.pSwapchains = &swapchain_;
    info.pImageIndices = &index;
    const VkResult result = vkQueuePresentKHR(device_.queue, &info);
    if (result == VK_ERROR_OUT_OF_DATE_KHR)
        asked_ = {};
    else
        checkVulkan("vkQueuePresentKHR", result);
}
}
