// glslang in the program: GLSL from the source root, with its includes, to SPIR-V 1.6.
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

// glslang first: its classes have members called check.
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/gpu/shader.hpp"
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <sstream>

namespace afterglow
{
static const char* const kPreamble = "#extension GL_GOOGLE_include_directive : require\n"
                                     "#extension GL_EXT_scalar_block_layout : require\n"
                                     "#extension GL_EXT_buffer_reference : require\n"
                                     "#extension GL_EXT_nonuniform_qualifier : require\n";

std::filesystem::path shaderRoot()
{
    namespace fs = std::filesystem;
    if (const char* root = std::getenv("AFTERGLOW_SHADERS")) return root;
    std::error_code failed; // a system without /proc has no installed root to look for
    const fs::path installed = fs::read_symlink("/proc/self/exe", failed).parent_path().parent_path() / "share/afterglow";
    if (fs::exists(installed / "shaders/glsl.h", failed)) return installed;
    return AFTERGLOW_SOURCE_ROOT;
}

namespace
{
// What the ending of a path says.
struct Stage {
    const char* ending;
    VkShaderStageFlagBits stage;
    EShLanguage language;
};
}

static const Stage& stageOf(const std::string& path)
{
    static constexpr Stage kStages[] = {
        {".vert", VK_SHADER_STAGE_VERTEX_BIT, EShLangVertex},      {".frag", VK_SHADER_STAGE_FRAGMENT_BIT, EShLangFragment},
        {".comp", VK_SHADER_STAGE_COMPUTE_BIT, EShLangCompute},    {".rgen", VK_SHADER_STAGE_RAYGEN_BIT_KHR, EShLangRayGen},
        {".rmiss", VK_SHADER_STAGE_MISS_BIT_KHR, EShLangMiss},     {".rchit", VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR, EShLangClosestHit},
        {".rahit", VK_SHADER_STAGE_ANY_HIT_BIT_KHR, EShLangAnyHit}};
    const Stage* found = std::find_if(std::begin(kStages), std::end(kStages), [&](const Stage& s) { return path.ends_with(s.ending); });
    check(found != std::end(kStages), "shader " + path + " ends like no stage that there is");
    return *found;
}

// Every #include starts at the root, in whatever file it stands.
class RootIncluder : public glslang::TShader::Includer
{
public:
    RootIncluder(const std::filesystem::path& root, std::vector<std::string>& files) : root_(root), files_(files) {}
    IncludeResult* includeLocal(const char* header, const char*, std::size_t depth) override
    {
        const std::filesystem::path path = root_ / header;
        if (depth > 64 || !std::filesystem::is_regular_file(path)) return nullptr;
        if (std::find(files_.begin(), files_.end(), header) == files_.end()) files_.push_back(header);
        auto text = std::make_unique<std::string>(readText(path));
        const char* data = text->c_str();
        const std::size_t size = text->size();
        return new IncludeResult(header, data, size, text.release());
    }
    IncludeResult* includeSystem(const char* header, const char* from, std::size_t depth) override
    {
        return includeLocal(header, from, depth);
    }
    void releaseInclude(IncludeResult* result) override
    {
        if (result) delete static_cast<std::string*>(result->userData);
        delete result;
    }

private:
    const std::filesystem::path& root_;
    std::vector<std::string>& files_;
};

// `ERROR: file:line: message` lines of glslang's log, without its summary.
static std::string firstErrors(const char* log)
{
    std::istringstream lines(log);
    std::string line, result;
    for (int kept = 0; std::getline(lines, line) && kept < 8;) {
        if (!line.starts_with("ERROR: ") || line.find("compilation errors") != std::string::npos) continue;
        result += (kept++ ? "\n  " : "") + line.substr(7);
    }
    return result.empty() ? log : result;
}

Shader compileShader(const std::string& path, const std::filesystem::path& root)
{
    static const struct Process {
        Process() { glslang::InitializeProcess(); }
        ~Process() { glslang::FinalizeProcess(); }
    } process; // glslang's own tables, made once

    Shader result;
    result.path = path;
    const EShLanguage language = stageOf(path).language;
    result.stage = stageOf(path).stage;
    result.files.push_back(path);
    if (!std::filesystem::is_regular_file(root / path))
        throw Error("there is no shader " + (root / path).string() +
                    "; let AFTERGLOW_SHADERS name the folder that holds engine/ and shaders/, " + "or unset it");
    const std::string source = readText(root / path);
    const char* text = source.c_str();
    const int size = static_cast<int>(source.size());
    const char* name = path.c_str();

    glslang::TShader shader(language);
    shader.setStringsWithLengthsAndNames(&text, &size, &name, 1);
    shader.setPreamble(kPreamble);
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    RootIncluder includer(root, result.files);
    if (!shader.parse(GetDefaultResources(), 460, false, messages, includer))
        throw Error("shader " + path + " does not compile:\n  " + firstErrors(shader.getInfoLog()));
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages)) throw Error("shader " + path + " does not link:\n  " + firstErrors(program.getInfoLog()));

    glslang::GlslangToSpv(*program.getIntermediate(language), result.words);
    result.reflection = reflect(result.words);
    return result;
}
}
