// The fixture of tests that run frames for real, by the small shaders beside it.
#pragma once
#include "engine/graph/executor.hpp"
#include "tests/engine/gpu/validated.hpp"

namespace afterglow
{
constexpr VkFormat kFloat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat kDepth = VK_FORMAT_D32_SFLOAT;
inline const std::string kShaders = "tests/engine/graph/shaders/";

class Running : public Validated
{
protected:
    Executor executor{gpu};
};
}
