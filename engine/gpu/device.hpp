// The Vulkan 1.3 device, with or without a window: which one is picked, what it can do, what its validation layer said.
#pragma once
#include "engine/gpu/vk.hpp"
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace afterglow
{
struct DeviceOptions {
    std::string device;      // --device: an index, or part of a name; empty: discrete before integrated before CPU
    bool validation = false; // the validation layer with synchronization validation; its messages are kept in the device
    bool rayQuery = true;    // false: not used where the device has them
    bool rayPipeline = true; // the same
    std::vector<const char*> instanceExtensions;     // what the window's surface needs
    std::function<VkSurfaceKHR(VkInstance)> surface; // empty: headless
};

// The program's options: validation is on when AFTERGLOW_VALIDATION=1.
DeviceOptions deviceOptions(const std::string& device);

class Device
{
public:
    // Throws Error (exit 4) when there is no Vulkan 1.3 device, none of that name, or no validation layer although it was asked for.
    explicit Device(const DeviceOptions& options = {});
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    // Records, submits and waits: for uploads, acceleration structures, readback. Frames go through the graph.
    void submit(const std::function<void(VkCommandBuffer)>& record);
    void wait() { vk(vkDeviceWaitIdle(device)); }

    // Names an object for the validation layer and for capture tools; free when neither listens.
    void name(VkObjectType type, std::uint64_t object, const std::string& text) const;

    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE; // the only one: graphics, compute, transfer, and present when there is a surface
    std::uint32_t queueFamily = 0;
    VkSurfaceKHR surface = VK_NULL_HANDLE;

    std::string deviceName;
    std::uint32_t driverVersion = 0; // as its vendor counts
    VkPhysicalDeviceLimits limits{};
    bool rayQuery = false;             // acceleration structures, asked by ray queries
    bool rayPipeline = false;          // and by pipelines of ray programs, or by these alone
    double timestampMilliseconds = 0;  // ms per tick of a timestamp; 0: the device has none
    std::vector<std::string> messages; // what the validation layer said since the device was made (warnings and errors)

    // VK_KHR_acceleration_structure, loaded when rayQuery or rayPipeline.
    PFN_vkCreateAccelerationStructureKHR createAccelerationStructure = nullptr;
    PFN_vkDestroyAccelerationStructureKHR destroyAccelerationStructure = nullptr;
    PFN_vkGetAccelerationStructureBuildSizesKHR accelerationStructureBuildSizes = nullptr;
    PFN_vkCmdBuildAccelerationStructuresKHR cmdBuildAccelerationStructures = nullptr;
    PFN_vkGetAccelerationStructureDeviceAddressKHR accelerationStructureAddress = nullptr;

    // VK_KHR_ray_tracing_pipeline, loaded when rayPipeline.
    PFN_vkCreateRayTracingPipelinesKHR createRayTracingPipelines = nullptr;
    PFN_vkGetRayTracingShaderGroupHandlesKHR shaderGroupHandles = nullptr;
    PFN_vkCmdTraceRaysKHR cmdTraceRays = nullptr;

private:
    void open(const DeviceOptions& options);
    void loadFunctions(const DeviceOptions& options);
    void close();
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    PFN_vkSetDebugUtilsObjectNameEXT setName_ = nullptr;
};

// One line a device, in the order of their indices: `0: llvmpipe (LLVM 15.0.6, 256 bits), CPU, Vulkan 1.4.305, ray queries`.
std::vector<std::string> deviceList();
}
