// What the geometry pass leaves of a surface for the passes that light it: 128 bits in one attachment, so one write and one fetch a pixel.
#ifndef AFTERGLOW_GBUFFER_H
#define AFTERGLOW_GBUFFER_H
#include "shaders/frame.h"
SHARED_BEGIN

struct GBufferTexel {
    vec3 normal;     // world, unit, on the side of the eye, the normal map applied
    vec3 baseColor;  // linear, 0..1
    float roughness; // perceptual, 0..1
    float metallic;  // 0..1
    vec2 lightmapUv; // of the page, 0..1
    uint material;   // index, below kGBufferMaterials
    uint page;       // of the lightmap, kGBufferNoPage and kGBufferBackPage: none
    uint mirrored;   // 1: what it mirrors is drawn by an eye behind it, and no probe has a say
};

// Specialization constant of every shader that samples materials (material.glsl): mips, added to each choice of one.
const uint kTextureBias = 31u;

const uint kGBufferMaterials = 32768u;
const uint kGBufferNoPage = 255u;
const uint kGBufferBackPage = 254u; // the back of a surface whose front has a lightmap

// Base colour is kept as its square root: 8 bits of it step by less than 1 % from 0.2 upwards and still tell 0.001 from 0.
FN uvec4 encodeGBuffer(GBufferTexel t)
{
    vec3 root =
        vec3(sqrt(clamp(t.baseColor.x, 0.0f, 1.0f)), sqrt(clamp(t.baseColor.y, 0.0f, 1.0f)), sqrt(clamp(t.baseColor.z, 0.0f, 1.0f)));
    uvec4 bits;
    bits.x = packUnorm2x16(octahedralEncode(t.normal));
    bits.y = packUnorm4x8(vec4(root, clamp(t.roughness, 0.0f, 1.0f)));
    bits.z = packUnorm2x16(t.lightmapUv);
    bits.w = (t.material & 0x7fffu) | (t.mirrored << 15u) | (uint(clamp(t.metallic, 0.0f, 1.0f) * 255.0f + 0.5f) << 16u) | (t.page << 24u);
    return bits;
}

FN GBufferTexel decodeGBuffer(uvec4 bits)
{
    vec4 color = unpackUnorm4x8(bits.y);
    vec3 root = vec3(color.x, color.y, color.z);
    GBufferTexel t;
    t.normal = octahedralDecode(unpackUnorm2x16(bits.x));
    t.baseColor = root * root;
    t.roughness = color.w;
    t.lightmapUv = unpackUnorm2x16(bits.z);
    t.material = bits.w & 0x7fffu;
    t.mirrored = (bits.w >> 15u) & 1u;
    t.metallic = float((bits.w >> 16u) & 255u) * (1.0f / 255.0f);
    t.page = bits.w >> 24u;
    return t;
}

SHARED_END
#endif
