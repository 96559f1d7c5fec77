// Upscale: a smaller picture between its samples, sharp and without halos.
#ifndef AFTERGLOW_UPSCALE_H
#define AFTERGLOW_UPSCALE_H
#include "engine/effects/cubic.h"
SHARED_BEGIN

struct UpscalePush {
    vec2 jitter; // px of the drawn picture
};

SHARED_END
#endif
