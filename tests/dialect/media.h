// The smallest level that shaders/media.h can be compiled with: no medium.
#ifndef AFTERGLOW_TEST_DIALECT_MEDIA_H
#define AFTERGLOW_TEST_DIALECT_MEDIA_H
#include "shaders/scene.h"
SHARED_BEGIN

struct Air {
    uint count;
};

FN uint mediumCount(Air) { return 0u; }
FN Medium mediumAt(Air, uint)
{
    Medium nothing;
    return nothing;
}
FN vec4 mediumPlaneAt(Air, uint) { return vec4(0.0f); }

SHARED_END
#endif
