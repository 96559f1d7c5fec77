#include "engine/scene/scene.hpp"
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>
