#include "baker/parting.hpp"
#include "baker/irradiance.hpp"
#include "baker/pieces.hpp"
#include "baker/solids.hpp"
#include "shaders/color.h"
#include "shaders/ray_scene.h"
#include <algorithm>
#include <map>
#include <memory>
#include <mutex>

namespace afterglow
{
namespace
{
constexpr double kSame = 1.0 / (1 << 20); // of the largest coordinate: eight steps of a float
constexpr double kSpacing = 0.25;         // of a side of a triangle, between points of it
constexpr std::size_t kMostPoints = 16;   // of a part that are asked
constexpr uint kPaths = 16;               // of each of them
constexpr double kFar = 4.0;              // texels: further is open

struct PlacedMeshes {
    std::vector<PlacedTriangle> triangles;
    std::vector<std::size_t> first; // of each object; one more at the end
    double same = 0.0;              // m
};

PlacedMeshes placed(const Scene& scene)
{
    PlacedMeshes all;
    double largest = 0.0;
    for (uint o = 0; o < scene.objects.size(); o++) {
        const Object& object = scene.objects[o];
        all.first.push_back(all.triangles.size());
        if (!object.isStatic) continue;
        for (const Primitive& p : scene.meshes[object.mesh].primitives)
            for (uint i = 0; i < p.indexCount / 3 * 3; i += 3) {
                PlacedTriangle& t = all.triangles.emplace_back(PlacedTriangle{{}, o, !mayLetThrough(scene.materials[p.material])});
                for (uint k = 0; k < 3; k++) {
                    const vec3 at = scene.vertices[p.firstVertex + scene.indices[p.firstIndex + i + k]].position;
                    t.corner[k] = dvec3(object.toWorld * dvec4(dvec3(at), 1.0));
                    for (int axis = 0; axis < 3; axis++) largest = max(largest, abs(t.corner[k][axis]));
                }
            }
    }
    all.first.push_back(all.triangles.size());
    all.same = kSame * largest;
    return all;
}

// Asks the level how much light comes to parts of meshes, and whether a texel of that edge has a place there.
class Meter
{
public:
    Meter(const Scene& scene, double texel)
        : world_(scene, Content::staticOnly), transport_(world_, scene.lights), solids_(transport_), texel_(texel)
    {
        transport_.limits.rouletteFrom = 1;
    }

    std::optional<SurfaceLight> operator()(const CutMesh& mesh, const std::vector<uint>& triangles) const
    {
        std::vector<SurfacePlace> places;
        double area = 0.0;
        for (uint t : triangles) {
            const uint* p = mesh.triangles[t].point;
            const Corners corners{mesh.points[p[0]], mesh.points[p[1]], mesh.points[p[2]]};
            const vec3 normal = vec3(normalOf(corners));
            if (normal == vec3(0.0f)) continue;
            area += 0.5 * length(cross(corners[1] - corners[0], corners[2] - corners[0]));
            for (const dvec3& weight : samples(corners, kSpacing * distance(corners[0], corners[1])))
                places.push_back({vec3(corners[0] * weight[0] + corners[1] * weight[1] + corners[2] * weight[2]), normal});
        }
        const std::size_t step = places.size() / kMostPoints + 1;
        std::vector<SurfacePlace> asked;
        for (std::size_t i = 0; i < places.size(); i += step) asked.push_back(places[i]);
        const std::vector<Stand> stands = solids_.standsOf(asked);
        SurfaceLight sum;
        double open = 0.0, reach = 0.0;
        for (std::size_t i = 0; i < asked.size(); i++)
            if (stands[i] == Stand::open) open++, ask(asked[i], sum.light, reach);
        if (open == 0.0) return {};
        return SurfaceLight{sum.light / open, area > texel_ * texel_ && reach / open > texel_};
    }

private:
    // Adds mean light and mean free way, as far as it matters.
    void ask(const SurfacePlace& place, double& light, double& reach) const
    {
        const Surface white = whiteSurface(place.position, place.normal, place.normal);
        RayCount rays;
        const Tracer tracer{&transport_, &transport_.lights, &rays};
        for (uint i = 0; i < kPaths; i++) {
            Sampler random = makeSampler(0, i);
            const Ray ray = cosineRay(white, next2(random));
            const Hit hit = world_.closestHit(ray);
            const vec3 sample = irradianceSample(tracer, tracer, white, ray, hit, random);
            if (isFinite(sample)) light += double(luminance(sample)) / kPaths;
            reach += min(double(hit.distance), kFar * texel_) / kPaths;
        }
    }

