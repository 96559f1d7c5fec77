// What a ray meets at a point of a triangle, and what of it passes straight on: one text for both tracers.
//
// The includer defines, before this line:
//   struct TextureSet                                            where textures are, passed by value
//   vec4 texelOf(TextureSet, TextureRef, vec2 uv0, vec2 uv1)     linear RGBA, white where there is no texture
#ifndef AFTERGLOW_MET_H
#define AFTERGLOW_MET_H
#include "shaders/inset.h"
#include "shaders/random.h"
#include "shaders/ray.h"
#include "shaders/ray_scene.h"
#include "shaders/surface.h"
#include "shaders/texture_ref.h"
SHARED_BEGIN

const float kMostInsetShare = 0.0625f; // of a height: in what is narrower, a point would move along it rather than off its edge

// What the three corners say at a point of a triangle; corners in the world.
struct MetPoint {
    vec3 position;
    float meetingError; // of Surface
    vec3 front;         // normal of the front, as long as twice the triangle's area
    vec3 normal;
    vec4 tangent;
    vec2 uv0, uv1;
    vec4 color;
};
FN MetPoint metPoint(IN(Vertex) v0, IN(Vertex) v1, IN(Vertex) v2, vec2 barycentric)
{
    float b = barycentric.x, c = barycentric.y, a = 1.0f - b - c;
    MetPoint p;
    p.position = a * v0.position + b * v1.position + c * v2.position;
    p.meetingError = meetingError(v0.position - p.position, v1.position - p.position, v2.position - p.position);
    p.front = cross(v1.position - v0.position, v2.position - v0.position);
    p.normal = a * v0.normal + b * v1.normal + c * v2.normal;
    p.tangent = a * v0.tangent + b * v1.tangent + c * v2.tangent;
    p.uv0 = a * v0.uv0 + b * v1.uv0 + c * v2.uv0;
    p.uv1 = a * v0.uv1 + b * v1.uv1 + c * v2.uv1;
    p.color = a * unpackUnorm4x8(v0.color) + b * unpackUnorm4x8(v1.color) + c * unpackUnorm4x8(v2.color);

    // Off the edges, where there is room: a step from there meets no wall at an angle of 7 degrees
    const float kSteps = 8.0f;
    float size = length(p.front);
    if (!(size > 0.0f)) return p;
    vec3 least = insetShares(v0.position, v1.position, v2.position, p.front, kSteps * stepOff(p.position, p.front / size));
    if (largestOf(least) > kMostInsetShare) return p;
    vec2 kept = keptOffEdges(barycentric, least);
    if (kept != barycentric) p.position = (1.0f - kept.x - kept.y) * v0.position + kept.x * v1.position + kept.y * v2.position;
    return p;
}

FN vec4 metColor(TextureSet textures_, IN(Material) m, IN(MetPoint) p)
{
    return m.baseColor * p.color * texelOf(textures_, m.baseColorTexture, p.uv0, p.uv1);
}
FN vec2 metRoughMetal(TextureSet textures_, IN(Material) m, IN(MetPoint) p)
{
    vec4 packed = texelOf(textures_, m.metallicRoughnessTexture, p.uv0, p.uv1);
    return vec2(m.roughness * packed.y, m.metallic * packed.z);
}

// Mean radiance that leaves the front: where alpha is the chance to meet it, times that.
FN vec3 metEmission(TextureSet textures_, IN(Material) m, IN(MetPoint) p)
{
    vec3 emission = m.emission * vec3(texelOf(textures_, m.emissiveTexture, p.uv0, p.uv1));
    if ((m.flags & (kMaterialAlphaMask | kMaterialAlphaBlend)) == 0u) return emission;
    return emission * metShare(m, metColor(textures_, m, p).w);
}

// The draw that decides whether a ray meets a blended surface, below its share: a hash of where, so it needs no state.
FN float metDraw(uint triangle, vec2 barycentric, vec3 direction)
{
    uint seed = hash2(triangle, hash2(floatBitsToUint(barycentric.x), floatBitsToUint(barycentric.y) ^ floatBitsToUint(direction.x)));
    return hashFloat(seed);
}

// Tint of light that goes straight through where the surface is there: that of clear thin glass, else 0.
FN vec3 metTint(TextureSet textures_, IN(Material) m, IN(MetPoint) p, vec4 color, vec3 direction)
{
    const float kLeastLength = 1.17549435e-38f; // the smallest normal float
    if (!(m.transmission > 0.0f)) return vec3(0.0f);
    float cosine = abs(dot(p.front, direction)) / max(length(p.front), kLeastLength);
    float transmission = m.transmission * texelOf(textures_, m.transmissionTexture, p.uv0, p.uv1).x;
    Bsdf glass = makeBsdf(m, color, metRoughMetal(textures_, m, p), transmission, /* entering= */ true);
    if (!(glass.thin > 0.0f) || !isMirror(glass.alpha)) return vec3(0.0f);
    return glass.transmission * layerPass(glass, cosine);
}

// The shading point; `direction`: of the ray that met it.
FN Surface metSurface(TextureSet textures_, IN(Material) m, IN(MetPoint) p, vec3 direction)
{
    Surface s;
    s.position = p.position;
    s.meetingError = p.meetingError;
    s.geometricNormal = normalize(p.front);
    s.frontFacing = dot(s.geometricNormal, direction) < 0.0f ? 1.0f : 0.0f;
    float side = s.frontFacing > 0.0f ? 1.0f : -1.0f;
    s.geometricNormal *= side;

    // Textures
    vec4 baseColor = metColor(textures_, m, p);
    vec2 roughMetal = metRoughMetal(textures_, m, p);
    float transmission = m.transmission > 0.0f ? m.transmission * texelOf(textures_, m.transmissionTexture, p.uv0, p.uv1).x : 0.0f;

    // The shading frame, on the viewer's side
    vec3 normal = safeNormalize(p.normal, s.geometricNormal * side);
    vec4 tangent = p.tangent;
    if (m.normalTexture.texture >= 0) {
        vec3 bent = vec3(texelOf(textures_, m.normalTexture, p.uv0, p.uv1)) * 2.0f - vec3(1.0f);
        Frame flat_ = makeTangentFrame(normal, tangent);
        normal = safeNormalize(toWorld(flat_, vec3(bent.x * m.normalScale, bent.y * m.normalScale, bent.z)), normal);
    }
    if (m.anisotropyRotation != 0.0f) tangent = turnTangent(normal, tangent, m.anisotropyRotation);
    s.frame = makeTangentFrame(visibleNormal(normal * side, s.geometricNormal, -direction), tangent);

    s.absorption = s.frontFacing > 0.0f ? vec3(0.0f) : bodyAbsorption(m);
    bool emits = s.frontFacing > 0.0f || (m.flags & kMaterialDoubleSided) != 0u;
    s.emission = vec3(0.0f);
    if (emits && largestOf(m.emission) > 0.0f) s.emission = m.emission * vec3(texelOf(textures_, m.emissiveTexture, p.uv0, p.uv1));
    bool unlit = (m.flags & kMaterialUnlit) != 0u;
    s.unlit = unlit ? vec3(baseColor) : vec3(0.0f);
    if (unlit)
        s.bsdf = lambertBsdf(vec3(0.0f));
    else
        s.bsdf = makeBsdf(m, baseColor, roughMetal, transmission, s.frontFacing > 0.0f);
    return s;
}

SHARED_END
#endif
