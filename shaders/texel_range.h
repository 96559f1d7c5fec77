// A texture of the level as its file stores it.
#ifndef AFTERGLOW_TEXEL_RANGE_H
#define AFTERGLOW_TEXEL_RANGE_H
#include "shaders/glsl.h"
SHARED_BEGIN

struct TexelRange {
    uint first; // of its texels
    ivec2 size;
    uint wrapU; // kTexels...
    uint wrapV;
    uint srgb;    // 1: colours are encoded
    uint nearest; // 1: not filtered
};
const uint kTexelsRepeat = 0u;
const uint kTexelsMirror = 1u;
const uint kTexelsClamp = 2u;

SHARED_END
#endif
