#include "engine/gpu/device.hpp" // forbidden: the other column
#include "engine/scene/scene.hpp"
#include <vulkan/vulkan.h> // forbidden: offline never sees Vulkan
