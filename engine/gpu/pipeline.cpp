// Pipelines: made at the first ask, kept, and made anew when a source changes.
#include "engine/gpu/pipeline.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
namespace fs = std::filesystem;

struct Pipelines::Entry {
    Pipeline pipeline;
    VkDescriptorSetLayout scene;
};

Pipelines::Pipelines(Memory& m) : memory(m), device(m.device)
{
    const VkPipelineCacheCreateInfo cache{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    vk(vkCreatePipelineCache(device.device, &cache, nullptr, &cache_));
}

Pipelines::~Pipelines()
{
    for (auto& [key, entry] : pipelines_) destroy(entry->pipeline);
    for (const auto& [shape, layout] : sceneLayouts_) vkDestroyDescriptorSetLayout(device.device, layout, nullptr);
    vkDestroyPipelineCache(device.device, cache_, nullptr);
}

void Pipelines::destroy(Pipeline& pipeline)
{
    vkDestroyPipeline(device.device, pipeline.pipeline, nullptr);
    vkDestroyPipelineLayout(device.device, pipeline.layout, nullptr);
    vkDestroyDescriptorSetLayout(device.device, pipeline.resources, nullptr);
}

VkDescriptorSetLayout Pipelines::sceneLayout(const SetShape& shape)
{
    VkDescriptorSetLayout& layout = sceneLayouts_[shape];
    if (!layout) {
        std::vector<VkDescriptorSetLayoutBinding> bindings;
        for (const auto& [type, count] : shape)
            bindings.push_back({std::uint32_t(bindings.size()), type, count, VK_SHADER_STAGE_ALL, nullptr});
        layout = makeSetLayout(device.device, bindings);
    }
    return layout;
}

const Shader& Pipelines::shader(const std::string& path)
{
    Source& source = shaders_[path];
    if (source.shader.words.empty()) {
        source.read = fs::file_time_type::clock::now();
        source.shader = compileShader(path);
    }
    return source.shader;
}

const Pipeline& Pipelines::get(const PipelineKey& key, VkDescriptorSetLayout scene)
{
    std::unique_ptr<Entry>& entry = pipelines_[key];
    if (!entry || entry->scene != scene) {
        std::vector<const Shader*> stages;
        try {
            for (const std::string& path : key.shaders) stages.push_back(&shader(path));
            auto made = std::make_unique<Entry>(Entry{make(key, stages, scene), scene});
            if (entry) destroy(entry->pipeline);
            entry = std::move(made);
        } catch (...) {
            if (!entry) pipelines_.erase(key); // what failed is not counted
            throw;
        }
    }
    return entry->pipeline;
}

Pipeline Pipelines::make(const PipelineKey& key, const std::vector<const Shader*>& stages, VkDescriptorSetLayout scene)
{
    Pipeline pipeline;
    std::vector<VkSpecializationMapEntry> entries;
    std::vector<std::uint32_t> values;
    for (const auto& [id, bits] : key.constants) {
        entries.push_back({id, static_cast<std::uint32_t>(values.size() * sizeof(bits)), sizeof(bits)});
        values.push_back(bits);
    }
    const VkSpecializationInfo constants{static_cast<std::uint32_t>(entries.size()), entries.data(), values.size() * sizeof(values[0]),
                                         values.data()};
    std::vector<VkPipelineShaderStageCreateInfo> infos;
    const auto freeModules = [&] {
        for (const auto& info : infos) vkDestroyShaderModule(device.device, info.module, nullptr);
    };
    try {
        makeLayout(pipeline, stages, scene);
        for (const Shader* stage : stages) {
            VkShaderModuleCreateInfo module{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
            module.codeSize = stage->words.size() * sizeof(std::uint32_t);
            module.pCode = stage->words.data();
            VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
            info.stage = stage->stage;
            info.pName = "main";
            info.pSpecializationInfo = &constants;
            vk(vkCreateShaderModule(device.device, &module, nullptr, &info.module));
            infos.push_back(info);
        }
        if (stages[0]->stage == VK_SHADER_STAGE_COMPUTE_BIT) {
            VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
            info.stage = infos[0];
            info.layout = pipeline.layout;
            vk(vkCreateComputePipelines(device.device, cache_, 1, &info, nullptr, &pipeline.pipeline));
        } else if (stages[0]->stage == VK_SHADER_STAGE_RAYGEN_BIT_KHR) {
            makeRayPrograms(memory, cache_, key, infos, pipeline);
        } else {
            pipeline.pipeline = makeRaster(device.device, cache_, key, infos, pipeline.layout);
        }
    } catch (...) {
        freeModules();
        destroy(pipeline);
        throw;
    }
    freeModules();
    device.name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(pipeline.pipeline), pipeline.name);
    return pipeline;
}

// A source is stale when it or something that it includes was written after it was read.
static bool stale(const Shader& shader, fs::file_time_type read)
{
    return std::any_of(shader.files.begin(), shader.files.end(), [&](const std::string& file) {
        std::error_code gone; // an editor may be replacing it this moment
        const auto written = fs::last_write_time(shaderRoot() / file, gone);
        return !gone && written > read;
    });
}

std::vector<std::string> Pipelines::reload()
{
    std::vector<std::string> lines;
    std::vector<std::string> changed;
    for (auto& [path, source] : shaders_) {
        if (!stale(source.shader, source.read)) continue;
        source.read = fs::file_time_type::clock::now(); // one message an edit, also when it fails
        try {
            source.shader = compileShader(path);
            changed.push_back(path);
        } catch (const Error& error) {
            lines.push_back(error.what());
        }
    }
    if (!changed.empty()) device.wait();
    for (auto& [key, entry] : pipelines_) {
        const auto uses = [&](const std::string& path) { return std::find(changed.begin(), changed.end(), path) != changed.end(); };
        if (!std::any_of(key.shaders.begin(), key.shaders.end(), uses)) continue;
        try {
            std::vector<const Shader*> stages;
            for (const std::string& path : key.shaders) stages.push_back(&shader(path));
            Pipeline made = make(key, stages, entry->scene);
            destroy(entry->pipeline);
            entry->pipeline = std::move(made);
            lines.push_back("reloaded " + entry->pipeline.name);
        } catch (const Error& error) {
            lines.push_back(error.what());
        }
    }
    return lines;
}
}
