// Where a material's texture is read at a point of a triangle.
#ifndef AFTERGLOW_TEXTURE_REF_H
#define AFTERGLOW_TEXTURE_REF_H
#include "shaders/scene.h"
SHARED_BEGIN

FN vec2 textureUv(IN(TextureRef) ref, vec2 uv0, vec2 uv1)
{
    vec2 uv = ref.uvSet == 0u ? uv0 : uv1;
    return vec2(ref.matrix.x * uv.x + ref.matrix.z * uv.y, ref.matrix.y * uv.x + ref.matrix.w * uv.y) + ref.offset;
}

// Whether a mask cuts the surface out: alpha >= cutoff keeps, and so does an alpha that only rounding keeps from it (colours that a
// rasteriser interpolates between equal corners come out 2^-24 apart, and products of them a few times that).
FN bool isCutOut(float alpha, float cutoff)
{
    const float kRounding = 1e-6f;
    return alpha < cutoff * (1.0f - kRounding);
}

// Share of the surface that is there: 0 or 1 by a mask, alpha >= cutoff keeps; alpha itself where it is blended.
FN float metShare(IN(Material) m, float alpha)
{
    if ((m.flags & kMaterialAlphaMask) != 0u && isCutOut(alpha, m.alphaCutoff)) return 0.0f;
    return (m.flags & kMaterialAlphaBlend) != 0u ? clamp(alpha, 0.0f, 1.0f) : 1.0f;
}

SHARED_END
#endif
