#include "engine/scene/voxels.hpp"
#include "engine/scene/bounds.hpp"
#include <cmath>

namespace afterglow
{
namespace
{
constexpr double kLongest = 512.0; // voxels along an axis
constexpr int kWhole = 8;          // voxels of the finest level along a voxel of the fourth

using Polygon = std::vector<dvec3>; // convex

// What of the polygon lies on the side of `sign` of the plane p[axis] = at.
Polygon cut(const Polygon& polygon, int axis, double at, double sign)
{
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = sign * (a[axis] - at), db = sign * (b[axis] - at);
        if (da >= 0.0) kept.push_back(a);
        if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) kept.push_back(a + (b - a) * (da / (da - db)));
    }
    return kept;
}

// Seen along x, y and z.
dvec3 areasOf(const Polygon& polygon)
{
    dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return 0.5 * abs(sum);
}

// Calls put(slab, part) for every slab of unit width along the axis that the polygon reaches into. What lies in a border belongs to the
// slab above it.
template <class Put>
void slabs(const Polygon& polygon, int axis, int count, Put put)
{
    double lower = polygon[0][axis], upper = lower;
    for (const dvec3& p : polygon) lower = std::min(lower, p[axis]), upper = std::max(upper, p[axis]);
    const int first = clamp(int(std::floor(lower)), 0, count - 1), last = clamp(int(std::floor(upper)), first, count - 1);
    Polygon rest = polygon;
    for (int slab = first; slab < last && rest.size() > 2; ++slab) {
        const Polygon part = cut(rest, axis, slab + 1.0, -1.0);
        if (part.size() > 2) put(slab, part);
        rest = cut(rest, axis, slab + 1.0, 1.0);
    }
    if (rest.size() > 2) put(last, rest);
}

bool hides(const Scene& scene, const Instance& instance, bool staticOnly)
{
    const Material& material = scene.materials[instance.material];
    return !(material.flags & kMaterialAlphaBlend) && !(material.transmission > 0.0f) &&
           (!staticOnly || (instance.flags & kInstanceStatic));
}

// Calls visit(three corners in the world) for every triangle that hides something.
template <class Visit>
void forEachTriangle(const Scene& scene, bool staticOnly, Visit visit)
{
    for (const Instance& instance : instances(scene)) {
        if (!hides(scene, instance, staticOnly)) continue;
        for (uint i = 0; i + 2 < instance.indexCount; i += 3) {
            Polygon corners;
            for (uint k = 0; k < 3; ++k) {
                const uint vertex = instance.firstVertex + scene.indices[instance.firstIndex + i + k];
                corners.push_back(dmat4x3(instance.toWorld) * dvec4(dvec3(scene.vertices[vertex].position), 1.0));
            }
            visit(corners);
        }
    }
}

u8vec4 codeOf(vec3 closed) { return u8vec4(round(255.0f * vec4(min(closed, vec3(1.0f)), 1.0f))); }
}

VoxelGrid voxelize(const Scene& scene, bool staticOnly, std::size_t most)
{
    Box box;
    forEachTriangle(scene, staticOnly, [&](const Polygon& corners) {
        for (const dvec3& p : corners) grow(box, p);
    });
    if (box.empty()) return {};
    const dvec3 extent = box.upper - box.lower;
    const double longest = std::max({extent.x, extent.y, extent.z});
    const double edge = std::max({std::cbrt(extent.x * extent.y * extent.z / double(most)), longest / kLongest, 1e-6});

    VoxelGrid grid;
    grid.edge = float(edge);
    // One empty voxel on each side at least; four levels fit without a rest
    grid.count = (ivec3(floor(extent / edge)) + 3 + kWhole - 1) / kWhole * kWhole;
    const dvec3 lower = box.lower - edge * (0.5 * (dvec3(grid.count) - extent / edge));
    grid.lower = vec3(lower);
    std::vector<vec3> areas(std::size_t(grid.count.x) * std::size_t(grid.count.y) * std::size_t(grid.count.z), vec3(0.0f));
    forEachTriangle(scene, staticOnly, [&](Polygon corners) {
        for (dvec3& p : corners) p = (p - lower) / edge;
        slabs(corners, 2, grid.count.z, [&](int z, const Polygon& slab) {
            slabs(slab, 1, grid.count.y, [&](int y, const Polygon& row) {
                slabs(row, 0, grid.count.x, [&](int x, const Polygon& part) {
                    areas[(std::size_t(z) * std::size_t(grid.count.y) + std::size_t(y)) * std::size_t(grid.count.x) + std::size_t(x)] +=
                        vec3(areasOf(part));
                });
            });
        });
    });
    for (const vec3& area : areas) grid.closed.push_back(codeOf(area));
    return grid;
}

VoxelGrid coarser(const VoxelGrid& grid)
{
    VoxelGrid result;
    result.lower = grid.lower;
    result.edge = 2.0f * grid.edge;
    result.count = max(grid.count / 2, ivec3(1));
    const auto at = [&](ivec3 p) {
        p = min(p, grid.count - 1);
        return grid
            .closed[(std::size_t(p.z) * std::size_t(grid.count.y) + std::size_t(p.y)) * std::size_t(grid.count.x) + std::size_t(p.x)];
    };
    for (int z = 0; z < result.count.z; ++z)
        for (int y = 0; y < result.count.y; ++y)
            for (int x = 0; x < result.count.x; ++x) {
                vec3 sum(0.0f);
                for (int corner = 0; corner < 8; ++corner)
                    sum += vec3(at(2 * ivec3(x, y, z) + ivec3(corner & 1, (corner >> 1) & 1, corner >> 2)));
                result.closed.push_back(codeOf(sum / (4.0f * 255.0f)));
            }
    return result;
}
}
