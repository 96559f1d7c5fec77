#include "baker/lod.hpp"
#include "baker/distance.hpp"
#include "baker/journal.hpp"
#include "baker/lod_decimate.hpp"
#include "baker/lod_packed.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/jobs.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace afterglow
{
namespace
{
constexpr std::size_t kFewest = 200; // triangles: smaller primitives are drawn as they are
constexpr double kWorthwhile = 0.85; // of the triangles of the level before: a level that keeps more is not worth its indices

struct Work { // one primitive's
    uint mesh, primitive;
};

std::vector<Corners> corners(std::span<const Vertex> vertices, std::span<const uint> indices)
{
    std::vector<Corners> result;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        result.push_back(
            {dvec3(vertices[indices[i]].position), dvec3(vertices[indices[i + 1]].position), dvec3(vertices[indices[i + 2]].position)});
    return result;
}

using Point = std::array<float, 3>;
Point pointOf(const Vertex& v) { return {v.position.x + 0.0f, v.position.y + 0.0f, v.position.z + 0.0f}; }

// Per vertex of the primitive: another of the mesh's primitives uses a vertex at the same place.
std::vector<bool> sharedPoints(const Scene& scene, const Mesh& mesh, uint primitive)
{
    const Primitive& own = mesh.primitives[primitive];
    std::vector<bool> shared(own.vertexCount);
    if (mesh.primitives.size() == 1) return shared;
    std::vector<Point> others;
    for (const Primitive& p : mesh.primitives)
        for (uint i = 0; &p != &own && i < p.indexCount; ++i)
            others.push_back(pointOf(scene.vertices[p.firstVertex + scene.indices[p.firstIndex + i]]));
    std::sort(others.begin(), others.end());
    for (uint v = 0; v < own.vertexCount; ++v)
        shared[v] = std::binary_search(others.begin(), others.end(), pointOf(scene.vertices[own.firstVertex + v]));
    return shared;
}

double diagonal(const Scene& scene, const Mesh& mesh) // m
{
    vec3 lower(INFINITY), upper(-INFINITY);
    for (const Primitive& p : mesh.primitives)
        for (uint v = 0; v < p.vertexCount; ++v) {
            const vec3& position = scene.vertices[p.firstVertex + v].position;
            lower = min(lower, position), upper = max(upper, position);
        }
    return double(length(upper - lower));
}

dvec3 weightsAt(const Corners& t, const dvec3& p) // of the corners, at a point of the triangle
{
    const dvec3 n = cross(t[1] - t[0], t[2] - t[0]);
    const double whole = dot(n, n);
    if (!(whole > 0.0)) return {1, 0, 0};
    const double v = dot(n, cross(p - t[0], t[2] - t[0])) / whole, w = dot(n, cross(t[1] - t[0], p - t[0])) / whole;
    return {1 - v - w, v, w};
}

dvec3 normalAt(std::span<const Vertex> vertices, const uint* corner, const dvec3& weights)
{
    const dvec3 n = weights[0] * dvec3(vertices[corner[0]].normal) + weights[1] * dvec3(vertices[corner[1]].normal) +
                    weights[2] * dvec3(vertices[corner[2]].normal);
    return dot(n, n) > 0.0 ? normalize(n) : n;
}

// The two-sided distance, over the primitive's vertices and centroids, and over the level about as densely. The turn of the normals
// is that of each sample of the level against the nearest place of the primitive.
class ErrorGauge
{
public:
    ErrorGauge(std::span<const Vertex> vertices, std::span<const uint> indices)
        : vertices_(vertices), indices_(indices), surface_(corners(vertices, indices)), tree_(surface_), points_(samples(surface_, 0.0))
    {
        std::vector<bool> used(vertices.size());
        for (uint i : indices) used[i] = true;
        for (std::size_t v = 0; v < vertices.size(); ++v)
            if (used[v]) points_.push_back(dvec3(vertices[v].position));
        double area = 0;
        for (const Corners& t : surface_) area += length(cross(t[1] - t[0], t[2] - t[0])) / 2;
        spacing_ = std::sqrt(2 * area / double(surface_.size()));
    }

    struct Strays {
        double error = 0; // m, at most
        double turn = 0;  // radians, root mean square over the level
    };
    Strays operator()(std::span<const uint> level) const
    {
        std::vector<Corners> coarse = corners(vertices_, level);
        Strays strays;
        double turned = 0, whole = 0; // m2: of the level, times the squared angle; of the level
        for (std::size_t i = 0; i < coarse.size(); ++i) {
            const Corners& t = coarse[i];
            const std::vector<dvec3> places = samples(t, spacing_);
            const double area = length(cross(t[1] - t[0], t[2] - t[0])) / 2;
            whole += area;
            for (const dvec3& w : places) {
                stopIfInterrupted();
                const DistanceTree::Place place = tree_.nearest(t[0] * w[0] + t[1] * w[1] + t[2] * w[2]);
                strays.error = max(strays.error, place.distance);
                const dvec3 original = normalAt(vertices_, &indices_[3 * place.triangle], weightsAt(surface_[place.triangle], place.point));
                const double turn = std::acos(clamp(dot(original, normalAt(vertices_, &level[3 * i], w)), -1.0, 1.0));
                turned += turn * turn * area / double(places.size());
            }
        }
        if (whole > 0.0) strays.turn = std::sqrt(turned / whole);
        DistanceTree coarseTree(std::move(coarse));
        for (const dvec3& p : points_) {
            stopIfInterrupted();
            strays.error = max(strays.error, coarseTree(p));
        }
        return strays;
    }

private:
    std::span<const Vertex> vertices_;
    std::span<const uint> indices_;
    std::vector<Corners> surface_;
    DistanceTree tree_;
    std::vector<dvec3> points_; // of the surface
    double spacing_;            // m
};

std::vector<LodLevel> levelsOf(const Scene& scene, const Mesh& mesh, uint index, const LodOptions& options, const Advance& gone)
{
    const Primitive& p = mesh.primitives[index];
    const std::size_t triangles = p.indexCount / 3;
    if (triangles < kFewest) return {};
    std::span vertices(scene.vertices.data() + p.firstVertex, p.vertexCount);
    std::span indices(scene.indices.data() + p.firstIndex, 3 * triangles);

    std::vector<std::size_t> targets;
    for (float ratio : options.ratios)
        if (ratio < 1.0f) targets.push_back(std::size_t(double(max(ratio, 0.0f)) * double(triangles))); // not a NaN
    std::sort(targets.rbegin(), targets.rend());
    if (targets.empty()) return {};

    const double maxError = double(options.maxError) * diagonal(scene, mesh);
    ErrorGauge gauge(vertices, indices);
    std::vector<LodLevel> levels;
    std::size_t before = indices.size();
    for (std::vector<uint>& level :
         decimate({vertices, indices, sharedPoints(scene, mesh, index), maxError, double(options.uvDrift), gone}, targets)) {
        if (level.empty() || double(level.size()) > kWorthwhile * double(before)) continue;
        const auto [error, turn] = gauge(level);
        if (error > maxError) break;
        before = level.size();
        levels.push_back({std::move(level), float(error), float(turn)});
    }
    return levels;
}
}

std::vector<MeshLods> makeLods(const Scene& scene, const LodOptions& options, int threads, const Advance& advance, Journal* journal)
{
    std::vector<MeshLods> lods(scene.meshes.size());
    std::vector<Work> work;
    for (uint m = 0; m < scene.meshes.size(); ++m) {
        lods[m].primitives.resize(scene.meshes[m].primitives.size());
        for (uint p = 0; p < lods[m].primitives.size(); ++p) work.push_back({m, p});
    }
    parallelFor(work.size(), threads, [&](std::size_t i) {
        const Work& w = work[i];
        const Unit unit{Job::lods, std::uint32_t(i)};
        std::vector<LodLevel>& levels = lods[w.mesh].primitives[w.primitive];
        std::uint64_t left = scene.meshes[w.mesh].primitives[w.primitive].indexCount / 3;
        const std::optional<Done> done = journal ? journal->recall(unit) : std::nullopt;
        if (auto found = done ? unpackLevels(done->bytes) : std::nullopt) {
            levels = std::move(*found);
        } else {
            levels = levelsOf(scene, scene.meshes[w.mesh], w.primitive, options, [&](std::uint64_t gone) {
                advance(std::min(gone, left));
                left -= std::min(gone, left);
            });
            if (journal) journal->keep(unit, packLevels(levels), {});
        }
        advance(left);
    });
    return lods;
}
}
