// Pipelines are made once, counted, and follow their sources.
#include "engine/core/error.hpp"
#include "tests/engine/gpu/scratch.hpp"
#include "tests/engine/gpu/validated.hpp"

namespace afterglow
{
static const char* const kHead = "#version 460\nlayout(local_size_x = 8) in;\nlayout(constant_id = 3) const uint kSteps = 1;\n"
                                 "#include \"value.h\"\nlayout(set = 1, binding = 0, scalar) buffer Out { uint v[]; };\n";
static const char* const kBody = "void main() { v[gl_GlobalInvocationID.x] = kValue * kSteps; }\n";

class PipelineTest : public Validated
{
protected:
    PipelineTest()
    {
        setenv("AFTERGLOW_SHADERS", scratch.root.c_str(), 1);
        scratch.write("value.h", "const uint kValue = 1;\n");
        scratch.write("a.comp", std::string(kHead) + kBody);
    }
    ~PipelineTest() override { unsetenv("AFTERGLOW_SHADERS"); }

    // Edits happen at the clock's pace: make the file newer than any clock tick.
    void edit(const std::string& name, const std::string& text)
    {
        scratch.write(name, text);
        std::filesystem::last_write_time(scratch.root / name,
                                         std::filesystem::file_time_type::clock::now() + std::chrono::milliseconds(50 * ++edits));
    }
    Scratch scratch;
    int edits = 0;
};

TEST_F(PipelineTest, SameKeySamePipelineOtherConstantAnother)
{
    const VkPipeline a = gpu.pipelines.get({{"a.comp"}}, VK_NULL_HANDLE).pipeline;
    EXPECT_EQ(gpu.pipelines.get({{"a.comp"}}, VK_NULL_HANDLE).pipeline, a);
    EXPECT_EQ(gpu.pipelines.count(), 1u);
    EXPECT_NE(gpu.pipelines.get({{"a.comp"}, {{3, 7}}}, VK_NULL_HANDLE).pipeline, a);
    EXPECT_EQ(gpu.pipelines.count(), 2u);
}

TEST_F(PipelineTest, AnEditOfAnIncludeReloadsAndABrokenOneKeepsTheOld)
{
    const Pipeline& pipeline = gpu.pipelines.get({{"a.comp"}}, VK_NULL_HANDLE);
    EXPECT_TRUE(gpu.pipelines.reload().empty());
    edit("value.h", "const uint kValue = 2;\n");
    EXPECT_EQ(gpu.pipelines.reload(), std::vector<std::string>{"reloaded a.comp"});

    const VkPipeline working = pipeline.pipeline;
    edit("value.h", "const uint kValue = ;\n");
    const std::vector<std::string> lines = gpu.pipelines.reload();
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NE(lines[0].find("value.h:1"), std::string::npos) << lines[0];
    EXPECT_EQ(pipeline.pipeline, working);
}

TEST_F(PipelineTest, WhatDoesNotCompileIsNotCounted)
{
    scratch.write("bad.comp", "#version 460\nvoid main() { x }\n");
    EXPECT_THROW(gpu.pipelines.get({{"bad.comp"}}, VK_NULL_HANDLE), Error);
    EXPECT_EQ(gpu.pipelines.count(), 0u);
}

// A scene of the same shape takes the pipelines over, and another shape never meets those of one that is gone, whatever its handle was.
TEST_F(PipelineTest, FollowTheShapeOfTheScene)
{
    const SetShape one = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1}}, two = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2}};
    const VkDescriptorSetLayout first = gpu.pipelines.sceneLayout(one);
    const VkPipeline a = gpu.pipelines.get({{"a.comp"}}, first).pipeline;
    EXPECT_EQ(gpu.pipelines.sceneLayout(one), first);
    EXPECT_NE(gpu.pipelines.sceneLayout(two), first);
    EXPECT_EQ(gpu.pipelines.get({{"a.comp"}}, gpu.pipelines.sceneLayout(one)).pipeline, a);
    EXPECT_NE(gpu.pipelines.get({{"a.comp"}}, gpu.pipelines.sceneLayout(two)).pipeline, a);
    EXPECT_EQ(gpu.pipelines.count(), 1u) << "of another shape it is made anew in its place";
    edit("value.h", "const uint kValue = 2;\n");
    EXPECT_EQ(gpu.pipelines.reload(), std::vector<std::string>{"reloaded a.comp"});
}

TEST_F(PipelineTest, UseOfTheSceneWithoutOneIsASentence)
{
    scratch.write("scene.comp", "#version 460\nlayout(set = 0, binding = 0) buffer B { uint v[]; };\nvoid main() { v[0] = 1; }\n");
    EXPECT_THROW(gpu.pipelines.get({{"scene.comp"}}, VK_NULL_HANDLE), Error);
}
}
