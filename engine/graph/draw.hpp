// What a raster pass's function draws with: push constants, state and draws, all counted. Vertices are pulled by the vertex shader from
// buffers (set 0, a binding of the pass, or an address in the push constants) at gl_VertexIndex.
#pragma once
#include "engine/graph/pass.hpp"

namespace afterglow
{
class Draw
{
public:
    // Replaces the pass's push constants from here on; the same struct.
    template <typename T>
    void push(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        pushBytes(&value, sizeof(T));
    }
    void pushBytes(const void* data, std::size_t bytes);
    void area(glm::uvec4 xyWidthHeight);
    void frontsOnly(bool only);                // until it is said again; a pass begins with both sides
    void clearDepth(glm::uvec4 xyWidthHeight); // to 0, infinitely far: of a pass that modifies its depth

    void indices(const GpuBuffer& buffer); // 32-bit
    void indexed(std::uint32_t count, std::uint32_t first, std::int32_t vertexOffset, std::uint32_t instances = 1,
                 std::uint32_t firstInstance = 0);
    void vertices(std::uint32_t count, std::uint32_t instances = 1, std::uint32_t first = 0, std::uint32_t firstInstance = 0);

    // Set by the recorder.
    VkCommandBuffer commands = VK_NULL_HANDLE;
    const Pipeline* pipeline = nullptr;
    std::string pass;
    std::uint64_t draws = 0, triangles = 0;

private:
    void count(std::uint64_t vertices, std::uint64_t instances);
};
}
