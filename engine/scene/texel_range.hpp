// A texture of the level for shaders/texel_filter.h.
#pragma once
#include "engine/scene/scene.hpp"
#include "shaders/texel_range.h"

namespace afterglow
{
static_assert(uint(Wrap::repeat) == kTexelsRepeat && uint(Wrap::mirror) == kTexelsMirror && uint(Wrap::clamp) == kTexelsClamp);

// `first`: of its texels among all that stand in one buffer.
inline TexelRange texelRange(const SceneTexture& texture, uint first = 0)
{
    const Image8& image = texture.image;
    return {first, {image.width, image.height}, uint(texture.wrapU), uint(texture.wrapV), texture.srgb, texture.nearest};
}
}
