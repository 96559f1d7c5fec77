// The smallest picture that engine/effects/reflection/march.h can be compiled with: sky everywhere.
#ifndef AFTERGLOW_TEST_DIALECT_MARCH_H
#define AFTERGLOW_TEST_DIALECT_MARCH_H
#include "shaders/glsl.h"
SHARED_BEGIN

struct DepthPyramid {
    uint levels;
};

FN vec2 depthRange(DepthPyramid, int, ivec2) { return vec2(0.0f); }
FN float depthBetween(DepthPyramid, vec2) { return 0.0f; }

SHARED_END
#endif
