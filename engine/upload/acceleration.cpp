// A structure for each placed mesh, all of them already in the world: edges that two meshes share stay whole, and both tracers meet the
// same float positions. One structure of the whole level instead took 2.4 to 3 times as long for a ray (gallery, two rooms; lavapipe 25.0).
#include "engine/upload/acceleration.hpp"
#include "engine/core/error.hpp"
#include "engine/scene/texel_range.hpp"
#include "engine/upload/storage.hpp"
#include "engine/upload/triangle_order.hpp"
#include "shaders/ray.h"
#include "shaders/ray_scene.h"
#include <algorithm>
#include <cstring>
#include <utility>

namespace afterglow
{
namespace
{
constexpr std::size_t kMostStructures = 4096; // more meshes than that share them, neighbours in the level's order together

// Triangles that become one structure.
struct Part {
    std::vector<uvec3> corners; // into the positions
    std::vector<RayTriangle> triangles;
    std::vector<uint> order; // GpuRays::order
    Extent extent{};
    uint instances = 0;
    Candidates candidates = Candidates::opaque;
};

// Appends the instance's triangles, which count from `firstTriangle`, to the part and its vertices, in the world, to the positions.
void place(const Scene& scene, const std::vector<Instance>& placed, uint number, uint firstTriangle, std::vector<vec3>& positions,
           Part& into)
{
    const Instance& instance = placed[number];
    const uint* first = &scene.indices[instance.firstIndex];
    const auto [lowest, highest] = std::minmax_element(first, first + instance.indexCount);
    const uint base = uint(positions.size()) - *lowest;
    for (uint i = *lowest; i <= *highest; ++i)
        positions.push_back(placedVertex(instance, scene.vertices[instance.firstVertex + i]).position);
    for (uint i = 0; i + 2 < instance.indexCount; i += 3) {
        RayTriangle triangle{};
        for (uint c = 0; c < 3; ++c) triangle.vertex[c] = instance.firstVertex + first[i + c];
        triangle.instance = number;
        into.triangles.push_back(triangle);
        into.order.push_back(firstTriangle + i / 3);
        into.corners.push_back(base + uvec3(first[i], first[i + 1], first[i + 2]));
    }
}

Extent extentOf(const std::vector<vec3>& positions, const uvec3& c)
{
    return {min(min(positions[c.x], positions[c.y]), positions[c.z]), max(max(positions[c.x], positions[c.y]), positions[c.z])};
}

void sort(const std::vector<vec3>& positions, Part& part)
{
    std::vector<Extent> extents;
    for (const uvec3& corners : part.corners) extents.push_back(extentOf(positions, corners));
    part.extent = extents[0];
    Part sorted = part;
    std::size_t next = 0;
    for (const uint i : medianOrder(extents)) {
        part.extent.lower = min(part.extent.lower, extents[i].lower);
        part.extent.upper = max(part.extent.upper, extents[i].upper);
        sorted.corners[next] = part.corners[i];
        sorted.order[next] = part.order[i];
        sorted.triangles[next++] = part.triangles[i];
    }
    part.corners = std::move(sorted.corners);
    part.order = std::move(sorted.order);
    part.triangles = std::move(sorted.triangles);
}

// One part for each instance, or for several where there are many; each holds one kind of candidates.
std::vector<Part> partsOf(const Scene& scene, const std::vector<Instance>& placed, std::vector<vec3>& positions)
{
    const std::size_t together = (placed.size() + kMostStructures - 1) / kMostStructures;
    std::vector<Part> parts;
    for (const Candidates candidates : {Candidates::opaque, Candidates::asked}) {
        std::size_t taken = 0;
        uint next = 0;
        for (std::size_t i = 0; i < placed.size(); ++i) {
            const uint firstTriangle = std::exchange(next, next + placed[i].indexCount / 3);
            const Candidates own = mayLetThrough(scene.materials[placed[i].material]) ? Candidates::asked : Candidates::opaque;
            if (own != candidates || placed[i].indexCount < 3) continue;
            if (taken++ % together == 0) parts.push_back({.candidates = candidates});
            place(scene, placed, uint(i), firstTriangle, positions, parts.back());
            ++parts.back().instances;
        }
    }
    for (Part& part : parts) sort(positions, part);
    return parts;
}

// No ray meets a triangle whose corners are one point.
Part point(std::vector<vec3>& positions)
{
    positions.push_back(vec3(0.0f));
    Part part{.corners = {uvec3(0)}, .triangles = {RayTriangle{}}};
    return part;
}

}

// By material, m.
static std::vector<float> meetingErrors(const Scene& scene, const std::vector<Instance>& placed, const std::vector<vec3>& positions,
                                        const std::vector<Part>& parts)
{
    std::vector<float> largest(scene.materials.size(), 0.0f);
    for (const Part& part : parts) {
        if (part.instances == 0) continue; // point()
        for (std::size_t i = 0; i < part.corners.size(); ++i) {
            const uvec3 c = part.corners[i];
            const vec3 a = positions[c.x], b = positions[c.y], d = positions[c.z];
            float& error = largest[placed[part.triangles[i].instance].material];
            error = max(error, meetingError(b - a, d - b, a - d)); // from a corner: nowhere on it is more
        }
    }
    return largest;
}

// In the order of the level's textures.
static void uploadTexels(Gpu& gpu, const Scene& scene, GpuRays& rays)
{
    std::size_t count = 0;
    for (const SceneTexture& texture : scene.textures) count += texture.image.pixels.size() / 4;
    if (count == 0 || count * 4 > gpu.device.limits.maxStorageBufferRange) return;
    std::vector<TexelRange> ranges;
    std::vector<uint> texels(count);
    uint first = 0;
    for (const SceneTexture& texture : scene.textures) {
        const std::vector<std::uint8_t>& pixels = texture.image.pixels;
        ranges.push_back(texelRange(texture, first));
        std::memcpy(&texels[first], pixels.data(), pixels.size());
        first += uint(pixels.size() / 4);
    }
    rays.texels = storage(gpu, "ray texels", texels);
    rays.textures = storage(gpu, "ray textures", ranges);
}

GpuRays buildRays(Gpu& gpu, const Scene& scene, const std::vector<Instance>& placed, RaysFor purpose)
{
    std::vector<vec3> positions;
    std::vector<Part> parts = partsOf(scene, placed, positions);
    if (parts.empty() && purpose == RaysFor::paths) parts.push_back(point(positions));
    GpuRays rays;
    std::vector<Extent> extents;
    std::vector<uvec3> corners;
    std::vector<RayTriangle> triangles;
    for (const Part& part : parts) {
        extents.push_back(part.extent);
        corners.insert(corners.end(), part.corners.begin(), part.corners.end());
        triangles.insert(triangles.end(), part.triangles.begin(), part.triangles.end());
        rays.order.insert(rays.order.end(), part.order.begin(), part.order.end());
    }
    if (triangles.empty()) return rays;
    if (triangles.size() > mostRayPrimitives(gpu.device))
        throw Error("the level has " + std::to_string(triangles.size()) + " triangles, and rays on " + gpu.device.deviceName + " take " +
                    std::to_string(mostRayPrimitives(gpu.device)) + ": draw it without rays");

    constexpr VkBufferUsageFlags kInput = VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;
    const GpuBuffer vertices = storage(gpu, "ray vertices", positions, kInput), indices = storage(gpu, "ray corners", corners, kInput);
    std::vector<uint> first;
    for (const Part& part : parts) {
        const uint count = uint(part.triangles.size());
        first.push_back(first.empty() ? 0u : first.back() + uint(parts[first.size() - 1].triangles.size()));
        rays.structures.push_back(buildTriangles(gpu.memory, "rays of a mesh",
                                                 {&vertices, uint(positions.size()), &indices, first.back(), count, part.candidates}));
        rays.filtered |= part.candidates == Candidates::asked;
    }
    for (const Instance& instance : placed) rays.tinted |= instance.indexCount >= 3 && mayTint(scene.materials[instance.material]);
    for (const uint i : medianOrder(extents)) {
        const uint number = parts[i].triangles.front().instance;
        if (parts[i].instances == 1) rays.meshes.push_back({placed[number], number, rays.placed.size()});
        const uint kind = parts[i].candidates == Candidates::asked ? kHitFiltered : kHitOpaque;
        rays.placed.push_back({.structure = rays.structures[i].address, .first = first[i], .record = kind * kRayKinds});
    }
    buildInstances(gpu.memory, "rays of the level", rays.placed, rays.level);
    rays.triangles = storage(gpu, "ray triangles", triangles);
    rays.instances = storage(gpu, "ray instances", placed);
    rays.meetingErrors = storage(gpu, "ray errors", meetingErrors(scene, placed, positions, parts));
    if (purpose == RaysFor::paths) uploadTexels(gpu, scene, rays);
    return rays;
}

void move(Gpu& gpu, GpuRays& rays, uint object, const mat4& toWorld)
{
    bool moved = false;
    for (const RayMesh& mesh : rays.meshes) {
        const dmat4 built(mat4(mesh.instance.toWorld));
        if (mesh.instance.object != object || determinant(built) == 0.0) continue;
        const mat4 way = mat4(dmat4(toWorld) * inverse(built));
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column) rays.placed[mesh.place].toWorld.matrix[row][column] = way[column][row];
        Instance now = mesh.instance;
        now.toWorld = mat4x3(toWorld);
        now.normalToWorld = inverse(transpose(mat3(toWorld)));
        gpu.memory.upload(rays.instances, &now, sizeof(now), mesh.number * sizeof(now));
        moved = true;
    }
    if (moved) buildInstances(gpu.memory, "rays of the level", rays.placed, rays.level);
}
}
