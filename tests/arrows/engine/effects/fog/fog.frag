#version 460
#include "baker/baker.hpp" // forbidden: the other column
#include "engine/effects/fog/fog.h"
