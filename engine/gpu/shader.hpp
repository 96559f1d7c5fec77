// GLSL to SPIR-V inside the program (glslang), and what a SPIR-V module says about itself: bindings, push constants, work-group size.
#pragma once
#include "engine/gpu/vk.hpp"
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace afterglow
{
// Where shader paths and #include lines start: AFTERGLOW_SHADERS, or share/afterglow beside the installed program, or the source tree.
std::filesystem::path shaderRoot();

struct ShaderBinding {
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    std::uint32_t count = 1; // 0: a runtime array
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
};

struct Reflection {
    std::vector<ShaderBinding> bindings;    // sorted by set, then binding
    std::uint32_t pushBytes = 0;            // 0: no push constants
    std::uint32_t groupSize[3] = {1, 1, 1}; // compute: local_size
};

struct Shader {
    std::string path; // from the root; its ending says the stage: .vert, .frag, .comp, .rgen, .rmiss, .rchit, .rahit
    VkShaderStageFlagBits stage = VK_SHADER_STAGE_ALL;
    std::vector<std::uint32_t> words; // SPIR-V
    Reflection reflection;
    std::vector<std::string> files; // the source and everything it includes, from the root
};

// `#version 460` files; GL_GOOGLE_include_directive, GL_EXT_scalar_block_layout, GL_EXT_buffer_reference and GL_EXT_nonuniform_qualifier
// are switched on for them. Throws Error with glslang's `file:line: message` when it does not compile, with the path when it cannot be
// read.
Shader compileShader(const std::string& path, const std::filesystem::path& root = shaderRoot());

Reflection reflect(const std::vector<std::uint32_t>& words);
}
