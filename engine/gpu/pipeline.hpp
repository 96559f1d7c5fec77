// The one way to make a pipeline: asked for by what it is (shaders, state, formats, constants), made at the first ask, kept.
#pragma once
#include "engine/gpu/memory.hpp"
#include "engine/gpu/shader.hpp"
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace afterglow
{
enum class Blend { none, alpha, max }; // alpha: premultiplied; max: the greater of old and new

// What meets a ray at a surface of some kind: the program that is asked of each candidate, and that of the nearest. Empty: none.
struct HitPrograms {
    std::string closest, any;
    auto operator<=>(const HitPrograms&) const = default;
};

// What a pipeline is. Depth is reversed: 1 near, 0 infinitely far, so the nearer fragment is the greater. Both sides of a triangle are
// drawn; its front is counter-clockwise, as in glTF.
struct PipelineKey {
    std::vector<std::string> shaders; // {.comp} or {.vert, .frag} or {.vert} (depth only) or {.rgen, .rmiss ..., those of `hits`}
    std::map<std::uint32_t, std::uint32_t> constants; // specialization: constant_id -> bits
    std::vector<VkFormat> colors;
    VkFormat depth = VK_FORMAT_UNDEFINED;
    bool depthWrite = true;
    bool depthBias = false;
    Blend blend = Blend::none;
    std::vector<HitPrograms> hits; // by their places in the shader binding table
    auto operator<=>(const PipelineKey&) const = default;
};

// Where a device finds the programs of a ray: for each of its program groups a record, which is the group's handle and nothing else.
struct ShaderTable {
    GpuBuffer buffer;
    VkStridedDeviceAddressRegionKHR begin{}, misses{}, hits{};
};

struct Pipeline {
    VkPipeline pipeline = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkDescriptorSetLayout resources = VK_NULL_HANDLE; // set 1
    std::vector<ShaderBinding> bindings;              // of set 1, merged over the stages
    VkShaderStageFlags pushStages = 0;
    std::uint32_t pushBytes = 0;
    std::uint32_t groupSize[3] = {1, 1, 1};
    std::string name;  // its shaders, for messages
    ShaderTable table; // of ray programs
};

// A set's layout. An effect that is off leaves its binding empty; the shader's constants keep it from looking.
VkDescriptorSetLayout makeSetLayout(VkDevice device, const std::vector<VkDescriptorSetLayoutBinding>& bindings);

// What a set holds: kind and count of each binding, from 0 on.
using SetShape = std::vector<std::pair<VkDescriptorType, std::uint32_t>>;

// A raster pipeline from its key (raster.cpp).
VkPipeline makeRaster(VkDevice device, VkPipelineCache cache, const PipelineKey& key,
                      const std::vector<VkPipelineShaderStageCreateInfo>& stages, VkPipelineLayout layout);

// Ray programs from their key, with the table of their groups (ray_programs.cpp). Programs trace rays from .rgen alone.
void makeRayPrograms(Memory& memory, VkPipelineCache cache, const PipelineKey& key,
                     const std::vector<VkPipelineShaderStageCreateInfo>& stages, Pipeline& pipeline);

class Pipelines
{
public:
    explicit Pipelines(Memory& memory);
    ~Pipelines();
    Pipelines(const Pipelines&) = delete;
    Pipelines& operator=(const Pipelines&) = delete;

    // `scene`: the layout of set 0, from sceneLayout(); null: no set. Throws Error when a shader does not compile.
    const Pipeline& get(const PipelineKey& key, VkDescriptorSetLayout scene);

    // A layout of set 0, for all stages. Kept as long as the pipelines, so that one handle means one shape for good: scenes of one shape
    // share it and the pipelines, and those of another shape are told apart.
    VkDescriptorSetLayout sceneLayout(const SetShape& shape);

    // Recompiles what was edited since it was compiled (a source or one of its includes is newer) and returns what happened, a line each.
    // A shader that does not compile keeps its old pipeline.
    std::vector<std::string> reload();

    std::uint32_t count() const { return static_cast<std::uint32_t>(pipelines_.size()); }
    Memory& memory;
    Device& device;

private:
    struct Entry;
    struct Source {
        Shader shader;
        std::filesystem::file_time_type read;
    };
    const Shader& shader(const std::string& path);
    Pipeline make(const PipelineKey& key, const std::vector<const Shader*>& stages, VkDescriptorSetLayout scene);
    void makeLayout(Pipeline& pipeline, const std::vector<const Shader*>& stages, VkDescriptorSetLayout scene); // pipeline_layout.cpp
    void destroy(Pipeline& pipeline);
    std::map<PipelineKey, std::unique_ptr<Entry>> pipelines_;
    std::map<std::string, Source> shaders_;
    VkPipelineCache cache_ = VK_NULL_HANDLE;
    std::map<SetShape, VkDescriptorSetLayout> sceneLayouts_;
};
}
