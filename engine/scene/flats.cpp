#include "engine/scene/flats.hpp"
#include "shaders/camera.h"
#include "shaders/frame.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr double kFlatness = 1e-4;      // of its extent: how far a flat surface may leave its plane
constexpr double kSameNormal = 1e-6;    // 1 - cosine, and
constexpr double kSamePlane = 1e-4;     // m: coplanar surfaces share a view
constexpr float kSharpRoughness = 0.1f; // above it what is mirrored blurs: the probes' part

bool isMirror(const Material& material, const Object& object) { return object.mirror || (material.flags & kMaterialMirror) != 0; }

// Why a material cannot be a mirror; empty: it can.
std::string unfit(const Material& material)
{
    if ((material.flags & (kMaterialLambert | kMaterialUnlit)) != 0) return "its material reflects nothing";
    if ((material.flags & kMaterialAlphaMask) != 0) return "its material has an alpha mask";
    if (material.roughness > kSharpRoughness) return "its material is rough";
    return "";
}

std::vector<dvec3> cornersOf(const Scene& scene, const Instance& instance)
{
    std::vector<dvec3> corners;
    const dmat4 toWorld = scene.objects[instance.object].toWorld;
    for (uint i = 0; i < instance.indexCount; ++i) {
        const Vertex& vertex = scene.vertices[instance.firstVertex + scene.indices[instance.firstIndex + i]];
        corners.emplace_back(toWorld * dvec4(dvec3(vertex.position), 1.0));
    }
    return corners;
}

// The plane of a surface all of whose triangles face one way; nothing when it is curved or empty.
std::optional<Flat> planeOf(const std::vector<dvec3>& corners)
{
    dvec3 sum(0.0), lower(1e30), upper(-1e30);
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const dvec3 front = cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
        sum += front;
        area += length(front);
    }
    if (!(area > 0.0) || !(length(sum) > (1.0 - kFlatness) * area)) return std::nullopt;
    Flat flat;
    flat.normal = normalize(sum);
    for (const dvec3& corner : corners) {
        flat.offset += dot(flat.normal, corner) / double(corners.size());
        lower = min(lower, corner);
        upper = max(upper, corner);
    }
    for (const dvec3& corner : corners)
        if (std::abs(dot(flat.normal, corner) - flat.offset) > kFlatness * distance(lower, upper)) return std::nullopt;
    return flat;
}

// The rectangle of the plane that holds these points.
std::array<dvec3, 4> rectangle(const Flat& flat, const std::vector<dvec3>& points)
{
    const Frame frame = makeFrame(vec3(flat.normal));
    const dvec3 x(frame.tangent), y(frame.bitangent), origin = flat.normal * flat.offset;
    dvec2 lower(1e30), upper(-1e30);
    for (const dvec3& point : points) {
        const dvec2 at(dot(x, point), dot(y, point));
        lower = min(lower, at);
        upper = max(upper, at);
    }
    return {origin + x * lower.x + y * lower.y, origin + x * upper.x + y * lower.y, origin + x * upper.x + y * upper.y,
            origin + x * lower.x + y * upper.y};
}

// Looking through a plane is looking along -normal: where that leads is where the world beyond begins.
void pass(Flat& flat, const dmat4& through)
{
    flat.through = through;
    flat.beyond = normalize(dmat3(through) * -flat.normal);
    flat.beyondOffset = dot(flat.beyond, dvec3(through * dvec4(flat.normal * flat.offset, 1.0)));
}

// A node's place without its scale.
dmat4 rigid(const dmat4& m)
{
    const dvec3 x = normalize(dvec3(m[0])), y = normalize(dvec3(m[1]) - x * dot(x, dvec3(m[1])));
    return dmat4(dvec4(x, 0), dvec4(y, 0), dvec4(cross(x, y), 0), m[3]);
}

// What enters one node's front leaves the front of the other, upright as it entered: half a turn about the nodes' y, about x where the
// portal faces along y.
dmat4 between(const Flat& flat, const dmat4& here, const dmat4& there)
{
    const dmat4 from = rigid(here);
    const bool upward = std::abs(dot(flat.normal, dvec3(from[1]))) > 0.7;
    dmat4 half(1.0);
    half[2][2] = -1.0;
    half[upward ? 1 : 0][upward ? 1 : 0] = -1.0;
    return rigid(there) * half * inverse(from);
}

const Object* objectNamed(const Scene& scene, const std::string& name)
{
    const auto found = std::find_if(scene.objects.begin(), scene.objects.end(), [&](const Object& object) { return object.name == name; });
    return found == scene.objects.end() ? nullptr : &*found;
}

bool coplanar(const Flat& a, const Flat& b)
{
    return 1.0 - dot(a.normal, b.normal) < kSameNormal && std::abs(a.offset - b.offset) < kSamePlane;
}
}

Flats findFlats(const Scene& scene)
{
    Flats flats;
    std::vector<std::vector<dvec3>> points; // of each mirror
    const std::vector<Instance> placed = instances(scene);
    for (uint i = 0; i < placed.size(); ++i) {
        const Object& object = scene.objects[placed[i].object];
        const Material& material = scene.materials[placed[i].material];
        const bool portal = !object.portal.empty();
        if (!portal && !isMirror(material, object)) continue;
        const Object* twin = portal ? objectNamed(scene, object.portal) : nullptr;
        const std::vector<dvec3> corners = cornersOf(scene, placed[i]);
        std::optional<Flat> flat = planeOf(corners);
        std::string why = portal ? (twin ? "" : "no mesh node is called \"" + object.portal + "\"") : unfit(material);
        if (why.empty() && !flat) why = "it is not flat";
        if (!why.empty()) {
            flats.refused.emplace_back(portal ? FlatKind::portal : FlatKind::mirror, "node \"" + object.name + "\": " + why);
            continue;
        }
        flat->name = object.name;
        flat->kind = portal ? FlatKind::portal : FlatKind::mirror;
        flat->rippled = !portal && material.normalTexture.texture >= 0;
        flat->twoSided = !portal && material.metallic == 1.0f;
        flat->surfaces.push_back(i);
        if (portal) {
            flat->corners = rectangle(*flat, corners);
            pass(*flat, between(*flat, object.toWorld, twin->toWorld));
            flats.portals.push_back(*flat);
            continue;
        }
        const auto same = std::find_if(flats.mirrors.begin(), flats.mirrors.end(), [&](const Flat& m) { return coplanar(m, *flat); });
        if (same == flats.mirrors.end()) {
            pass(*flat, dmat4(mirrorMatrix(vec3(flat->normal), float(flat->offset))));
            flats.mirrors.push_back(*flat);
            points.push_back(corners);
        } else {
            std::vector<dvec3>& all = points[std::size_t(same - flats.mirrors.begin())];
            all.insert(all.end(), corners.begin(), corners.end());
            same->surfaces.push_back(i);
            same->rippled |= flat->rippled;
            same->twoSided &= flat->twoSided;
        }
    }
    for (std::size_t i = 0; i < flats.mirrors.size(); ++i) flats.mirrors[i].corners = rectangle(flats.mirrors[i], points[i]);
    return flats;
}
}
