// The window by GLFW: keys and mouse become Controls.
#include "engine/gpu/window.hpp"
#include "engine/core/error.hpp"
#include "engine/gpu/window_frame.hpp"
#define GLFW_INCLUDE_NONE
#include <cstdlib>
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace afterglow
{
// From GLFW 3.4 on, every kind of display is tried in turn, and Wayland complains on stderr where it has no folder for its sockets.
static void preferQuietDisplays()
{
#ifdef GLFW_PLATFORM
    if (!std::getenv("XDG_RUNTIME_DIR")) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
}

Window::Window(const std::string& title, glm::uvec2 size) : frame_(std::make_unique<Frame>())
{
    preferQuietDisplays();
    if (!glfwInit()) throw Error("no display to open a window on: set DISPLAY, or draw to a file with `afterglow render`", Exit::noDevice);
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    frame_->glfw = glfwCreateWindow(static_cast<int>(size.x), static_cast<int>(size.y), title.c_str(), nullptr, nullptr);
    if (!frame_->glfw || !glfwVulkanSupported()) {
        glfwTerminate();
        throw Error("this display cannot show Vulkan pictures: draw to a file with `afterglow render`", Exit::noDevice);
    }
    glfwSetWindowUserPointer(frame_->glfw, frame_.get());
    // Set before the panel's own, which calls these in turn.
    glfwSetScrollCallback(frame_->glfw, [](GLFWwindow* window, double, double y) {
        static_cast<Frame*>(glfwGetWindowUserPointer(window))->scroll += static_cast<float>(y);
    });
    glfwSetKeyCallback(frame_->glfw, [](GLFWwindow* window, int key, int, int action, int) {
        if (action == GLFW_PRESS && key >= GLFW_KEY_SPACE && key <= GLFW_KEY_Z)
            static_cast<Frame*>(glfwGetWindowUserPointer(window))->pressed +=
                static_cast<char>(key); // GLFW's codes here are ASCII capitals
    });
    // A key that went down and up during a slow frame counts once
    glfwSetInputMode(frame_->glfw, GLFW_STICKY_KEYS, GLFW_TRUE);
    frame_->time = glfwGetTime();
}

Window::~Window()
{
    glfwDestroyWindow(frame_->glfw);
    glfwTerminate();
}

DeviceOptions Window::deviceOptions(const std::string& device) const
{
    DeviceOptions options = afterglow::deviceOptions(device);
    std::uint32_t count = 0;
    const char** extensions = glfwGetRequiredInstanceExtensions(&count);
    options.instanceExtensions.assign(extensions, extensions + count);
    options.surface = [glfw = frame_->glfw](VkInstance instance) {
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        vk(glfwCreateWindowSurface(instance, glfw, nullptr, &surface));
        return surface;
    };
    return options;
}

glm::uvec2 Window::size() const
{
    int width = 0, height = 0;
    glfwGetFramebufferSize(frame_->glfw, &width, &height);
    return {static_cast<unsigned>(width), static_cast<unsigned>(height)};
}

void Window::resize(glm::uvec2 size) { glfwSetWindowSize(frame_->glfw, static_cast<int>(size.x), static_cast<int>(size.y)); }

bool Window::poll(Controls& controls)
{
    GLFWwindow* glfw = frame_->glfw;
    frame_->scroll = 0;
    frame_->pressed.clear();
    glfwPollEvents();
    controls = Controls();

    const double now = glfwGetTime();
    controls.seconds = now - frame_->time;
    frame_->time = now;
    glm::dvec2 cursor;
    glfwGetCursorPos(glfw, &cursor.x, &cursor.y);
    const glm::dvec2 moved = cursor - frame_->cursor;
    frame_->cursor = cursor;

    const bool panel = ImGui::GetCurrentContext() != nullptr;
    if (!panel || !ImGui::GetIO().WantCaptureMouse) {
        const bool held = glfwGetMouseButton(glfw, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS ||
                          glfwGetMouseButton(glfw, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
        if (held) controls.look = glm::vec2(moved);
        controls.scroll = frame_->scroll;
    }
    // Read in any case: what is typed into the panel must not count later. A box clicked there takes no keys
    const auto down = [&](int key) { return glfwGetKey(glfw, key) == GLFW_PRESS; };
    const auto axis = [&](int more, int less) { return static_cast<float>(int(down(more)) - int(down(less))); };
    const glm::vec3 move = {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q), axis(GLFW_KEY_W, GLFW_KEY_S)};
    const bool fast = down(GLFW_KEY_LEFT_SHIFT), escape = down(GLFW_KEY_ESCAPE);
    if (!panel || !ImGui::GetIO().WantTextInput) {
        controls.move = move;
        controls.fast = fast;
        controls.pressed = frame_->pressed;
        if (escape) return false;
    }
    return !glfwWindowShouldClose(glfw);
}
}
