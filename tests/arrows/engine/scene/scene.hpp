#include "baker/baker.hpp" // forbidden: a higher row
#include "engine/core/log.hpp"
#include "log.hpp"     // forbidden: not named from the root
#include <tiny_gltf.h> // forbidden: its place is gltf.cpp
