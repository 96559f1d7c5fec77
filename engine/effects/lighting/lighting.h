// Lighting: the variant of its passes beside those of shading.h.
#ifndef AFTERGLOW_LIGHTING_H
#define AFTERGLOW_LIGHTING_H
#include "engine/effects/shading.h"
SHARED_BEGIN

const uint kLightingSkyImage = 5u;

SHARED_END
#endif
