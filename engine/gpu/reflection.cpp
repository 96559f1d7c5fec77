// Reads out of SPIR-V what a pipeline layout needs. One walk over the words; the opcodes are those of the SPIR-V specification, section 3.
#include "engine/core/error.hpp"
#include "engine/gpu/shader.hpp"
#include <algorithm>
#include <map>

namespace afterglow
{
namespace spirv
{
enum Op : std::uint32_t {
    executionMode = 16,
    typeBool = 20,
    typeInt = 21,
    typeFloat = 22,
    typeVector = 23,
    typeMatrix = 24,
    typeImage = 25,
    typeSampler = 26,
    typeSampledImage = 27,
    typeArray = 28,
    typeRuntimeArray = 29,
    typeStruct = 30,
    typePointer = 32,
    constant = 43,
    specConstant = 50,
    variable = 59,
    decorate = 71,
    memberDecorate = 72,
    executionModeId = 331,
    typeAccelerationStructure = 5341
};
enum Decoration : std::uint32_t { bufferBlock = 3, arrayStride = 6, matrixStride = 7, binding = 33, descriptorSet = 34, offset = 35 };
enum Storage : std::uint32_t { uniformConstant = 0, uniform = 2, pushConstant = 9, storageBuffer = 12 };
constexpr std::uint32_t kMagic = 0x07230203, kLocalSize = 17, kLocalSizeId = 38, kDimensionBuffer = 5, kHeaderWords = 5;
}

struct Module {
    struct Id {
        std::uint32_t op = 0;
        std::vector<std::uint32_t> words; // operands after the result id (and the result type, for constants and variables)
        std::map<std::uint32_t, std::uint32_t> decorations;
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> members; // (member, decoration) -> value
    };
    std::map<std::uint32_t, Id> ids;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> variables; // (pointer type, id)

    // Bytes of a type that lies in a block, without padding at its end.
    std::uint32_t bytes(std::uint32_t type, std::uint32_t columnStride = 0) const
    {
        const Id& id = ids.at(type);
        switch (id.op) {
        case spirv::typeInt:
        case spirv::typeFloat:
            return id.words[0] / 8;
        case spirv::typeVector:
            return bytes(id.words[0]) * id.words[1];
        case spirv::typeMatrix:
            return columnStride * (id.words[1] - 1) + bytes(id.words[0]);
        case spirv::typeArray: {
            const std::uint32_t count = ids.at(id.words[1]).words[0];
            return id.decorations.at(spirv::arrayStride) * (count - 1) + bytes(id.words[0], columnStride);
        }
        case spirv::typePointer:
            return 8; // buffer reference
        case spirv::typeStruct: {
            std::uint32_t end = 0;
            for (std::uint32_t m = 0; m < id.words.size(); ++m) {
                const auto stride = id.members.find({m, spirv::matrixStride});
                const std::uint32_t columns = stride == id.members.end() ? 0 : stride->second;
                end = std::max(end, id.members.at({m, spirv::offset}) + bytes(id.words[m], columns));
            }
            return end;
        }
        default:
            return 4;
        }
    }

    VkDescriptorType descriptor(const Id& type, std::uint32_t storage) const
    {
        switch (type.op) {
        case spirv::typeSampledImage:
            return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        case spirv::typeSampler:
            return VK_DESCRIPTOR_TYPE_SAMPLER;
        case spirv::typeAccelerationStructure:
            return VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
        case spirv::typeImage: {
            const bool stored = type.words[5] == 2, texelBuffer = type.words[1] == spirv::kDimensionBuffer;
            if (texelBuffer) return stored ? VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER : VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
            return stored ? VK_DESCRIPTOR_TYPE_STORAGE_IMAGE : VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
        }
        default:
            return storage == spirv::storageBuffer || type.decorations.contains(spirv::bufferBlock) ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                                                                                    : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        }
    }
};

static Module parse(const std::vector<std::uint32_t>& words, Reflection& reflection)
{
    check(words.size() > spirv::kHeaderWords && words[0] == spirv::kMagic, "these words are not SPIR-V");
    Module module;
    std::vector<std::uint32_t> sizeIds; // constants that hold the work-group size; they follow later
    for (std::size_t at = spirv::kHeaderWords; at < words.size();) {
        const std::uint32_t op = words[at] & 0xffff, count = words[at] >> 16;
        check(count && at + count <= words.size(), "a SPIR-V instruction runs over the end of its module");
        const std::uint32_t* w = &words[at];
        switch (op) {
        case spirv::executionMode:
            if (w[2] == spirv::kLocalSize) std::copy(w + 3, w + 6, reflection.groupSize);
            break;
        case spirv::executionModeId:
            if (w[2] == spirv::kLocalSizeId) sizeIds.assign(w + 3, w + 6);
            break;
        case spirv::decorate:
            module.ids[w[1]].decorations[w[2]] = count > 3 ? w[3] : 0;
            break;
        case spirv::memberDecorate:
            module.ids[w[1]].members[{w[2], w[3]}] = count > 4 ? w[4] : 0;
            break;
        case spirv::constant:
        case spirv::specConstant:
            module.ids[w[2]].op = op;
            module.ids[w[2]].words.assign(w + 3, w + count);
            break;
        case spirv::variable:
            module.ids[w[2]].op = op;
            module.ids[w[2]].words.assign(w + 3, w + count); // storage class
            module.variables.push_back({w[1], w[2]});
            break;
        case spirv::typeBool:
        case spirv::typeInt:
        case spirv::typeFloat:
        case spirv::typeVector:
        case spirv::typeMatrix:
        case spirv::typeImage:
        case spirv::typeSampler:
        case spirv::typeSampledImage:
        case spirv::typeArray:
        case spirv::typeRuntimeArray:
        case spirv::typeStruct:
        case spirv::typePointer:
        case spirv::typeAccelerationStructure:
            module.ids[w[1]].op = op;
            module.ids[w[1]].words.assign(w + 2, w + count);
            break;
        default:
            break;
        }
        at += count;
    }
    for (std::size_t axis = 0; axis < sizeIds.size(); ++axis) reflection.groupSize[axis] = module.ids.at(sizeIds[axis]).words[0];
    return module;
}

Reflection reflect(const std::vector<std::uint32_t>& words)
{
    Reflection result;
    const Module module = parse(words, result);
    for (const auto& [pointer, id] : module.variables) {
        const Module::Id& variable = module.ids.at(id);
        const std::uint32_t storage = variable.words[0];
        std::uint32_t type = module.ids.at(pointer).words[1];
        if (storage == spirv::pushConstant) result.pushBytes = module.bytes(type);
        if (storage != spirv::uniformConstant && storage != spirv::uniform && storage != spirv::storageBuffer) continue;
        ShaderBinding binding;
        binding.set = variable.decorations.at(spirv::descriptorSet);
        binding.binding = variable.decorations.at(spirv::binding);
        const Module::Id& array = module.ids.at(type);
        if (array.op == spirv::typeArray) binding.count = module.ids.at(array.words[1]).words[0];
        if (array.op == spirv::typeRuntimeArray) binding.count = 0;
        if (array.op == spirv::typeArray || array.op == spirv::typeRuntimeArray) type = array.words[0];
        binding.type = module.descriptor(module.ids.at(type), storage);
        result.bindings.push_back(binding);
    }
    std::sort(result.bindings.begin(), result.bindings.end(),
              [](const auto& a, const auto& b) { return std::pair(a.set, a.binding) < std::pair(b.set, b.binding); });
    return result;
}
}
