#include "engine/gpu/acceleration_structure.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
AccelerationStructure& AccelerationStructure::operator=(AccelerationStructure&& other) noexcept
{
    std::swap(structure, other.structure);
    std::swap(address, other.address);
    std::swap(storage, other.storage);
    std::swap(device_, other.device_);
    return *this;
}

AccelerationStructure::~AccelerationStructure()
{
    if (device_) device_->destroyAccelerationStructure(device_->device, structure, nullptr);
}

static VkPhysicalDeviceAccelerationStructurePropertiesKHR propertiesOf(const Device& device)
{
    VkPhysicalDeviceAccelerationStructurePropertiesKHR own{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR};
    VkPhysicalDeviceProperties2 all{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &own, {}};
    vkGetPhysicalDeviceProperties2(device.physical, &all);
    return own;
}

std::uint64_t mostRayPrimitives(const Device& device)
{
    constexpr std::uint64_t kCustomIndices = 1u << 24; // an instance's own number has 24 bits
    const auto properties = propertiesOf(device);
    return std::min({properties.maxPrimitiveCount, properties.maxInstanceCount, kCustomIndices - 1});
}

// One build on the device, waited for.
struct AccelerationBuild {
    // `result`: empty, or one of as many primitives, which is built anew in its place.
    static void run(Memory& memory, const std::string& name, VkAccelerationStructureTypeKHR type,
                    const VkAccelerationStructureGeometryKHR& geometry, std::uint32_t primitives, AccelerationStructure& result)
    {
        Device& device = memory.device;
        VkAccelerationStructureBuildGeometryInfoKHR info{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR};
        info.type = type;
        info.flags = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
        info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
        info.geometryCount = 1;
        info.pGeometries = &geometry;
        VkAccelerationStructureBuildSizesInfoKHR sizes{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR};
        device.accelerationStructureBuildSizes(device.device, VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &info, &primitives, &sizes);

        if (!result) create(memory, name, type, sizes.accelerationStructureSize, result);
        const VkDeviceSize alignment = std::max(propertiesOf(device).minAccelerationStructureScratchOffsetAlignment, 1u);
        const GpuBuffer scratch = memory.buffer(name + " scratch", sizes.buildScratchSize + alignment, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
        info.dstAccelerationStructure = result.structure;
        info.scratchData.deviceAddress = (scratch.address + alignment - 1) / alignment * alignment;
        const VkAccelerationStructureBuildRangeInfoKHR range{primitives, 0, 0, 0};
        const VkAccelerationStructureBuildRangeInfoKHR* ranges = &range;
        device.submit([&](VkCommandBuffer commands) {
            device.cmdBuildAccelerationStructures(commands, 1, &info, &ranges);
            // For the structure that is built upon this one, and for every shader after
            VkMemoryBarrier2 built{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
            built.srcStageMask = VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR;
            built.srcAccessMask = VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR;
            built.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
            built.dstAccessMask = VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR;
            VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
            dependency.memoryBarrierCount = 1;
            dependency.pMemoryBarriers = &built;
            vkCmdPipelineBarrier2(commands, &dependency);
        });
    }

private:
    static void create(Memory& memory, const std::string& name, VkAccelerationStructureTypeKHR type, VkDeviceSize bytes,
                       AccelerationStructure& result)
    {
        Device& device = memory.device;
        result.storage = memory.buffer(name, bytes, VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR);
        VkAccelerationStructureCreateInfoKHR info{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR};
        info.buffer = result.storage.buffer;
        info.size = bytes;
        info.type = type;
        vk(device.createAccelerationStructure(device.device, &info, nullptr, &result.structure));
        result.device_ = &device;
        device.name(VK_OBJECT_TYPE_ACCELERATION_STRUCTURE_KHR, reinterpret_cast<std::uint64_t>(result.structure), name);
        VkAccelerationStructureDeviceAddressInfoKHR address{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR};
        address.accelerationStructure = result.structure;
        result.address = device.accelerationStructureAddress(device.device, &address);
    }
};

AccelerationStructure buildTriangles(Memory& memory, const std::string& name, const TriangleRange& range)
{
    check(range.triangleCount > 0, "an acceleration structure of no triangle: leave it out");
    VkAccelerationStructureGeometryKHR geometry{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR};
    geometry.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
    geometry.flags =
        range.candidates == Candidates::opaque ? VK_GEOMETRY_OPAQUE_BIT_KHR : VK_GEOMETRY_NO_DUPLICATE_ANY_HIT_INVOCATION_BIT_KHR;
    VkAccelerationStructureGeometryTrianglesDataKHR& triangles = geometry.geometry.triangles;
    triangles = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR};
    triangles.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
    triangles.vertexData.deviceAddress = range.vertices->address;
    triangles.vertexStride = 3 * sizeof(float);
    triangles.maxVertex = range.vertexCount - 1;
    triangles.indexType = VK_INDEX_TYPE_UINT32;
    triangles.indexData.deviceAddress = range.indices->address + VkDeviceSize(range.firstTriangle) * 3 * sizeof(std::uint32_t);
    AccelerationStructure result;
    AccelerationBuild::run(memory, name, VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, geometry, range.triangleCount, result);
    return result;
}

void buildInstances(Memory& memory, const std::string& name, std::span<const PlacedStructure> placed, AccelerationStructure& level)
{
    std::vector<VkAccelerationStructureInstanceKHR> instances;
    for (const PlacedStructure& one : placed) {
        VkAccelerationStructureInstanceKHR instance{};
        instance.transform = one.toWorld;
        instance.instanceCustomIndex = one.first & 0xffffffu;
        instance.mask = 0xff;
        instance.instanceShaderBindingTableRecordOffset = one.record & 0xffffffu;
        instance.flags = VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR; // rays meet both sides
        instance.accelerationStructureReference = one.structure;
        instances.push_back(instance);
    }
    const GpuBuffer buffer = memory.buffer(name + " instances", instances.size() * sizeof(instances[0]),
                                           VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR);
    memory.upload(buffer, instances.data(), instances.size() * sizeof(instances[0]));
    VkAccelerationStructureGeometryKHR geometry{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR};
    geometry.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
    geometry.geometry.instances = {VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR};
    geometry.geometry.instances.data.deviceAddress = buffer.address;
    AccelerationBuild::run(memory, name, VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, geometry, std::uint32_t(instances.size()), level);
}
}
