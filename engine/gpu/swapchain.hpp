// Inside of row 2: the images of a window's surface, to be drawn into and shown in turn.
#pragma once
#include "engine/gpu/device.hpp"
#include <glm/glm.hpp>
#include <optional>

namespace afterglow
{
class Swapchain
{
public:
    // For a window of `size` pixels. Throws Error (exit 4) when its display takes no 8-bit pictures.
    Swapchain(const Device& device, glm::uvec2 size);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    // The index of the next image, in a window that has `size` by now; nothing when it changes this moment: the next frame fits again.
    std::optional<std::uint32_t> acquire(glm::uvec2 size);
    void present(std::uint32_t index);

    struct Target {
        VkImage image;
        VkImageView view;
        VkFramebuffer framebuffer;
        VkSemaphore drawn; // present() waits for it
    };
    std::vector<Target> targets;
    VkExtent2D extent{};                   // of each, pixels
    VkRenderPass pass = VK_NULL_HANDLE;    // what the panels draw into: older ImGui knows no dynamic rendering
    VkSemaphore acquired = VK_NULL_HANDLE; // signalled when the acquired image may be written

private:
    void open(glm::uvec2 size);
    void close();
    const Device& device_;
    VkSurfaceFormatKHR format_{};
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    glm::uvec2 asked_{0}; // the window's size when the swapchain was opened; 0: open it anew
};
}
