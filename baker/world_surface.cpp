// What stands at a point of the level's triangles: material and textures read, the shading frame, what lets light through.
#include "baker/texture.hpp"
#include "baker/world.hpp"
#include "shaders/frame.h"
#include "shaders/fresnel.h"
#include "shaders/random.h"
#include "shaders/surface.h"
#include <limits>

namespace afterglow
{
// What the three corners say at a point of a triangle.
struct Point {
    vec2 uv0, uv1;
    vec4 color;
};
static Point pointOf(const std::vector<Vertex>& vertices, const World::Triangle& t, vec2 b)
{
    const Vertex &v0 = vertices[t.vertex[0]], &v1 = vertices[t.vertex[1]], &v2 = vertices[t.vertex[2]];
    float a = 1.0f - b.x - b.y;
    return {a * v0.uv0 + b.x * v1.uv0 + b.y * v2.uv0, a * v0.uv1 + b.x * v1.uv1 + b.y * v2.uv1,
            a * unpackUnorm4x8(v0.color) + b.x * unpackUnorm4x8(v1.color) + b.y * unpackUnorm4x8(v2.color)};
}

vec3 World::emissionAt(uint triangle, vec2 barycentric) const
{
    const Material& m = materialOf(triangle);
    constexpr uint kCut = kMaterialAlphaMask | kMaterialAlphaBlend;
    if (m.emissiveTexture.texture < 0 && (m.flags & kCut) == 0) return m.emission;
    Point p = pointOf(vertices_, triangles_[triangle], barycentric);
    vec3 emission = m.emission * vec3(sampleTexture(scene_, m.emissiveTexture, p.uv0, p.uv1));
    if ((m.flags & kCut) == 0) return emission;
    float alpha = (m.baseColor * p.color * sampleTexture(scene_, m.baseColorTexture, p.uv0, p.uv1)).a;
    if ((m.flags & kMaterialAlphaMask) != 0) return alpha < m.alphaCutoff ? vec3(0.0f) : emission;
    return emission * clamp(alpha, 0.0f, 1.0f);
}

bool World::letsThrough(uint triangle, vec2 barycentric, vec3 direction, vec3* tint) const
{
    const Material& m = materialOf(triangle);
    Point p = pointOf(vertices_, triangles_[triangle], barycentric);
    vec4 color = m.baseColor * p.color * sampleTexture(scene_, m.baseColorTexture, p.uv0, p.uv1);
    if ((m.flags & kMaterialAlphaMask) != 0 && color.a < m.alphaCutoff) return true;
    if ((m.flags & kMaterialAlphaBlend) != 0) {
        // The chance to meet the surface is alpha; the draw is a hash of where the ray meets it, so it needs no state
        uint seed = hash2(triangle, hash2(floatBitsToUint(barycentric.x), floatBitsToUint(barycentric.y) ^ floatBitsToUint(direction.x)));
        if (hashFloat(seed) >= color.a) return true;
    }
    if (tint == nullptr || !(m.transmission > 0.0f)) return false;
    // Clear thin glass: a shadow ray passes straight through, tinted
    vec3 normal = front(triangle);
    float cosine = abs(dot(normal, direction)) / max(length(normal), std::numeric_limits<float>::min());
    float transmission = m.transmission * sampleTexture(scene_, m.transmissionTexture, p.uv0, p.uv1).r;
    vec4 packed = sampleTexture(scene_, m.metallicRoughnessTexture, p.uv0, p.uv1);
    Bsdf glass = makeBsdf(m, color, vec2(m.roughness * packed.g, m.metallic * packed.b), transmission, /* entering= */ true);
    if (!(glass.thin > 0.0f) || !isMirror(glass.alpha)) return false;
    *tint *= glass.transmission * layerPass(glass, cosine);
    return largestOf(*tint) > 0.0f;
}

Surface World::surfaceAt(const Ray& ray, const Hit& hit) const
{
    const Triangle& t = triangles_[hit.triangle];
    const Material& m = scene_.materials[t.material];
    const Vertex &v0 = vertices_[t.vertex[0]], &v1 = vertices_[t.vertex[1]], &v2 = vertices_[t.vertex[2]];
    float b = hit.barycentric.x, c = hit.barycentric.y, a = 1.0f - b - c;

    Surface s;
    s.position = a * v0.position + b * v1.position + c * v2.position;
    s.geometricNormal = normalize(cross(v1.position - v0.position, v2.position - v0.position));
    s.frontFacing = dot(s.geometricNormal, ray.direction) < 0.0f ? 1.0f : 0.0f;
    float side = s.frontFacing > 0.0f ? 1.0f : -1.0f;
    s.geometricNormal *= side;

    // Textures
    Point p = pointOf(vertices_, t, hit.barycentric);
    vec4 baseColor = m.baseColor * p.color * sampleTexture(scene_, m.baseColorTexture, p.uv0, p.uv1);
    vec4 packed = sampleTexture(scene_, m.metallicRoughnessTexture, p.uv0, p.uv1);
    vec2 roughMetal = vec2(m.roughness * packed.g, m.metallic * packed.b);
    float transmission = m.transmission > 0.0f ? m.transmission * sampleTexture(scene_, m.transmissionTexture, p.uv0, p.uv1).r : 0.0f;

    // The shading frame, on the viewer's side
    vec3 normal = safeNormalize(a * v0.normal + b * v1.normal + c * v2.normal, s.geometricNormal * side);
    vec4 tangent = a * v0.tangent + b * v1.tangent + c * v2.tangent;
    if (m.normalTexture.texture >= 0) {
        vec3 bent = vec3(sampleTexture(scene_, m.normalTexture, p.uv0, p.uv1)) * 2.0f - vec3(1.0f);
        Frame flat = makeTangentFrame(normal, tangent);
        normal = safeNormalize(toWorld(flat, vec3(bent.x * m.normalScale, bent.y * m.normalScale, bent.z)), normal);
    }
    if (m.anisotropyRotation != 0.0f) tangent = turnTangent(normal, tangent, m.anisotropyRotation);
    s.frame = makeTangentFrame(visibleNormal(normal * side, s.geometricNormal, -ray.direction), tangent);

    s.absorption = s.frontFacing > 0.0f ? vec3(0.0f) : bodyAbsorption(m);
    bool emits = s.frontFacing > 0.0f || (m.flags & kMaterialDoubleSided) != 0;
    s.emission =
        emits && largestOf(m.emission) > 0.0f ? m.emission * vec3(sampleTexture(scene_, m.emissiveTexture, p.uv0, p.uv1)) : vec3(0.0f);
    bool unlit = (m.flags & kMaterialUnlit) != 0;
    s.unlit = unlit ? vec3(baseColor) : vec3(0.0f);
    s.bsdf = unlit ? lambertBsdf(vec3(0.0f)) : makeBsdf(m, baseColor, roughMetal, transmission, s.frontFacing > 0.0f);
    return s;
}
}
