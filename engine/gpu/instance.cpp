// The Vulkan instance: layers, messages, devices.
#include "engine/gpu/instance.hpp"
#include "engine/core/error.hpp"
#include "engine/gpu/device.hpp"
#include <algorithm>
#include <cstring>

namespace afterglow
{
static const char* const kValidationLayer = "VK_LAYER_KHRONOS_validation";
static const char* const kAdvice = "install a Vulkan driver, for a plain CPU: apt install mesa-vulkan-drivers";

static bool hasLayer(const char* name)
{
    std::uint32_t count = 0;
    vk(vkEnumerateInstanceLayerProperties(&count, nullptr));
    std::vector<VkLayerProperties> layers(count);
    vk(vkEnumerateInstanceLayerProperties(&count, layers.data()));
    return std::any_of(layers.begin(), layers.end(), [&](const auto& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

VkInstance makeInstance(bool validation, const std::vector<const char*>& extensions)
{
    if (validation && !hasLayer(kValidationLayer))
        throw Error("Vulkan validation was asked for, but its layer is missing: apt install vulkan-validationlayers", Exit::noDevice);

    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "afterglow";
    application.apiVersion = VK_API_VERSION_1_3;

    const VkValidationFeatureEnableEXT synchronization = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = &synchronization;

    std::vector<const char*> enabled = extensions;
    if (validation) enabled.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pNext = validation ? &features : nullptr;
    info.pApplicationInfo = &application;
    info.enabledLayerCount = validation ? 1 : 0;
    info.ppEnabledLayerNames = &kValidationLayer;
    info.enabledExtensionCount = static_cast<std::uint32_t>(enabled.size());
    info.ppEnabledExtensionNames = enabled.data();
    VkInstance instance = VK_NULL_HANDLE;
    const VkResult result = vkCreateInstance(&info, nullptr, &instance);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER || result == VK_ERROR_INITIALIZATION_FAILED)
        throw Error(std::string("no Vulkan device: no driver was found; ") + kAdvice, Exit::noDevice);
    checkVulkan("vkCreateInstance", result);
    return instance;
}

// An attachment of no format is one that is not there: what a shader writes to it is discarded (VkPipelineRenderingCreateInfo), which is
// how a pass leaves out what nobody asks for. Layers of 2022 and 2023, Debian 12's among them, take it for a format that does not match;
// those of 2025, Debian 13's, remark that the write is unused.
static bool isMistaken(const char* message)
{
    return std::strstr(message, "this write is unused") ||
           (std::strstr(message, "Shader-InterfaceTypeMismatch") && std::strstr(message, "of type `VK_FORMAT_UNDEFINED` does not match"));
}

static VKAPI_ATTR VkBool32 VKAPI_CALL keepMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                                  const VkDebugUtilsMessengerCallbackDataEXT* data, void* messages)
{
    if (!isMistaken(data->pMessage)) static_cast<std::vector<std::string>*>(messages)->push_back(data->pMessage);
    return VK_FALSE;
}

VkDebugUtilsMessengerEXT makeMessenger(VkInstance instance, std::vector<std::string>& messages)
{
    // Performance advice is left out: what is fast is measured, not guessed.
    VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = keepMessage;
    info.pUserData = &messages;
    const auto create =
        reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(vkGetInstanceProcAddr(instance, "vkCreateDebugUtilsMessengerEXT"));
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    vk(create(instance, &info, nullptr, &messenger));
    return messenger;
}

void destroyMessenger(VkInstance instance, VkDebugUtilsMessengerEXT messenger)
{
    const auto destroy =
        reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"));
    destroy(instance, messenger, nullptr);
}

std::vector<VkPhysicalDevice> physicalDevices(VkInstance instance)
{
    std::uint32_t count = 0;
    vk(vkEnumeratePhysicalDevices(instance, &count, nullptr));
    std::vector<VkPhysicalDevice> devices(count);
    if (count) vk(vkEnumeratePhysicalDevices(instance, &count, devices.data()));
    return devices;
}

bool hasExtension(VkPhysicalDevice physical, const char* name)
{
    std::uint32_t count = 0;
    vk(vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr));
    std::vector<VkExtensionProperties> extensions(count);
    vk(vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data()));
    return std::any_of(extensions.begin(), extensions.end(), [&](const auto& e) { return std::strcmp(e.extensionName, name) == 0; });
}

std::string raysInWords(bool queries, bool programs)
{
    return queries ? "ray queries" : programs ? "ray-tracing pipelines, no ray queries" : "no ray queries";
}

std::string describeDevice(VkPhysicalDevice physical, std::size_t index)
{
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    const auto kind = [&]() -> std::string {
        switch (properties.deviceType) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return "discrete GPU";
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return "integrated GPU";
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return "virtual GPU";
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return "CPU";
        default:
            return "other";
        }
    };
    const std::uint32_t v = properties.apiVersion;
    return std::to_string(index) + ": " + properties.deviceName + ", " + kind() + ", Vulkan " + std::to_string(VK_API_VERSION_MAJOR(v)) +
           "." + std::to_string(VK_API_VERSION_MINOR(v)) + "." + std::to_string(VK_API_VERSION_PATCH(v)) + ", " +
           raysInWords(hasExtension(physical, VK_KHR_RAY_QUERY_EXTENSION_NAME),
                       hasExtension(physical, VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME));
}

std::vector<std::string> deviceList()
{
    const VkInstance instance = makeInstance(false, {});
    std::vector<std::string> lines;
    for (VkPhysicalDevice physical : physicalDevices(instance)) lines.push_back(describeDevice(physical, lines.size()));
    vkDestroyInstance(instance, nullptr);
    return lines;
}
}
