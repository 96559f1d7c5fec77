// The viewer's window: what is pressed, a picture from the GPU on the screen, and a panel of settings on top of it.
#pragma once
#include "engine/gpu/gpu.hpp"
#include "engine/gpu/swapchain.hpp"
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace afterglow
{
// What the person did since the last poll. Nothing of it is meant for the panel.
struct Controls {
    double seconds = 0;  // since the last poll
    glm::vec3 move{0};   // -1, 0 or 1: x right (D - A), y up (E - Q), z forward (W - S)
    bool fast = false;   // shift
    glm::vec2 look{0};   // pixels dragged with a mouse button down
    float scroll = 0;    // notches
    std::string pressed; // letters, digits and space pressed since, in capitals
};

// The settings drawn over the picture, a line a call; each returns true when the person changed the value.
class Panel
{
public:
    void begin(const std::string& title); // one panel a title
    void end();
    bool section(const std::string& title); // folds; draw what is in it when true
    void text(const std::string& line);
    bool button(const std::string& label);
    bool toggle(const std::string& label, bool& value);
    bool slider(const std::string& label, float& value, float low, float high);
    bool choice(const std::string& label, int& index, const std::vector<std::string>& names);
    void bar(const std::string& label, float value, float most); // a part of a whole, and what it is: pass times
};

// The window itself, before there is a device: makes the options that let a device show pictures in it.
class Window
{
public:
    // Throws Error when there is no display to open it on.
    Window(const std::string& title, glm::uvec2 size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    DeviceOptions deviceOptions(const std::string& device) const;
    bool poll(Controls& controls); // false: the person closed it
    glm::uvec2 size() const;       // pixels; 0 while it is minimized
    void resize(glm::uvec2 size);  // asks for it: the display may take some polls, or refuse

private:
    friend class Screen;
    struct Frame;
    std::unique_ptr<Frame> frame_;
};

// The swapchain and the panel's renderer of a window, on a device that was made with its options.
class Screen
{
public:
    Screen(Window& window, Gpu& gpu);
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    // Shows an image that is encoded for display and at rest, scaled to the window, with the panels that `draw` makes on top.
    void show(const GpuImage& picture, const std::function<void(Panel&)>& draw);

private:
    void startPanels();
    void record(VkCommandBuffer commands, const GpuImage& picture, const Swapchain::Target& target);
    Window& window_;
    Gpu& gpu_;
    Swapchain swapchain_;
    VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
};
}
