// Inside of row 2: what a device must be able to do, and which one is picked.
#pragma once
#include "engine/gpu/vk.hpp"
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace afterglow
{
// The chain of feature structs, each linked to the next.
struct Features {
    VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    VkPhysicalDeviceVulkan11Features v11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
    VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceAccelerationStructureFeaturesKHR acceleration{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR};
    VkPhysicalDeviceRayQueryFeaturesKHR rayQuery{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR};
    VkPhysicalDeviceRayTracingPipelineFeaturesKHR rayPipeline{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_FEATURES_KHR};

    // Of rays, what the device knows of: a struct of an extension that is absent may not stand in the chain.
    Features(bool queries, bool programs)
    {
        core.pNext = &v11;
        v11.pNext = &v12;
        v12.pNext = &v13;
        v13.pNext = queries || programs ? &acceleration : nullptr;
        acceleration.pNext = queries ? static_cast<void*>(&rayQuery) : &rayPipeline;
        rayQuery.pNext = programs ? &rayPipeline : nullptr;
    }
    Features(const Features&) = delete;
};

struct Feature {
    const char* name;
    VkBool32& wanted;
    VkBool32 had;
};

// What Afterglow cannot do without.
std::vector<Feature> required(Features& want, const Features& have);

// The family of the one queue: graphics, compute, and present when there is a surface.
std::optional<std::uint32_t> pickFamily(VkPhysicalDevice physical, VkSurfaceKHR surface);

// `wanted`: an index, part of a name, or empty: the best that is fit. Throws Error (exit 4) when there is none.
VkPhysicalDevice pickDevice(VkInstance instance, VkSurfaceKHR surface, const std::string& wanted);
}
