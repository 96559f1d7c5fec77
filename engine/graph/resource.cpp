// Parts of a texture.
#include "engine/graph/resource.hpp"
#include "engine/core/error.hpp"

namespace afterglow
{
Texture Texture::mip(std::uint32_t level) const
{
    check(level < mips(), "a texture has no such mip");
    Texture part = *this;
    part.range.mip += level;
    part.range.mips = 1;
    return part;
}

Texture Texture::layer(std::uint32_t l) const
{
    check(l < layers(), "a texture has no such layer");
    Texture part = *this;
    part.range.layer += l;
    part.range.layers = 1;
    part.kind = ImageKind::flat;
    return part;
}
}
