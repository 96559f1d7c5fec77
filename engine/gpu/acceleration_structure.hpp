// Acceleration structures of devices that trace rays: triangles below, instances above. Their memory is counted like any other's.
#pragma once
#include "engine/gpu/memory.hpp"
#include <span>
#include <utility>

namespace afterglow
{
class AccelerationStructure
{
public:
    AccelerationStructure() = default;
    AccelerationStructure(AccelerationStructure&& other) noexcept { *this = std::move(other); }
    AccelerationStructure& operator=(AccelerationStructure&& other) noexcept;
    ~AccelerationStructure();
    explicit operator bool() const { return structure != VK_NULL_HANDLE; }

    VkAccelerationStructureKHR structure = VK_NULL_HANDLE;
    VkDeviceAddress address = 0;
    GpuBuffer storage;

private:
    friend struct AccelerationBuild;
    Device* device_ = nullptr;
};

// The most triangles of one structure, and the most instances of one.
std::uint64_t mostRayPrimitives(const Device& device);

enum class Candidates { opaque, asked }; // every hit counts, or the shader is asked about each (once)

// Vertices: tightly packed x, y, z. Needed only while it is built.
struct TriangleRange {
    const GpuBuffer* vertices;
    std::uint32_t vertexCount;
    const GpuBuffer* indices;
    std::uint32_t firstTriangle, triangleCount;
    Candidates candidates;
};
AccelerationStructure buildTriangles(Memory& memory, const std::string& name, const TriangleRange& range);

// `first` is what a shader reads as the instance's custom index; `record`: where its hit programs begin (shaders/ray_scene.h); `toWorld`: 3
// rows of 4.
struct PlacedStructure {
    VkDeviceAddress structure;
    std::uint32_t first;
    std::uint32_t record = 0;
    VkTransformMatrixKHR toWorld{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
};

// `level`: empty, or one of as many structures, which is built anew in its place: who knows its handle keeps it. No frame may be running.
void buildInstances(Memory& memory, const std::string& name, std::span<const PlacedStructure> placed, AccelerationStructure& level);
}
