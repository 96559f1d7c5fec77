// The one way to call Vulkan: vk(vkDoSomething(...)) throws an Error that names the call and its result.
#pragma once
#include <vulkan/vulkan.h>

namespace afterglow
{
[[noreturn]] void failedVulkan(const char* call, VkResult result);
inline void checkVulkan(const char* call, VkResult result)
{
    if (result < 0) failedVulkan(call, result); // positive results (VK_SUBOPTIMAL_KHR ...) are not failures
}
}

#define vk(call) ::afterglow::checkVulkan(#call, call)
