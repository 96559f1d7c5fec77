// One frame, declared: textures, buffers and the passes that hand them on, in the order in which they run. Plain data, no Vulkan object:
// an Executor runs it. Passes that no output depends on are culled: no pipeline, no memory, no time.
#pragma once
#include "engine/graph/pass.hpp"
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace afterglow
{
enum class Origin { transient, imported, historyPrevious, historyCurrent, uploaded };

struct Resource {
    std::string name;
    Origin origin = Origin::transient;
    bool isBuffer = false;
    ImageShape shape;                    // textures
    VkDeviceSize bytes = 0;              // buffers
    const GpuImage* image = nullptr;     // imported
    const GpuBuffer* buffer = nullptr;   // imported
    std::vector<std::uint8_t> data;      // uploaded
    std::uint32_t partner = kNoResource; // history: the other one
    std::uint32_t version = 0;           // how often it was written so far
    bool output = false;
};

// Passes [first, last) that run again and again.
struct Repeat {
    std::uint32_t first = 0, last = 0;
    std::uint32_t left = kNoResource;
};

class Graph
{
public:
    Texture texture(const std::string& name, VkFormat format, glm::uvec2 size);
    Texture texture(const std::string& name, const ImageShape& shape);
    Buffer buffer(const std::string& name, VkDeviceSize bytes);

    // What the host knows this frame (a View, a list of lights), as a buffer to read.
    template <typename T>
    Buffer upload(const std::string& name, const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        return uploadBytes(name, &value, sizeof(T));
    }
    template <typename T>
    Buffer upload(const std::string& name, std::span<const T> values)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        return uploadBytes(name, values.data(), values.size_bytes());
    }
    Buffer uploadBytes(const std::string& name, const void* data, std::size_t bytes);

    // What lives outside of the frame. It rests sampled (memory.hpp) before and after; it must outlive the run.
    Texture import(const GpuImage& image);
    Buffer import(const GpuBuffer& buffer);

    // Two textures by one name that swap every frame; the name is the memory, a new shape starts from zero again.
    History history(const std::string& name, VkFormat format, glm::uvec2 size);

    Pass compute(const std::string& name, const std::string& shader);
    Pass fullscreen(const std::string& name, const std::string& fragmentShader); // its vertex shader hands on `uv` at location 0
    Pass raster(const std::string& name, const std::string& vertexShader, const std::string& fragmentShader = "");
    Pass trace(const std::string& name, const RayPrograms& programs);
    Pass copy(const std::string& name, const Texture& from,
              const Texture& to); // blit, linear when the sizes differ; mip 0 and layer 0 of each
    Pass fill(const std::string& name, const Buffer& buffer, std::uint32_t value);

    // What `declare` declares runs again and again until the first word of `left` is 0, a submission each time. It may write buffers, and
    // images that were in the same layout before.
    void repeat(const Buffer& left, const std::function<void()>& declare);

    // What the frame is made for: kept after the run, for readback and for the window.
    void output(const Texture& texture);
    void output(const Buffer& buffer);

    std::vector<Resource> resources;
    std::vector<PassData> passes;
    std::vector<Repeat> repeats;
    std::string scope; // goes before the names of what is declared: a frame within the frame is told apart by it

private:
    Pass last();
};
}
