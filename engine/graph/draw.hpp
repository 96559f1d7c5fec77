// What a raster pass's function draws with: push constants, state and draws, all counted.
#pragma once
#include "engine/graph/pass.hpp"

namespace afterglow
{
class Executor;

class Draw
{
public:
    template <typename T>
    void push(const T& value) // replaces the pass's push constants from here on; the same struct
    {
        static_assert(std::is_trivially_copyable_v<T>);
        pushBytes(&value, sizeof(T));
    }
    void pushBytes(const void* data, std::size_t bytes);
    void cull(Cull cull);
    void mirrored(bool mirrored); // the object's transform turns it inside out: front faces are clockwise
    void area(glm::uvec4 xyWidthHeight);

    void indices(const GpuBuffer& buffer); // 32-bit
    void indexed(std::uint32_t count, std::uint32_t first, std::int32_t vertexOffset, std::uint32_t instances = 1,
                 std::uint32_t firstInstance = 0);
    void vertices(std::uint32_t count, std::uint32_t instances = 1, std::uint32_t first = 0, std::uint32_t firstInstance = 0);

    VkCommandBuffer commands = VK_NULL_HANDLE;
    std::uint64_t draws = 0;
    std::uint64_t triangles = 0;

private:
    friend class Executor;
    const Pipeline* pipeline_ = nullptr;
    bool lines_ = false;
};
}
