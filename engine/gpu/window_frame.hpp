// Inside of the window's files: what GLFW holds for it.
#pragma once
#include "engine/gpu/window.hpp"

struct GLFWwindow;

namespace afterglow
{
struct Window::Frame {
    GLFWwindow* glfw = nullptr;
    glm::dvec2 cursor{0};
    double time = 0;
    float scroll = 0;
    std::string pressed;
};
}
