// The viewer for real: run under Xvfb. Frames, a resized window, edited shaders, other effects; validation has nothing to say.
#include "engine/app/cli.hpp"
#include "engine/app/viewer.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/gpu/readback.hpp"
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <gtest/gtest.h>
#include <thread>

namespace afterglow
{
namespace fs = std::filesystem;

class ViewerTest : public ::testing::Test
{
protected:
    ViewerTest()
    {
        setenv("AFTERGLOW_VALIDATION", "1", 1);
        command.target = fs::absolute("content/cornell/cornell.glb");
        command.settings.size = {96, 64};
    }

    void TearDown() override
    {
        fs::current_path(home);
        fs::remove_all(folder);
        unsetenv("AFTERGLOW_SHADERS");
    }

    // One frame, with keys pressed.
    static void press(Viewer& viewer, const std::string& keys = "")
    {
        Controls controls;
        ASSERT_TRUE(viewer.window.poll(controls));
        controls.pressed = keys;
        step(viewer, controls);
        for (const std::string& message : viewer.gpu.device.messages) ADD_FAILURE() << message;
    }

    static std::vector<std::uint8_t> pixels(Viewer& viewer) { return readback8(viewer.gpu.memory, viewer.picture).pixels; }

    const fs::path home = fs::current_path();
    const fs::path folder = fs::temp_directory_path() / ("afterglow_view_" + std::to_string(std::rand()));
    ViewCommand command;
};

TEST_F(ViewerTest, ThePictureFollowsTheWindow)
{
    Viewer viewer(command);
    press(viewer);
    EXPECT_EQ(viewer.failure, "");
    EXPECT_EQ(viewer.picture.shape.size, glm::uvec3(96, 64, 1));

    const glm::uvec2 wanted(150, 120);
    viewer.window.resize(wanted);
    Controls controls;
    for (int i = 0; i < 200 && viewer.window.size() != wanted; ++i) { // the display takes its time
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        viewer.window.poll(controls);
    }
    press(viewer);
    press(viewer);
    EXPECT_EQ(viewer.picture.shape.size, glm::uvec3(wanted, 1));
}

TEST_F(ViewerTest, AShaderThatDoesNotCompileLeavesThePictureAndSaysWhy)
{
    for (const char* part : {"shaders", "engine/effects", "engine/gpu"})
        fs::create_directories(folder / part), fs::copy(part, folder / part, fs::copy_options::recursive);
    setenv("AFTERGLOW_SHADERS", folder.c_str(), 1);
    const fs::path shader = folder / "engine/effects/display/display.frag";
    const std::string whole = readText(shader);
    const auto edit = [&](const std::string& text, int seconds) {
        writeText(shader, text);
        fs::last_write_time(shader, fs::file_time_type::clock::now() + std::chrono::seconds(seconds)); // whatever the clock's steps
    };

    Viewer viewer(command);
    press(viewer);
    const std::vector<std::uint8_t> before = pixels(viewer);
    edit(whole + "\nnot a shader\n", 10);
    press(viewer, "R");
    ASSERT_FALSE(viewer.messages.empty());
    EXPECT_NE(viewer.messages[0].find("display.frag"), std::string::npos) << viewer.messages[0];
    EXPECT_EQ(pixels(viewer), before);

    edit(whole, 20);
    press(viewer, "R");
    ASSERT_FALSE(viewer.messages.empty());
    EXPECT_EQ(viewer.messages[0].rfind("reloaded", 0), 0u) << viewer.messages[0];
    EXPECT_EQ(pixels(viewer), before);

    // One that compiles and then does not fit its pass: the frame fails, the picture stays
    edit("#version 460\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(1.0); }\n", 30);
    press(viewer, "R");
    EXPECT_NE(viewer.failure.find("display"), std::string::npos) << viewer.failure;
    EXPECT_EQ(pixels(viewer), before);
    edit(whole, 40);
    press(viewer, "R");
    EXPECT_EQ(viewer.failure, "");
}

TEST_F(ViewerTest, AnEffectThatNothingCallsForChangesNoPicture)
{
    Viewer viewer(command);
    press(viewer);
    const std::vector<std::uint8_t> before = pixels(viewer);
    for (const OfferedEffect& effect : viewer.effects)
        if (effect.free) viewer.settings.effects.forced[effect.called.effect] = true;
    viewer.restage = true;
    press(viewer);
    EXPECT_EQ(viewer.failure, "");
    EXPECT_TRUE(viewer.stage.plan.on("fog"));
    const std::vector<std::uint8_t> after = pixels(viewer);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_LE(std::abs(int(after[i]) - int(before[i])), 1);
}

// Of a level that holds no probes none can be shown: a sentence says so, and the picture is drawn as before.
TEST_F(ViewerTest, WhatCannotBeShownLeavesThePictureAndSaysWhy)
{
    std::vector<std::uint8_t> undisturbed; // two frames, gathered
    {
        Viewer viewer(command);
        press(viewer);
        press(viewer);
        undisturbed = pixels(viewer);
    }
    Viewer viewer(command);
    press(viewer);
    viewer.settings.show = kShowProbes;
    viewer.restage = true;
    press(viewer);
    EXPECT_EQ(viewer.failure, "");
    ASSERT_EQ(viewer.messages.size(), 1u);
    EXPECT_NE(viewer.messages[0].find("--show"), std::string::npos) << viewer.messages[0];
    EXPECT_EQ(viewer.settings.show, kShowNothing);
    EXPECT_EQ(pixels(viewer), undisturbed);
}

// T, V and F: path traced, one beside the other, their difference; samples add up while the camera rests, and are there after a look at the
// frame.
TEST_F(ViewerTest, TheTruthStandsInForTheFrameOrBesideIt)
{
    Viewer viewer(command);
    if (!canTrace(viewer.gpu.device, Tracing::automatic)) GTEST_SKIP() << viewer.gpu.device.deviceName << " traces no rays";
    press(viewer);
    const std::vector<std::uint8_t> raster = pixels(viewer);
    press(viewer, "T");
    EXPECT_EQ(viewer.failure, "");
    EXPECT_NE(pixels(viewer), raster);
    press(viewer);
    EXPECT_EQ(viewer.stage.traced.count, 2u);
    press(viewer, "T");
    EXPECT_EQ(viewer.stage.traced.count, 2u);
    press(viewer, "T");
    EXPECT_EQ(viewer.stage.traced.count, 3u);

    press(viewer, "V");
    EXPECT_EQ(viewer.failure, "");
    const std::vector<std::uint8_t> both = pixels(viewer);
    EXPECT_EQ(std::vector(&both[4 * 47], &both[4 * 49]), (std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 0, 255})) << "a line in the middle";
    viewer.wipe = 0.0f;
    press(viewer);
    EXPECT_NE(pixels(viewer), both);

