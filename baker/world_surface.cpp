// What stands at a point of the level's triangles: material and textures read, the shading frame, what lets light through.
#include "baker/texture.hpp"
#include "baker/wavelengths.hpp"
#include "baker/world.hpp"

namespace shared
{
struct TextureSet {
    const afterglow::Scene& scene;
};
FN vec4 texelOf(TextureSet textures, const TextureRef& ref, vec2 uv0, vec2 uv1)
{
    return afterglow::sampleTexture(textures.scene, ref, uv0, uv1);
}
}

#include "shaders/met.h"

namespace afterglow
{
static MetPoint pointOf(const std::vector<Vertex>& vertices, const World::Triangle& t, vec2 barycentric)
{
    return metPoint(vertices[t.vertex[0]], vertices[t.vertex[1]], vertices[t.vertex[2]], barycentric);
}

vec3 World::emissionAt(uint triangle, vec2 barycentric) const
{
    return metEmission({scene_}, materialOf(triangle), pointOf(vertices_, triangles_[triangle], barycentric));
}

bool World::letsThrough(uint triangle, vec2 barycentric, vec3 direction, const Wavelengths* at, vec3* tint) const
{
    const Material& m = materialOf(triangle);
    const MetPoint p = pointOf(vertices_, triangles_[triangle], barycentric);
    const vec4 color = metColor({scene_}, m, p);
    if (!(metDraw(triangle, barycentric, direction) < metShare(m, color.a))) return true;
    if (tint == nullptr) return false;
    const vec3 passed = metTint({scene_}, m, p, color, direction);
    *tint *= at ? at->reflectance * passed : passed;
    return largestOf(*tint) > 0.0f;
}

Surface World::surfaceAt(const Ray& ray, const Hit& hit) const
{
    const Triangle& t = triangles_[hit.triangle];
    return metSurface({scene_}, scene_.materials[t.material], pointOf(vertices_, t, hit.barycentric), ray.direction);
}
}
