// A texture read texel by texel, level 0, filtered as glTF asks: one text for both tracers, which leave nothing to a device's filter.
//
// The includer defines, before this line:
//   struct TexelSource                                      where texels are, passed by value
//   vec4 texelAt(TexelSource, IN(TexelRange), int x, int y)  linear RGBA; x, y lie in the texture
#ifndef AFTERGLOW_TEXEL_FILTER_H
#define AFTERGLOW_TEXEL_FILTER_H
#include "shaders/texel_range.h"
SHARED_BEGIN

FN int wrapTexel(int i, int size, uint wrap)
{
    if (i >= 0 && i < size) return i;
    if (wrap == kTexelsClamp) return clamp(i, 0, size - 1);
    int period = wrap == kTexelsRepeat ? size : 2 * size;
    i = i >= 0 ? i % period : period - 1 - (-1 - i) % period;
    return i < size ? i : period - 1 - i;
}

FN vec4 wrappedTexel(TexelSource source, IN(TexelRange) t, int x, int y)
{
    return texelAt(source, t, wrapTexel(x, t.size.x, t.wrapU), wrapTexel(y, t.size.y, t.wrapV));
}

FN vec4 filteredTexel(TexelSource source, IN(TexelRange) t, vec2 uv)
{
    if (t.wrapU == kTexelsRepeat) uv.x -= floor(uv.x); // spares wrapTexel a division
    if (t.wrapV == kTexelsRepeat) uv.y -= floor(uv.y);
    // Far-away texture coordinates lose their fraction in float: keep the integer part small enough for int
    vec2 p = clamp(uv, vec2(-1e4f), vec2(1e4f)) * vec2(t.size);
    if (t.nearest != 0u) return wrappedTexel(source, t, int(floor(p.x)), int(floor(p.y)));
    p -= vec2(0.5f);
    vec2 cell = floor(p);
    vec2 f = p - cell;
    int x = int(cell.x), y = int(cell.y);
    vec4 upper = mix(wrappedTexel(source, t, x, y), wrappedTexel(source, t, x + 1, y), f.x);
    vec4 lower = mix(wrappedTexel(source, t, x, y + 1), wrappedTexel(source, t, x + 1, y + 1), f.x);
    return mix(upper, lower, f.y);
}

SHARED_END
#endif
