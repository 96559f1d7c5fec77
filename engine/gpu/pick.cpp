// Which device: the one that was asked for, or the best that lacks nothing.
#include "engine/gpu/pick.hpp"
#include "engine/core/error.hpp"
#include "engine/gpu/instance.hpp"

namespace afterglow
{
std::vector<Feature> required(Features& want, const Features& have)
{
    return {{"synchronization2", want.v13.synchronization2, have.v13.synchronization2},
            {"dynamicRendering", want.v13.dynamicRendering, have.v13.dynamicRendering},
            {"maintenance4", want.v13.maintenance4, have.v13.maintenance4},
            {"scalarBlockLayout", want.v12.scalarBlockLayout, have.v12.scalarBlockLayout},
            {"bufferDeviceAddress", want.v12.bufferDeviceAddress, have.v12.bufferDeviceAddress},
            {"descriptorIndexing", want.v12.descriptorIndexing, have.v12.descriptorIndexing},
            {"runtimeDescriptorArray", want.v12.runtimeDescriptorArray, have.v12.runtimeDescriptorArray},
            {"descriptorBindingPartiallyBound", want.v12.descriptorBindingPartiallyBound, have.v12.descriptorBindingPartiallyBound},
            {"shaderSampledImageArrayNonUniformIndexing", want.v12.shaderSampledImageArrayNonUniformIndexing,
             have.v12.shaderSampledImageArrayNonUniformIndexing},
            {"hostQueryReset", want.v12.hostQueryReset, have.v12.hostQueryReset},
            {"shaderDrawParameters", want.v11.shaderDrawParameters, have.v11.shaderDrawParameters},
            {"independentBlend", want.core.features.independentBlend, have.core.features.independentBlend},
            {"imageCubeArray", want.core.features.imageCubeArray, have.core.features.imageCubeArray},
            {"fragmentStoresAndAtomics", want.core.features.fragmentStoresAndAtomics, have.core.features.fragmentStoresAndAtomics},
            {"shaderStorageImageWriteWithoutFormat", want.core.features.shaderStorageImageWriteWithoutFormat,
             have.core.features.shaderStorageImageWriteWithoutFormat}};
}

// The first required feature that the device lacks.
static std::optional<std::string> missingFeature(VkPhysicalDevice physical)
{
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    if (properties.apiVersion < VK_API_VERSION_1_3) return "Vulkan 1.3";
    Features have(false, false), want(false, false);
    vkGetPhysicalDeviceFeatures2(physical, &have.core);
    for (const Feature& feature : required(want, have))
        if (!feature.had) return feature.name;
    return {};
}

std::optional<std::uint32_t> pickFamily(VkPhysicalDevice physical, VkSurfaceKHR surface)
{
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    const VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t i = 0; i < count; ++i) {
        VkBool32 presents = VK_TRUE;
        if (surface) vk(vkGetPhysicalDeviceSurfaceSupportKHR(physical, i, surface, &presents));
        if ((families[i].queueFlags & both) == both && presents) return i;
    }
    return {};
}

static int rank(VkPhysicalDevice physical)
{
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    switch (properties.deviceType) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return 3;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return 2;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return 1;
    default:
        return 0;
    }
}

VkPhysicalDevice pickDevice(VkInstance instance, VkSurfaceKHR surface, const std::string& wanted)
{
    const std::vector<VkPhysicalDevice> devices = physicalDevices(instance);
    if (devices.empty())
        throw Error("no Vulkan device: install a driver, for a plain CPU: apt install mesa-vulkan-drivers", Exit::noDevice);
    VkPhysicalDevice best = VK_NULL_HANDLE;
    const bool isNumber = !wanted.empty() && wanted.find_first_not_of("0123456789") == std::string::npos; // an index, no part of a name
    std::string seen, why;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(devices[i], &properties);
        seen += (i ? "; " : "") + describeDevice(devices[i], i);
        const std::string name = properties.deviceName;
        if (!wanted.empty() && !(isNumber ? wanted == std::to_string(i) : name.find(wanted) != std::string::npos)) continue;
        if (const auto missing = missingFeature(devices[i]))
            why = " (" + name + " lacks " + *missing + ")";
        else if (!pickFamily(devices[i], surface))
            why = " (" + name + " cannot show pictures in this window)";
        else if (!best || rank(devices[i]) > rank(best))
            best = devices[i];
    }
    if (best) return best;
    if (!wanted.empty())
        throw Error("no Vulkan device " + std::string(isNumber ? "has the index " : "is called ") + "'" + wanted + "' and is fit for use" +
                        why + "; there is " + seen,
                    Exit::noDevice);
    throw Error("no Vulkan device with Vulkan 1.3 and what Afterglow needs" + why + "; for a plain CPU: apt install mesa-vulkan-drivers",
                Exit::noDevice);
}
}
