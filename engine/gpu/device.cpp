// The device: opened with what Afterglow needs and what it can use, and its one-off work.
#include "engine/gpu/device.hpp"
#include "engine/gpu/instance.hpp"
#include "engine/gpu/pick.hpp"
#include <algorithm>
#include <cstdlib>

namespace afterglow
{
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
        physical = pickDevice(instance, surface, options.device);
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
    driverVersion = properties.driverVersion;
    limits = properties.limits;
    queueFamily = *pickFamily(physical, surface);

    // Rays are asked by queries, by programs, by both or not at all: the driver of an Nvidia H100 has programs alone.
    const auto has = [&](const char* name) { return hasExtension(physical, name); };
    const bool structures = has(VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME) && has(VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME);
    rayQuery = options.rayQuery && structures && has(VK_KHR_RAY_QUERY_EXTENSION_NAME);
    rayPipeline = options.rayPipeline && structures && has(VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME);
    Features have(rayQuery, rayPipeline);
    vkGetPhysicalDeviceFeatures2(physical, &have.core);
    rayQuery = rayQuery && have.acceleration.accelerationStructure && have.rayQuery.rayQuery;
    rayPipeline = rayPipeline && have.acceleration.accelerationStructure && have.rayPipeline.rayTracingPipeline;
    std::vector<const char*> extensions;
    if (rayQuery || rayPipeline)
        extensions = {VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};
    if (rayQuery) extensions.push_back(VK_KHR_RAY_QUERY_EXTENSION_NAME);
    if (rayPipeline) extensions.push_back(VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME);
    if (surface) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);

    Features want(rayQuery, rayPipeline);
    for (const Feature& feature : required(want, have)) feature.wanted = VK_TRUE;
    want.acceleration.accelerationStructure = rayQuery || rayPipeline;
    want.rayQuery.rayQuery = rayQuery;
    want.rayPipeline.rayTracingPipeline = rayPipeline;
    want.core.features.vertexPipelineStoresAndAtomics = have.core.features.vertexPipelineStoresAndAtomics;
    want.v12.shaderStorageBufferArrayNonUniformIndexing = have.v12.shaderStorageBufferArrayNonUniformIndexing;

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
    if (!rayQuery && !rayPipeline) return;
    load(createAccelerationStructure, "vkCreateAccelerationStructureKHR");
    load(destroyAccelerationStructure, "vkDestroyAccelerationStructureKHR");
    load(accelerationStructureBuildSizes, "vkGetAccelerationStructureBuildSizesKHR");
    load(cmdBuildAccelerationStructures, "vkCmdBuildAccelerationStructuresKHR");
    load(accelerationStructureAddress, "vkGetAccelerationStructureDeviceAddressKHR");
    if (!rayPipeline) return;
    load(createRayTracingPipelines, "vkCreateRayTracingPipelinesKHR");
    load(shaderGroupHandles, "vkGetRayTracingShaderGroupHandlesKHR");
    load(cmdTraceRays, "vkCmdTraceRaysKHR");
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