    World world_;
    LightTransport transport_;
    Solids solids_;
    double texel_; // m
};

// A vertex of a triangle of a primitive, at these weights of its corners.
Vertex mixed(const Vertex* const corner[3], const dvec3& weights, vec3 position)
{
    const vec3 w(weights);
    const Vertex &a = *corner[0], &b = *corner[1], &c = *corner[2];
    Vertex v = a;
    v.position = position;
    v.normal = safeNormalize(w.x * a.normal + w.y * b.normal + w.z * c.normal, a.normal);
    v.tangent = vec4(safeNormalize(vec3(w.x * a.tangent + w.y * b.tangent + w.z * c.tangent), vec3(a.tangent)), a.tangent.w);
    v.uv0 = w.x * a.uv0 + w.y * b.uv0 + w.z * c.uv0;
    v.uv1 = w.x * a.uv1 + w.y * b.uv1 + w.z * c.uv1;
    v.color = packUnorm4x8(w.x * unpackUnorm4x8(a.color) + w.y * unpackUnorm4x8(b.color) + w.z * unpackUnorm4x8(c.color));
    return v;
}

dvec3 weightsOf(const Corners& t, const dvec3& p)
{
    const dvec3 across = cross(t[1] - t[0], t[2] - t[0]);
    const double b = dot(cross(p - t[0], t[2] - t[0]), across), c = dot(cross(t[1] - t[0], p - t[0]), across);
    return dvec3(dot(across, across) - b - c, b, c) / dot(across, across);
}

// The object's mesh takes the parts of its triangles in their place.
void rewrite(Scene& scene, Object& object, std::span<const Corners> triangles, const CutMesh& cut)
{
    const dmat4 toObject = inverse(object.toWorld);
    std::size_t next = 0; // part
    uint parent = 0;
    for (Primitive& p : scene.meshes[object.mesh].primitives) {
        Primitive parts{uint(scene.vertices.size()), p.vertexCount, uint(scene.indices.size()), 0, p.material};
        for (uint v = 0; v < p.vertexCount; v++) scene.vertices.push_back(Vertex(scene.vertices[p.firstVertex + v]));
        for (uint i = 0; i < p.indexCount / 3 * 3; i += 3, parent++) {
            const uint corner[3] = {scene.indices[p.firstIndex + i], scene.indices[p.firstIndex + i + 1],
                                    scene.indices[p.firstIndex + i + 2]};
            std::map<uint, uint> vertexOf; // of each point
            for (; next < cut.triangles.size() && cut.triangles[next].parent == parent; next++)
                for (uint point : cut.triangles[next].point) {
                    const dvec3& at = cut.points[point];
                    const auto [entry, isNew] = vertexOf.try_emplace(point, 0);
                    if (isNew) {
                        const Corners& whole = triangles[parent];
                        const auto same = std::find(whole.begin(), whole.end(), at);
                        entry->second = same != whole.end() ? corner[same - whole.begin()] : parts.vertexCount++;
                        if (same == whole.end()) {
                            const Vertex* const from[3] = {&scene.vertices[p.firstVertex + corner[0]],
                                                           &scene.vertices[p.firstVertex + corner[1]],
                                                           &scene.vertices[p.firstVertex + corner[2]]};
                            scene.vertices.push_back(mixed(from, weightsOf(whole, at), vec3(toObject * dvec4(at, 1.0))));
                        }
                    }
                    scene.indices.push_back(entry->second);
                    parts.indexCount++;
                }
        }
        p = parts;
    }
}
}

Pieces partMeshes(Scene& scene, double texelsPerMetre, int threads)
{
    const PlacedMeshes all = placed(scene);
    const std::vector<Lines> lines = contactsOf(all.triangles, all.same, threads);
    std::vector<PiecedMesh> parted(scene.objects.size());
    std::vector<std::vector<Corners>> surfaces(scene.objects.size());
    std::once_flag once;
    std::unique_ptr<Meter> meter; // costs a tree of the level: where something may part
    for (std::size_t o = 0; o < scene.objects.size(); o++) {
        const std::span<const Lines> ours(lines.begin() + std::ptrdiff_t(all.first[o]), lines.begin() + std::ptrdiff_t(all.first[o + 1]));
        if (std::all_of(ours.begin(), ours.end(), [](const Lines& l) { return l.empty(); })) continue;
        for (std::size_t t = all.first[o]; t < all.first[o + 1]; t++) surfaces[o].push_back(all.triangles[t].corner);
        parted[o] = piecesOf(
            surfaces[o], ours, all.same,
            [&](const CutMesh& mesh, const std::vector<uint>& part) {
                std::call_once(once, [&] { meter = std::make_unique<Meter>(scene, 1.0 / texelsPerMetre); });
                return (*meter)(mesh, part);
            },
            threads);
    }
    meter.reset();

    std::vector<int> users(scene.meshes.size(), 0);
    for (const Object& object : scene.objects) users[object.mesh]++;
    Pieces pieces(scene.meshes.size());
    for (std::size_t o = 0; o < scene.objects.size(); o++) {
        if (!parted[o].parted) continue;
        Object& object = scene.objects[o];
        if (users[object.mesh] > 1) {
            users[object.mesh]--;
            scene.meshes.push_back(Mesh(scene.meshes[object.mesh]));
            object.mesh = uint(scene.meshes.size() - 1);
            pieces.emplace_back();
        }
        rewrite(scene, object, surfaces[o], parted[o].mesh);
        pieces[object.mesh] = std::move(parted[o].piece);
    }
    return pieces;
}
}
