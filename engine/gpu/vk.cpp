// Results of Vulkan calls in words.
#include "engine/gpu/vk.hpp"
#include "engine/core/error.hpp"
#include <string>

namespace afterglow
{
static std::string resultName(VkResult result)
{
    switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "out of host memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return "out of GPU memory";
    case VK_ERROR_INITIALIZATION_FAILED:
        return "initialization failed";
    case VK_ERROR_DEVICE_LOST:
        return "device lost";
    case VK_ERROR_LAYER_NOT_PRESENT:
        return "layer not present";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
        return "extension not present";
    case VK_ERROR_FEATURE_NOT_PRESENT:
        return "feature not present";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
        return "no driver";
    case VK_ERROR_FORMAT_NOT_SUPPORTED:
        return "format not supported";
    case VK_ERROR_SURFACE_LOST_KHR:
        return "surface lost";
    case VK_ERROR_OUT_OF_DATE_KHR:
        return "swapchain out of date";
    default:
        return "result " + std::to_string(result);
    }
}

void failedVulkan(const char* call, VkResult result)
{
    const std::string text(call);
    const bool full = result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY;
    throw Error("Vulkan: " + resultName(result) + " in " + text.substr(0, text.find('(')) +
                    (full ? "; use a smaller --size or level, or another --device" : ""),
                Exit::noDevice);
}
}
