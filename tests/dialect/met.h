// The smallest level that shaders/met.h can be compiled with: no texture.
#ifndef AFTERGLOW_TEST_DIALECT_MET_H
#define AFTERGLOW_TEST_DIALECT_MET_H
#include "shaders/scene.h"
SHARED_BEGIN

struct TextureSet {
    uint count;
};

FN vec4 texelOf(TextureSet, TextureRef, vec2, vec2) { return vec4(1.0f); }

SHARED_END
#endif
