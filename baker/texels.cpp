#include "baker/texels.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
// A triangle in texels of its page.
struct Flat {
    vec2 corner[3];
};
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

std::vector<std::vector<TexelPoint>> rasteriseTile(const World& world, const std::vector<LightmapPlace>& places, ivec2 pageSize,
                                                   const PageTriangles& page, ivec2 tile)
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
                if (cell.triangle == kNone) cell = TexelPoint{t, vec2(b, c)};
            }
        ivec2 middle = ivec2(floor((flat.corner[0] + flat.corner[1] + flat.corner[2]) / 3.0f + 0.5f));
        if (middle.x < 0 || middle.y < 0 || middle.x >= kEdge || middle.y >= kEdge) continue;
        TexelPoint& cell = fine[std::size_t(middle.y * kEdge + middle.x)];
        if (cell.triangle == kNone) cell = TexelPoint{t, vec2(1.0f / 3.0f)};
    }

    std::vector<std::vector<TexelPoint>> texels(kTileTexels);
    for (int y = 0; y < kEdge; y++)
        for (int x = 0; x < kEdge; x++) {
            const TexelPoint& cell = fine[std::size_t(y * kEdge + x)];
            if (cell.triangle != kNone) texels[std::size_t(y / kFineEdge * kTileEdge + x / kFineEdge)].push_back(cell);
        }
    return texels;
}
}
