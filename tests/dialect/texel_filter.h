// The smallest source that shaders/texel_filter.h can be compiled with: one colour.
#ifndef AFTERGLOW_TEST_DIALECT_TEXEL_FILTER_H
#define AFTERGLOW_TEST_DIALECT_TEXEL_FILTER_H
#include "shaders/texel_range.h"
SHARED_BEGIN

struct TexelSource {
    vec4 color;
};
FN vec4 texelAt(TexelSource source, IN(TexelRange) t, int x, int y) { return source.color * float(x + y * t.size.x); }

SHARED_END
#endif
