// Picks the device, asks for what Afterglow needs, switches on what it can use, and runs one-off work.
#include "engine/gpu/device.hpp"
#include "engine/core/error.hpp"
#include "engine/gpu/instance.hpp"
#include <algorithm>
#include <cstdlib>
#include <optional>

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

    explicit Features(bool rays)
    {
        core.pNext = &v11;
        v11.pNext = &v12;
        v12.pNext = &v13;
        v13.pNext = rays ? &acceleration : nullptr;
        acceleration.pNext = &rayQuery;
    }
    Features(const Features&) = delete;
};

struct Feature {
    const char* name;
    VkBool32& wanted;
    VkBool32 had;
};

static std::vector<Feature> required(Features& want, const Features& have)
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
            {"drawIndirectFirstInstance", want.core.features.drawIndirectFirstInstance, have.core.features.drawIndirectFirstInstance},
            {"depthClamp", want.core.features.depthClamp, have.core.features.depthClamp},
            {"shaderStorageImageWriteWithoutFormat", want.core.features.shaderStorageImageWriteWithoutFormat,
             have.core.features.shaderStorageImageWriteWithoutFormat}};
}

// The first required feature that the device lacks.
static std::optional<std::string> missingFeature(VkPhysicalDevice physical)
{
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    if (properties.apiVersion < VK_API_VERSION_1_3) return "Vulkan 1.3";
    Features have(false), want(false);
    vkGetPhysicalDeviceFeatures2(physical, &have.core);
    for (const Feature& feature : required(want, have))
        if (!feature.had) return feature.name;
    return {};
}

static std::optional<std::uint32_t> pickFamily(VkPhysicalDevice physical, VkSurfaceKHR surface)
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

// An index, part of a name, or the best that is fit.
static VkPhysicalDevice pick(VkInstance instance, VkSurfaceKHR surface, const std::string& wanted)
{
    const std::vector<VkPhysicalDevice> devices = physicalDevices(instance);
    if (devices.empty())
        throw Error("no Vulkan device: install a driver, for a plain CPU: apt install mesa-vulkan-drivers", Exit::noDevice);
    VkPhysicalDevice best = VK_NULL_HANDLE;
    std::string seen, why;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(devices[i], &properties);
        seen += (i ? "; " : "") + describeDevice(devices[i], i);
        const std::string name = properties.deviceName;
        if (!wanted.empty() && wanted != std::to_string(i) && name.find(wanted) == std::string::npos) continue;
        if (const auto missing = missingFeature(devices[i]))
            why = " (" + name + " lacks " + *missing + ")";
        else if (!pickFamily(devices[i], surface))
            why = " (" + name + " cannot show pictures in this window)";
        else if (!best || rank(devices[i]) > rank(best))
            best = devices[i];
    }
    if (best) return best;
    if (!wanted.empty())
        throw Error("no Vulkan device is called '" + wanted + "' and fit for use" + why + "; there is " + seen, Exit::noDevice);
    throw Error("no Vulkan device with Vulkan 1.3 and what Afterglow needs" + why + "; for a plain CPU: apt install mesa-vulkan-drivers",
                Exit::noDevice);
}

DeviceOptions deviceOptions(const std::string& device)
{
    DeviceOptions options;
    options.device = device;
    const char* validation = std::getenv("AFTERGLOW_VALIDATION");
    options.validation = validation && std::string(validation) == "1";
    return options;
}

Device::Device(const DeviceOptions& options)
{
    instance = makeInstance(options.validation, options.instanceExtensions);
    try {
        if (options.validation) messenger_ = makeMessenger(instance, messages);
        if (options.surface) surface = options.surface(instance);
        physical = pick(instance, surface, options.device);
        open(options);
    } catch (...) {
        close();
        throw;
    }
}

