#include "engine/core/log.hpp"
#include "engine/scene/scene.hpp" // forbidden: a neighbour in its row
#include <nlohmann/json.hpp>      // forbidden: not in a header
#include <vulkan/vulkan.h>
