// Pipelines and their layouts, made from reflection; reload when a source changes.
#include "engine/gpu/pipeline.hpp"
#include "engine/core/error.hpp"
#include "engine/gpu/memory.hpp"
#include <algorithm>

namespace afterglow
{
namespace fs = std::filesystem;

struct Pipelines::Entry {
    Pipeline pipeline;
    VkDescriptorSetLayout scene;
};

Pipelines::Pipelines(Device& d) : device(d)
{
    const VkPipelineCacheCreateInfo cache{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    vk(vkCreatePipelineCache(device.device, &cache, nullptr, &cache_));
    const VkDescriptorSetLayoutCreateInfo empty{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    vk(vkCreateDescriptorSetLayout(device.device, &empty, nullptr, &empty_));
}

Pipelines::~Pipelines()
{
    for (auto& [key, entry] : pipelines_) destroy(entry->pipeline);
    vkDestroyDescriptorSetLayout(device.device, empty_, nullptr);
    vkDestroyPipelineCache(device.device, cache_, nullptr);
}

void Pipelines::destroy(Pipeline& pipeline)
{
    vkDestroyPipeline(device.device, pipeline.pipeline, nullptr);
    vkDestroyPipelineLayout(device.device, pipeline.layout, nullptr);
    vkDestroyDescriptorSetLayout(device.device, pipeline.resources, nullptr);
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

// Set 1 of all stages together; a binding that two stages share must agree.
static std::vector<ShaderBinding> mergeBindings(const std::vector<const Shader*>& stages)
{
    std::vector<ShaderBinding> merged;
    for (const Shader* stage : stages)
        for (const ShaderBinding& binding : stage->reflection.bindings) {
            if (binding.set > 1)
                throw Error("shader " + stage->path + " uses descriptor set " + std::to_string(binding.set) +
                            "; there are 0 (scene) and 1 (pass)");
            if (binding.set == 0) continue;
            const auto same = std::find_if(merged.begin(), merged.end(), [&](const auto& b) { return b.binding == binding.binding; });
            if (same == merged.end())
                merged.push_back(binding);
            else if (same->type != binding.type)
                throw Error("shader " + stage->path + " and its partner disagree about binding " + std::to_string(binding.binding));
        }
    return merged;
}

void Pipelines::makeLayout(Pipeline& pipeline, const std::vector<const Shader*>& stages, VkDescriptorSetLayout scene)
{
    VkShaderStageFlags all = 0;
    for (const Shader* stage : stages) {
        all |= stage->stage;
        if (stage->reflection.pushBytes) pipeline.pushStages |= stage->stage;
        pipeline.pushBytes = std::max(pipeline.pushBytes, stage->reflection.pushBytes);
        pipeline.name += (pipeline.name.empty() ? "" : " + ") + stage->path;
        std::copy_n(stage->reflection.groupSize, 3, pipeline.groupSize);
        for (const ShaderBinding& binding : stage->reflection.bindings)
            if (binding.set == 0 && !scene) throw Error("shader " + stage->path + " uses set 0, the scene, but no scene was given");
    }
    pipeline.bindings = mergeBindings(stages);
    if (pipeline.pushBytes > device.limits.maxPushConstantsSize)
        throw Error(pipeline.name + " has " + std::to_string(pipeline.pushBytes) + " bytes of push constants, this device takes " +
                    std::to_string(device.limits.maxPushConstantsSize));

    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const ShaderBinding& binding : pipeline.bindings) bindings.push_back({binding.binding, binding.type, binding.count, all, nullptr});
    // An effect that is off leaves its binding empty; the shader's constants keep it from looking.
    const std::vector<VkDescriptorBindingFlags> flags(bindings.size(), VK_DESCRIPTOR_BINDING_PARTIALLY_BOUND_BIT);
    VkDescriptorSetLayoutBindingFlagsCreateInfo flagsInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_BINDING_FLAGS_CREATE_INFO};
    flagsInfo.bindingCount = static_cast<std::uint32_t>(flags.size());
    flagsInfo.pBindingFlags = flags.data();
    VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    setInfo.pNext = &flagsInfo;
    setInfo.bindingCount = flagsInfo.bindingCount;
    setInfo.pBindings = bindings.data();
    vk(vkCreateDescriptorSetLayout(device.device, &setInfo, nullptr, &pipeline.resources));

    const VkDescriptorSetLayout sets[] = {scene ? scene : empty_, pipeline.resources};
    // Vulkan wants push ranges in multiples of 4 bytes.
    const VkPushConstantRange push{pipeline.pushStages, 0, (pipeline.pushBytes + 3) / 4 * 4};
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = 2;
    info.pSetLayouts = sets;
    info.pushConstantRangeCount = pipeline.pushBytes ? 1 : 0;
    info.pPushConstantRanges = &push;
    vk(vkCreatePipelineLayout(device.device, &info, nullptr, &pipeline.layout));
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