void Device::open(const DeviceOptions& options)
{
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    deviceName = properties.deviceName;
    limits = properties.limits;
    queueFamily = *pickFamily(physical, surface);

    // Rays need three extensions; absence is expected and said in `rayQuery`.
    std::vector<const char*> extensions = {VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, VK_KHR_RAY_QUERY_EXTENSION_NAME,
                                           VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};
    rayQuery = std::all_of(extensions.begin(), extensions.end(), [&](const char* name) { return hasExtension(physical, name); });
    Features have(rayQuery);
    vkGetPhysicalDeviceFeatures2(physical, &have.core);
    rayQuery = rayQuery && have.acceleration.accelerationStructure && have.rayQuery.rayQuery;
    if (!rayQuery) extensions.clear();
    if (surface) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);

    Features want(rayQuery);
    for (const Feature& feature : required(want, have)) feature.wanted = VK_TRUE;
    want.acceleration.accelerationStructure = want.rayQuery.rayQuery = rayQuery;
    const VkPhysicalDeviceFeatures& can = have.core.features;
    want.core.features.samplerAnisotropy = anisotropy = can.samplerAnisotropy;
    want.core.features.shaderInt64 = int64 = can.shaderInt64;
    want.core.features.geometryShader = can.geometryShader; // gl_PrimitiveID in fragment shaders
    want.core.features.multiDrawIndirect = can.multiDrawIndirect;
    want.core.features.shaderStorageImageReadWithoutFormat = can.shaderStorageImageReadWithoutFormat;
    want.core.features.vertexPipelineStoresAndAtomics = can.vertexPipelineStoresAndAtomics;
    want.v12.shaderStorageBufferArrayNonUniformIndexing = have.v12.shaderStorageBufferArrayNonUniformIndexing;
    want.v12.descriptorBindingVariableDescriptorCount = have.v12.descriptorBindingVariableDescriptorCount;

    const float priority = 1;
    VkDeviceQueueCreateInfo queueInfo{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queueInfo.queueFamilyIndex = queueFamily;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    info.pNext = &want.core;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    vk(vkCreateDevice(physical, &info, nullptr, &device));
    vkGetDeviceQueue(device, queueFamily, 0, &queue);

    std::uint32_t count = queueFamily + 1;
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    if (families[queueFamily].timestampValidBits) timestampMilliseconds = static_cast<double>(limits.timestampPeriod) * 1e-6;

    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool.queueFamilyIndex = queueFamily;
    vk(vkCreateCommandPool(device, &pool, nullptr, &pool_));
    const VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    vk(vkCreateFence(device, &fence, nullptr, &fence_));
    loadFunctions(options);
}

void Device::loadFunctions(const DeviceOptions& options)
{
    const auto load = [&](auto& function, const char* text) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(vkGetDeviceProcAddr(device, text));
    };
    if (options.validation) load(setName_, "vkSetDebugUtilsObjectNameEXT");
    if (!rayQuery) return;
    load(createAccelerationStructure, "vkCreateAccelerationStructureKHR");
    load(destroyAccelerationStructure, "vkDestroyAccelerationStructureKHR");
    load(accelerationStructureBuildSizes, "vkGetAccelerationStructureBuildSizesKHR");
    load(cmdBuildAccelerationStructures, "vkCmdBuildAccelerationStructuresKHR");
    load(accelerationStructureAddress, "vkGetAccelerationStructureDeviceAddressKHR");
}

Device::~Device() { close(); }

void Device::close()
{
    if (device) {
        vkDestroyFence(device, fence_, nullptr);
        vkDestroyCommandPool(device, pool_, nullptr);
        vkDestroyDevice(device, nullptr);
    }
    if (surface) vkDestroySurfaceKHR(instance, surface, nullptr);
    if (messenger_) destroyMessenger(instance, messenger_);
    vkDestroyInstance(instance, nullptr);
}

void Device::submit(const std::function<void(VkCommandBuffer)>& record)
{
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool_;
    allocate.commandBufferCount = 1;
    VkCommandBufferSubmitInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    vk(vkAllocateCommandBuffers(device, &allocate, &commands.commandBuffer));
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    vk(vkBeginCommandBuffer(commands.commandBuffer, &begin));
    record(commands.commandBuffer);
    vk(vkEndCommandBuffer(commands.commandBuffer));

    VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &commands;
    vk(vkQueueSubmit2(queue, 1, &submit, fence_));
    vk(vkWaitForFences(device, 1, &fence_, VK_TRUE, UINT64_MAX));
    vk(vkResetFences(device, 1, &fence_));
    vkFreeCommandBuffers(device, pool_, 1, &commands.commandBuffer);
}

void Device::name(VkObjectType type, std::uint64_t object, const std::string& text) const
{
    if (!setName_) return;
    VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
    info.objectType = type;
    info.objectHandle = object;
    info.pObjectName = text.c_str();
    vk(setName_(device, &info));
}
}
