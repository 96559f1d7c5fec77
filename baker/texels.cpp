#include "baker/texels.hpp"
#include "baker/islands.hpp"
#include "shaders/inset.h"
#include <algorithm>
#include <bit>
#include <cmath>

namespace afterglow
{
namespace
{
// A triangle in texels of its page.
struct Flat {
    vec2 corner[3];
};
}

static Flat flatten(const World& world, const LightmapPlace& place, ivec2 pageSize, uint triangle)
{
    Flat flat;
    for (int i = 0; i < 3; i++) {
        vec2 uv = world.vertices()[world.triangles()[triangle].vertex[i]].uv1 * place.scale + place.offset;
        flat.corner[i] = uv * vec2(pageSize);
    }
    return flat;
}

static float edge(vec2 a, vec2 b, vec2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

std::vector<PageTriangles> binTriangles(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes)
{
    std::vector<PageTriangles> pages(pageSizes.size());
    for (std::size_t i = 0; i < pages.size(); i++) {
        pages[i].tiles = (pageSizes[i] + kTileEdge - 1) / kTileEdge;
        pages[i].byTile.resize(std::size_t(pages[i].tiles.x) * std::size_t(pages[i].tiles.y));
    }
    for (uint t = 0; t < world.triangles().size(); t++) {
        const LightmapPlace& place = places[world.triangles()[t].object];
        if (place.page < 0) continue;
        PageTriangles& page = pages[std::size_t(place.page)];
        Flat flat = flatten(world, place, pageSizes[std::size_t(place.page)], t);
        vec2 lower = min(min(flat.corner[0], flat.corner[1]), flat.corner[2]);
        vec2 upper = max(max(flat.corner[0], flat.corner[1]), flat.corner[2]);
        ivec2 first = clamp(ivec2(floor(lower)) / kTileEdge, ivec2(0), page.tiles - 1);
        ivec2 last = clamp(ivec2(floor(upper)) / kTileEdge, ivec2(0), page.tiles - 1);
        for (int y = first.y; y <= last.y; y++)
            for (int x = first.x; x <= last.x; x++) page.byTile[std::size_t(y * page.tiles.x + x)].push_back(t);
    }
    return pages;
}

// Positions keep off the edges of their triangle by a share of a texel that moves no light, and far enough that the step off the surface meets
// no wall at an angle of 4 degrees.
static constexpr float kInset = 1.0f / 64.0f; // texels: a sixteenth of what lies between positions
static constexpr float kSteps = 16.0f;        // of stepOff()
static constexpr float kMostInset = 0.25f;    // texels

static vec2 keptOffEdges(const World& world, const TexelPoint& point, float twiceTexels)
{
    vec3 corner[3];
    for (int i = 0; i < 3; i++) corner[i] = world.vertices()[world.triangles()[point.triangle].vertex[i]].position;
    const vec3 front = world.front(point.triangle);
    const float twiceArea = length(front);
    if (!(twiceArea > 0.0f) || !(twiceTexels > 0.0f)) return point.barycentric;
    const float texel = std::sqrt(twiceArea / twiceTexels); // m
    const float step = stepOff(corner[0], front / twiceArea);
    const float inset = clamp(kSteps * step, kInset * texel, kMostInset * texel);
    return shared::keptOffEdges(point.barycentric, min(insetShares(corner[0], corner[1], corner[2], front, inset), vec3(1.0f / 3.0f)));
}

TilePoints rasteriseTile(const World& world, const std::vector<LightmapPlace>& places, ivec2 pageSize, const PageTriangles& page,
                         ivec2 tile)
{
    constexpr int kEdge = kTileEdge * kFineEdge;
    constexpr uint kNone = ~0u;
    std::vector<TexelPoint> fine(std::size_t(kEdge * kEdge), TexelPoint{kNone, vec2(0.0f)});
    vec2 corner = vec2(tile * kTileEdge);
    for (uint t : page.byTile[std::size_t(tile.y * page.tiles.x + tile.x)]) {
        Flat flat = flatten(world, places[world.triangles()[t].object], pageSize, t);
        for (vec2& c : flat.corner) c = (c - corner) * float(kFineEdge) - 0.5f; // in fine cells, centres at integers
        float area = edge(flat.corner[0], flat.corner[1], flat.corner[2]);
        vec2 lower = max(ceil(min(min(flat.corner[0], flat.corner[1]), flat.corner[2])), vec2(0.0f));
        vec2 upper = min(floor(max(max(flat.corner[0], flat.corner[1]), flat.corner[2])), vec2(float(kEdge - 1)));
        for (float y = lower.y; y <= upper.y && area != 0.0f; y += 1.0f)
            for (float x = lower.x; x <= upper.x; x += 1.0f) {
                vec2 p(x, y);
                float b = edge(flat.corner[2], flat.corner[0], p) / area, c = edge(flat.corner[0], flat.corner[1], p) / area;
                if (b < 0.0f || c < 0.0f || b + c > 1.0f) continue;
                TexelPoint& cell = fine[std::size_t(int(y) * kEdge + int(x))];
                if (cell.triangle == kNone) cell = {t, keptOffEdges(world, {t, vec2(b, c)}, abs(area) / float(kFineEdge * kFineEdge))};
            }
        ivec2 middle = ivec2(floor((flat.corner[0] + flat.corner[1] + flat.corner[2]) / 3.0f + 0.5f));
        if (middle.x < 0 || middle.y < 0 || middle.x >= kEdge || middle.y >= kEdge) continue;
        TexelPoint& cell = fine[std::size_t(middle.y * kEdge + middle.x)];
        if (cell.triangle == kNone) cell = TexelPoint{t, vec2(1.0f / 3.0f)};
    }

    TilePoints texels(kTileTexels);
    for (int y = 0; y < kEdge; y++)
        for (int x = 0; x < kEdge; x++) {
            const TexelPoint& cell = fine[std::size_t(y * kEdge + x)];
            if (cell.triangle != kNone) texels[std::size_t(y / kFineEdge * kTileEdge + x / kFineEdge)].push_back(cell);
        }
    return texels;
}

static constexpr float kLeastOpen = 0.1f; // of a texel's points: fewer are too few to stand for it

static SurfacePlace placeOf(const World& world, const TexelPoint& point)
{
    const uint* corner = world.triangles()[point.triangle].vertex;
    const std::vector<Vertex>& v = world.vertices();
    const float b = point.barycentric.x, c = point.barycentric.y, a = 1.0f - b - c;
    return {a * v[corner[0]].position + b * v[corner[1]].position + c * v[corner[2]].position,
            safeNormalize(world.front(point.triangle), vec3(0.0f, 1.0f, 0.0f))};
}

TileMask openPoints(const World& world, const Solids& solids, const TilePoints& texels)
{
    TileMask mask{};
    std::vector<SurfacePlace> places;
    for (std::size_t texel = 0; texel < texels.size(); texel++) {
        places.clear();
        for (const TexelPoint& point : texels[texel]) places.push_back(placeOf(world, point));
        const std::vector<Stand> stands = solids.standsOf(places);
        uint open = 0, seen = 0;
        for (std::size_t p = 0; p < stands.size(); p++) {
            if (stands[p] == Stand::open) open |= 1u << p;
            if (stands[p] != Stand::unseen) seen |= 1u << p;
        }
        if (float(std::popcount(seen)) < kLeastOpen * float(stands.size())) continue;
        mask[texel] = std::uint16_t(open != 0 ? open : seen);
    }
    return mask;
}

void leaveOutOthers(const TileMask& counting, TilePoints& texels)
{
    for (std::size_t texel = 0; texel < texels.size(); texel++) {
        std::vector<TexelPoint> left;
        for (std::size_t p = 0; p < texels[texel].size(); p++)
            if ((counting[texel] >> p & 1) != 0) left.push_back(texels[texel][p]);
        texels[texel] = std::move(left);
    }
}

std::bitset<kTileTexels> partedTexels(const World& world, const TilePoints& texels)
{
    std::bitset<kTileTexels> parted;
    for (std::size_t texel = 0; texel < texels.size(); texel++) {
        if (texels[texel].size() < 2) continue;
        Ray rays[kPacket];
        vec3 passed[kPacket];
        int count = 0;
        const SurfacePlace first = placeOf(world, texels[texel].front());
        for (const TexelPoint& point : texels[texel]) {
            const vec3 way = placeOf(world, point).position - first.position;
            const float apart = length(way);
            if (apart > 0.0f) rays[count++] = {first.position + kSightHeight * apart * first.normal, way / apart, apart};
        }
        world.transmittances(rays, passed, count);
        parted[texel] = std::any_of(passed, passed + count, [](vec3 light) { return !(largestOf(light) > 0.0f); });
    }
    return parted;
}
}
