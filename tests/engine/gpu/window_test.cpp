// The window for real: run under Xvfb. A picture is shown, resized and left, and validation has nothing to say.
#include "engine/core/error.hpp"
#include "engine/gpu/window.hpp"
#include "tests/engine/gpu/validated.hpp"
#include <cstdlib>

namespace afterglow
{
TEST(Window, ShowsAPictureWithAPanel)
{
    Window window("afterglow test", {320, 200});
    DeviceOptions options = window.deviceOptions("");
    options.validation = true;
    Gpu gpu(options);
    {
        const GpuImage picture = gpu.memory.image("picture", {VK_FORMAT_R8G8B8A8_UNORM, {160, 100, 1}});
        Screen screen(window, gpu);
        Controls controls;
        float value = 0.5f;
        int index = 1, frames = 0;
        bool on = true;
        while (window.poll(controls) && frames < 5) {
            screen.show(picture, [&](Panel& panel) {
                panel.begin("settings");
                if (panel.section("fog")) panel.slider("density", value, 0, 1);
                panel.toggle("on", on);
                panel.choice("shadows", index, {"map", "ray"});
                panel.bar("fog 2 ms", 2, 10);
                panel.text("5 frames");
                panel.end();
            });
            ++frames;
        }
        EXPECT_EQ(frames, 5);
        EXPECT_EQ(value, 0.5f);
        EXPECT_EQ(window.size(), glm::uvec2(320, 200));
    }
    for (const std::string& message : gpu.device.messages) ADD_FAILURE() << message;
}

TEST(Window, WithoutADisplayIsASentence)
{
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    try {
        Window window("nowhere", {64, 64});
        FAIL() << "a window without a display";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit, Exit::noDevice);
        EXPECT_NE(std::string(error.what()).find("afterglow render"), std::string::npos);
    }
}
}
