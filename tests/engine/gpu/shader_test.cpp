// GLSL compiles in the program, errors say where, reflection says what a layout needs.
#include "engine/core/error.hpp"
#include "engine/gpu/shader.hpp"
#include "tests/engine/gpu/scratch.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static std::string failure(const std::string& path, const Scratch& scratch)
{
    try {
        compileShader(path, scratch.root);
    } catch (const Error& error) {
        return error.what();
    }
    return "it compiled";
}

TEST(Shader, IncludesStartAtTheRootAndAreRemembered)
{
    Scratch scratch;
    scratch.write("laws/one.h", "#ifndef ONE_H\n#define ONE_H\n#include \"laws/two.h\"\nconst float kOne = kTwo / 2.0;\n#endif\n");
    scratch.write("laws/two.h", "const float kTwo = 2.0;\n");
    scratch.write("deep/down/main.frag",
                  "#version 460\n#include \"laws/one.h\"\nlayout(location = 0) out vec4 c;\nvoid main() { c = vec4(kOne); }\n");
    const Shader shader = compileShader("deep/down/main.frag", scratch.root);
    EXPECT_EQ(shader.files, (std::vector<std::string>{"deep/down/main.frag", "laws/one.h", "laws/two.h"}));
    EXPECT_EQ(shader.stage, VK_SHADER_STAGE_FRAGMENT_BIT);
}

TEST(Shader, ErrorsSayFileAndLine)
{
    Scratch scratch;
    scratch.write("bad.comp", "#version 460\nlayout(local_size_x = 8) in;\nvoid main() { nonsense(); }\n");
    EXPECT_NE(failure("bad.comp", scratch).find("bad.comp:3"), std::string::npos) << failure("bad.comp", scratch);
    scratch.write("bad.h", "\n\nfloat f() { return missing; }\n");
    scratch.write("includes.comp", "#version 460\n#include \"bad.h\"\nvoid main() {}\n");
    EXPECT_NE(failure("includes.comp", scratch).find("bad.h:3"), std::string::npos) << failure("includes.comp", scratch);
    scratch.write("gone.comp", "#version 460\n#include \"nowhere.h\"\nvoid main() {}\n");
    EXPECT_NE(failure("gone.comp", scratch).find("nowhere.h"), std::string::npos) << failure("gone.comp", scratch);
    EXPECT_NE(failure("not/there.comp", scratch).find("not/there.comp"), std::string::npos);
}

TEST(Shader, ReflectionKnowsBindingsPushBytesAndGroupSize)
{
    Scratch scratch;
    scratch.write("all.comp", R"(#version 460
layout(local_size_x = 16, local_size_y = 4) in;
struct Light { vec3 position; float radius; };
layout(set = 0, binding = 0) uniform sampler2D textures[];
layout(set = 0, binding = 3, scalar) readonly buffer Lights { Light lights[]; };
layout(set = 1, binding = 2, rgba16f) writeonly uniform image2D target;
layout(set = 1, binding = 0) uniform sampler2DShadow shadow;
layout(set = 1, binding = 1, scalar) uniform View { mat4 view; } view;
layout(buffer_reference, scalar) readonly buffer Words { uint words[]; };
layout(push_constant, scalar) uniform Push { vec3 a; float b; mat4x3 toWorld; uint list[3]; Words words; float last; } push;
void main()
{
    imageStore(target, ivec2(0), view.view[0] * textureLod(shadow, vec3(0), 0) * textureLod(textures[push.list[0]], vec2(0), 0) + lights[0].radius + push.last);
}
)");
    const Reflection r = compileShader("all.comp", scratch.root).reflection;
    EXPECT_EQ(r.groupSize[0], 16u);
    EXPECT_EQ(r.groupSize[1], 4u);
    EXPECT_EQ(r.groupSize[2], 1u);
    // Scalar layout: 12 + 4 + 48 + 12 = 76, the 8-byte address at 80, the float at 88.
    EXPECT_EQ(r.pushBytes, 92u);
    ASSERT_EQ(r.bindings.size(), 5u);
    const auto expect = [&](std::size_t i, std::uint32_t set, std::uint32_t binding, VkDescriptorType type, std::uint32_t count) {
        EXPECT_EQ(r.bindings[i].set, set);
        EXPECT_EQ(r.bindings[i].binding, binding);
        EXPECT_EQ(r.bindings[i].type, type);
        EXPECT_EQ(r.bindings[i].count, count);
    };
    expect(0, 0, 0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 0);
    expect(1, 0, 3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1);
    expect(2, 1, 0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1);
    expect(3, 1, 1, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1);
    expect(4, 1, 2, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 1);
}

TEST(Shader, TheSourceTreeIsTheRootUnlessSaidOtherwise)
{
    EXPECT_TRUE(std::filesystem::exists(shaderRoot() / "engine/gpu/fullscreen.vert"));
    setenv("AFTERGLOW_SHADERS", "/elsewhere", 1);
    EXPECT_EQ(shaderRoot(), "/elsewhere");
    unsetenv("AFTERGLOW_SHADERS");
}
}
