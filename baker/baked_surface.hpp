// Where a point lies on the lightmapped surfaces of a baked level, and how much of the texel there is open to light.
#pragma once
#include "baker/solids.hpp"
#include "engine/baked/baked.hpp"
#include <optional>

namespace afterglow
{
struct SurfacePoint {
    uint triangle; // of the world
    vec2 barycentric;
};

// The lightmapped surface nearest to a point among those that face the way of `normal` (unit); nothing within reach: none. All triangles
// are asked: surfaces that touch each other face to face cannot be told apart by a ray.
std::optional<SurfacePoint> nearestSurface(const Baked& baked, const World& world, vec3 position, vec3 normal);

// Irradiance / pi about `normal` (unit) that the lightmap stores there: bilinear over the texels that hold data. A lightmap without
// direction has one answer for all normals.
vec3 lightmapValue(const Baked& baked, const World& world, SurfacePoint point, vec3 normal);

// Share of one texel's area around the point that lies in the open, 0 to 1: the rest is covered by another solid (a floor under a wall).
// A lightmap's texel holds the mean of its open part, so that nothing darkens along a wall's foot; times this share it is the mean of the
// whole area.
float openShare(const Baked& baked, const World& world, const Solids& solids, SurfacePoint point);
}
