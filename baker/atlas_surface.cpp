#include "baker/atlas_surface.hpp"
#include <limits>

namespace afterglow
{
namespace
{
// A triangle no higher than this, relative to its distance from the origin, is a line: rounding alone gives it a normal.
constexpr double kRounding = 4.0 * double(std::numeric_limits<float>::epsilon());
}

Surface surfaceOf(const Scene& scene, const Mesh& mesh, const dmat3& toWorld)
{
    Surface surface;
    for (const Primitive& primitive : mesh.primitives) {
        uint first = uint(surface.keys.size());
        for (uint v = 0; v < primitive.vertexCount; ++v) {
            const vec3& p = scene.vertices[primitive.firstVertex + v].position;
            surface.keys.push_back(p);
            surface.points.push_back(toWorld * dvec3(p));
        }
        for (uint i = 0; i < primitive.indexCount / 3 * 3; ++i) surface.indices.push_back(first + scene.indices[primitive.firstIndex + i]);
    }
    for (uint t = 0; t < surface.triangles(); ++t) {
        const dvec3 &a = surface.point(t, 0), &b = surface.point(t, 1), &c = surface.point(t, 2);
        dvec3 normal = cross(b - a, c - a);
        double size = length(normal), longest = max(max(distance(a, b), distance(b, c)), distance(c, a));
        double away = max(max(length(a), length(b)), length(c));
        surface.areas.push_back(size / 2);
        surface.normals.push_back(size > kRounding * away * longest ? normal / size : dvec3(0.0));
    }
    surface.pieces.assign(surface.triangles(), 0);
    return surface;
}
}
