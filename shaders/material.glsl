// A material at a point of a triangle: its factors times its textures, and the normal that its normal map makes of the interpolated one.
// For passes that rasterise: textures are filtered by the derivatives of the fragment, and gl_FrontFacing says which side is seen.
#ifndef AFTERGLOW_MATERIAL_GLSL
#define AFTERGLOW_MATERIAL_GLSL
#include "shaders/bindings.glsl"
#include "shaders/constants.h"
#include "shaders/frame.h"
#include "shaders/gbuffer.h"
#include "shaders/texture_ref.h"

struct MaterialTexel {
    vec3 baseColor;
    float alpha;
    float roughness;
    float metallic;
    float transmission;
    vec3 emission; // radiance towards the eye: black behind a single-sided emitter; an unlit surface's colour
};

layout(constant_id = kTextureBias) const float textureBias = 0.0;

vec4 textureAt(int image, vec2 uv) { return texture(textures[image], uv, textureBias); }

// Textures are chosen by the draw's material: the index is uniform within a draw. A reference is read only where there is a texture.
MaterialTexel sampleMaterial(uint index, vec2 uv0, vec2 uv1, vec4 vertexColor)
{
    MaterialTexel t;
    vec4 base = materials[index].baseColor * vertexColor;
    int image = materials[index].baseColorTexture.texture;
    if (image >= 0) base *= textureAt(image, textureUv(materials[index].baseColorTexture, uv0, uv1));
    t.baseColor = clamp(base.rgb, vec3(0.0), vec3(1.0));
    t.alpha = base.a;

    t.roughness = materials[index].roughness;
    t.metallic = materials[index].metallic;
    image = materials[index].metallicRoughnessTexture.texture;
    if (image >= 0) {
        vec4 texel = textureAt(image, textureUv(materials[index].metallicRoughnessTexture, uv0, uv1));
        t.roughness *= texel.g;
        t.metallic *= texel.b;
    }

    t.transmission = materials[index].transmission;
    image = materials[index].transmissionTexture.texture;
    if (image >= 0) t.transmission *= textureAt(image, textureUv(materials[index].transmissionTexture, uv0, uv1)).r;

    uint flags = materials[index].flags;
    t.emission = vec3(0.0);
    if (gl_FrontFacing || (flags & kMaterialDoubleSided) != 0u) {
        t.emission = materials[index].emission;
        image = materials[index].emissiveTexture.texture;
        if (image >= 0) t.emission *= textureAt(image, textureUv(materials[index].emissiveTexture, uv0, uv1)).rgb;
    }
    if ((flags & kMaterialUnlit) != 0u) {
        t.emission += t.baseColor;
        t.baseColor = vec3(0.0);
    }
    t.emission = min(t.emission, vec3(kHalfMax));
    return t;
}

// The lightmap knows the light on the front; what meets the back is left to the probes.
uint pageSeen(uint page) { return gl_FrontFacing ? page : max(page, kGBufferBackPage); }

// On the side of the eye. A zero normal (or one that the map makes zero) falls back, never to NaN.
vec3 shadingNormal(uint index, vec3 worldNormal, vec4 worldTangent, vec2 uv0, vec2 uv1)
{
    vec3 n = safeNormalize(worldNormal, vec3(0.0, 1.0, 0.0));
    int image = materials[index].normalTexture.texture;
    if (image >= 0) {
        Frame frame = makeTangentFrame(n, worldTangent);
        vec3 texel = textureAt(image, textureUv(materials[index].normalTexture, uv0, uv1)).xyz * 2.0 - 1.0;
        texel.xy *= materials[index].normalScale;
        n = safeNormalize(toWorld(frame, texel), n);
    }
    return gl_FrontFacing ? n : -n;
}

#endif