    press(viewer, "F");
    EXPECT_EQ(viewer.failure, "");
    ASSERT_TRUE(viewer.differs);
    EXPECT_GT(*viewer.differs, 0.01) << "nothing that bounces is in the frame of a level that is not baked";
    EXPECT_LT(*viewer.differs, 1.0);
    viewer.eye.toWorld[3].x += 0.1f;
    press(viewer, "T");
    EXPECT_EQ(viewer.stage.traced.count, 1u);
}

TEST_F(ViewerTest, APictureIsSavedAsItIsShown)
{
    fs::create_directories(folder);
    Viewer viewer(command);
    fs::current_path(folder);
    press(viewer, "P");
    const Image saved = readImage("view.png");
    EXPECT_EQ(saved.width, 96);
    EXPECT_EQ(saved.height, 64);
}

TEST_F(ViewerTest, TheVerbClosesAfterItsFrames)
{
    const std::string target = command.target.string();
    const char* words[] = {"afterglow", "view", target.c_str(), "--size", "96x64", "--frames", "3"};
    testing::internal::CaptureStderr();
    EXPECT_EQ(runCommandLine(int(std::size(words)), words), 0);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_NE(said.find("the level is not baked"), std::string::npos) << said;
}

// Last: it takes the display away.
TEST_F(ViewerTest, WithoutADisplayIsASentence)
{
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    const std::string target = command.target.string();
    const char* words[] = {"afterglow", "view", target.c_str()};
    testing::internal::CaptureStderr();
    EXPECT_EQ(runCommandLine(int(std::size(words)), words), int(Exit::noDevice));
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("no display"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}
}
