#include "baker/seams.hpp"
#include "baker/distance.hpp"
#include "baker/owners.hpp"
#include "engine/core/jobs.hpp"
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace afterglow
{
namespace
{
constexpr double kPointsATexel = 2.0; // along a side; the other side adds its own
constexpr double kGap = 1.0 / 32.0;   // texels: what lies no further apart is one edge
constexpr float kAlike = 0.99985f;    // cosine of 1 degree: no light changes by more than a step of a display at middle grey
constexpr double kFoldedBack = 0.5;   // cosine between the ways into both surfaces: they lie over each other
constexpr double kDegenerate = 1e-30; // m2, texels2

// A side of a triangle at which its chart ends.
struct Border {
    dvec3 end[2];   // world, m
    vec3 normal[2]; // shading
    dvec3 inward;   // unit, in the plane of the triangle, away from the side
    dvec2 at[2];    // texels
    uint page;
    double texel; // m
};

// A side of a triangle, by where it lies on its page.
struct UvSide {
    uint object;
    vec2 low, high;
    uint triangle, corner; // it starts there
    auto place() const { return std::tie(object, low.x, low.y, high.x, high.y); }
    auto key() const { return std::tie(object, low.x, low.y, high.x, high.y, triangle, corner); }
};
}

static vec3 shadingNormal(const World& world, uint triangle, uint corner)
{
    const vec3 front = safeNormalize(world.front(triangle), vec3(0.0f, 1.0f, 0.0f));
    const vec3 shading = safeNormalize(world.vertices()[world.triangles()[triangle].vertex[corner]].normal, front);
    return dot(shading, front) < 0.0f ? front : shading;
}

// Sides that no other triangle of the object shares on the page.
static std::vector<UvSide> chartSides(const World& world, const std::vector<LightmapPlace>& places)
{
    std::vector<UvSide> all, borders;
    for (uint t = 0; t < world.triangles().size(); t++) {
        const World::Triangle& triangle = world.triangles()[t];
        if (places[triangle.object].page < 0) continue;
        for (uint i = 0; i < 3; i++) {
            const vec2 a = world.vertices()[triangle.vertex[i]].uv1, b = world.vertices()[triangle.vertex[(i + 1) % 3]].uv1;
            const bool turned = std::tie(b.x, b.y) < std::tie(a.x, a.y);
            all.push_back({triangle.object, turned ? b : a, turned ? a : b, t, i});
        }
    }
    std::sort(all.begin(), all.end(), [](const UvSide& a, const UvSide& b) { return a.key() < b.key(); });
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
        for (end = i; end < all.size() && all[end].place() == all[i].place();) ++end;
        if (end - i == 1) borders.push_back(all[i]);
    }
    return borders;
}

static std::vector<Border> bordersOf(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes)
{
    std::vector<Border> borders;
    for (const UvSide& side : chartSides(world, places)) {
        dvec3 p[3];
        dvec2 at[3];
        const uint order[3] = {side.corner, (side.corner + 1) % 3, (side.corner + 2) % 3};
        for (int i = 0; i < 3; i++) {
            p[i] = dvec3(world.vertices()[world.triangles()[side.triangle].vertex[order[i]]].position);
            at[i] = onPage(world, places, pageSizes, side.triangle, order[i]);
        }
        const dvec3 along = p[1] - p[0], across = cross(along, p[2] - p[0]);
        const dvec2 u = at[1] - at[0], v = at[2] - at[0];
        const double area = dot(across, across), texels = abs(u.x * v.y - u.y * v.x);
        if (!(area > kDegenerate) || !(texels > kDegenerate)) continue;
        borders.push_back({{p[0], p[1]},
                           {shadingNormal(world, side.triangle, order[0]), shadingNormal(world, side.triangle, order[1])},
                           normalize(cross(across, along)),
                           {at[0], at[1]},
                           uint(places[side.object].page),
                           std::sqrt(std::sqrt(area) / texels)});
    }
    return borders;
}

static vec3 normalAt(const Border& border, double t)
{
    return safeNormalize(mix(border.normal[0], border.normal[1], float(t)), border.normal[0]);
}

static Lookup lookupAt(const Border& border, double t) { return {border.page, vec2(mix(border.at[0], border.at[1], t))}; }

// One place of a page: a long side of a chart beside short ones of the same.
static bool areSame(const Lookup& a, const Lookup& b) { return a.page == b.page && distance(a.at, b.at) < float(kGap); }

// Where a border passes a point of another whose surface goes on there: the way along it, 0 to 1.
static std::optional<double> goesOn(const Border& border, const Border& other, const dvec3& point, const vec3& normal)
{
    const dvec3 along = border.end[1] - border.end[0];
    const double t = clamp(dot(point - border.end[0], along) / dot(along, along), 0.0, 1.0);
    if (distance(border.end[0] + t * along, point) > kGap * min(border.texel, other.texel)) return {};
    if (dot(border.inward, other.inward) > kFoldedBack || dot(normalAt(border, t), normal) < kAlike) return {};
    return t;
}

static std::vector<SeamPoint> pointsOf(const std::vector<Border>& borders, const DistanceTree& tree, std::size_t own)
{
    const Border& border = borders[own];
    const double texels = distance(border.at[0], border.at[1]);
    const int count = max(int(std::ceil(kPointsATexel * texels)), 1);
    std::vector<SeamPoint> points;
    for (int k = 0; k < count; k++) {
        const double t = (k + 0.5) / count;
        const dvec3 point = mix(border.end[0], border.end[1], t);
        const vec3 normal = normalAt(border, t);
        tree.near({point, point, point}, kGap * border.texel, [&](uint other) {
            if (other == own) return;
            const std::optional<double> there = goesOn(borders[other], border, point, normal);
            if (!there) return;
            const Lookup here = lookupAt(border, t), beyond = lookupAt(borders[other], *there);
            const double half = 0.5 * min(border.texel, borders[other].texel);
            if (!areSame(here, beyond))
                points.push_back({vec3(point),
                                  normal,
                                  {here, beyond},
                                  {vec3(half * border.inward), vec3(half * borders[other].inward)},
                                  float(kPointsATexel * texels / count)});
        });
    }
    return points;
}

std::vector<SeamPoint> seamPoints(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes,
                                  int threads)
{
    const std::vector<Border> borders = bordersOf(world, places, pageSizes);
    std::vector<Corners> sides;
    for (const Border& border : borders) sides.push_back({border.end[0], border.end[1], border.end[1]});
    const DistanceTree tree(sides);
    std::vector<std::vector<SeamPoint>> found(borders.size());
    parallelFor(borders.size(), threads, [&](std::size_t i) { found[i] = pointsOf(borders, tree, i); });
    std::vector<SeamPoint> points;
    for (std::vector<SeamPoint>& own : found) {
        points.insert(points.end(), own.begin(), own.end());
        std::vector<SeamPoint>().swap(own);
    }
    return points;
}
}
