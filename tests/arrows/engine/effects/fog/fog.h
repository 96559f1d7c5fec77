#include "engine/effects/bloom/bloom.h" // forbidden: another effect
#include "shaders/light.h"
