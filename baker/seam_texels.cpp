#include "baker/seam_texels.hpp"
#include "baker/texels.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/color.h"
#include <algorithm>
#include <optional>

namespace afterglow
{
// Cosine of 45 degrees, those of a ring of eight texels: a smooth surface that turns further from one texel to the next looks like an edge,
// as those of rounded furniture do, and light turns with it. Stitching seams up to 15, 45, 60 degrees changes the RMSE of all texels by
// factors of 0.98, 1.15, 1.26 in a draft of the gallery, of 1.17, 1.32, 1.52 in one of the two rooms.
static constexpr float kResolved = 0.7071f;

std::array<Weighted, 4> footprint(ivec2 pageSize, vec2 at)
{
    const vec2 p = at - 0.5f, cell = floor(p), f = p - cell;
    std::array<Weighted, 4> touched;
    for (int corner = 0; corner < 4; corner++) {
        const ivec2 step(corner & 1, corner >> 1), texel = clamp(ivec2(cell) + step, ivec2(0), pageSize - 1);
        touched[std::size_t(corner)] = {std::size_t(texel.y) * std::size_t(pageSize.x) + std::size_t(texel.x),
                                        (step.x ? f.x : 1.0f - f.x) * (step.y ? f.y : 1.0f - f.y)};
    }
    return touched;
}

static auto texelFrom(auto& seams, uint page, uint texel)
{
    return std::lower_bound(seams.texels.begin(), seams.texels.end(), std::pair(page, texel),
                            [](const SeamTexel& t, const std::pair<uint, uint>& place) { return t.place() < place; });
}

std::array<Weighted, 4> footprint(const Seams& seams, const Lookup& at)
{
    std::array<Weighted, 4> touched = footprint(seams.pageSizes[at.page], at.at);
    for (Weighted& w : touched) w.texel = std::size_t(texelFrom(seams, at.page, uint(w.texel)) - seams.texels.begin());
    return touched;
}

static std::vector<SeamTexel> touchedBy(const std::vector<SeamPoint>& points, const std::vector<ivec2>& pageSizes)
{
    std::vector<std::pair<uint, uint>> places; // of page and texel
    places.reserve(8 * points.size());
    for (const SeamPoint& point : points)
        for (const Lookup& side : point.side)
            for (const Weighted& w : footprint(pageSizes[side.page], side.at)) places.emplace_back(side.page, uint(w.texel));
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<SeamTexel> texels;
    texels.reserve(places.size());
    for (const auto& [page, texel] : places) texels.push_back({page, texel});
    return texels;
}

// How much of each texel of a page its chart covers.
static void measureShares(Seams& seams, uint page, const World& world, const std::vector<LightmapPlace>& places, const PageTriangles& bins,
                          int threads)
{
    const int width = seams.pageSizes[page].x;
    const auto placeOf = [&](const SeamTexel& t) { return ivec2(int(t.texel) % width, int(t.texel) / width); };
    std::vector<std::vector<SeamTexel*>> byTile(bins.byTile.size());
    for (auto t = texelFrom(seams, page, 0); t != seams.texels.end() && t->page == page; ++t) {
        const ivec2 tile = placeOf(*t) / kTileEdge;
        byTile[std::size_t(tile.y * bins.tiles.x + tile.x)].push_back(&*t);
    }
    parallelFor(byTile.size(), threads, [&](std::size_t i) {
        if (byTile[i].empty()) return;
        const ivec2 tile(int(i) % bins.tiles.x, int(i) / bins.tiles.x);
        const TilePoints points = rasteriseTile(world, places, seams.pageSizes[page], bins, tile);
        for (SeamTexel* texel : byTile[i]) {
            const ivec2 at = placeOf(*texel) - tile * kTileEdge;
            texel->share = float(points[std::size_t(at.y * kTileEdge + at.x)].size()) / float(kFineEdge * kFineEdge);
        }
    });
}

Seams findSeams(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes, int threads)
{
    Seams seams{pageSizes, seamPoints(world, places, pageSizes, threads), {}};
    seams.texels = touchedBy(seams.points, pageSizes);
    if (seams.texels.empty()) return seams;
    const std::vector<PageTriangles> bins = binTriangles(world, places, pageSizes);
    for (uint page = 0; page < bins.size(); page++) measureShares(seams, page, world, places, bins[page], threads);
    return seams;
}

// How light changes about a texel, from its neighbours with light of their own.
static void lookAround(const Lightmap& page, const std::vector<uint>& owner, SeamTexel& texel)
{
    const ivec2 at(int(texel.texel) % page.width, int(texel.texel) / page.width), size(page.width, page.height);
    const float own = luminance(page.texels[texel.texel]);
    const auto from = [&](ivec2 step) -> std::optional<float> {
        const ivec2 to = at + step;
        if (to != clamp(to, ivec2(0), size - 1)) return {};
        const std::size_t there = std::size_t(to.y) * std::size_t(page.width) + std::size_t(to.x);
        const bool isOurs = page.valid[there] == 1 && owner[there] == owner[texel.texel];
        return isOurs ? std::optional(luminance(page.texels[there]) - own) : std::nullopt;
    };
    bool isBetween = false;
    for (ivec2 step : {ivec2(1, 0), ivec2(0, 1), ivec2(1, 1), ivec2(1, -1)}) {
        const std::optional<float> ahead = from(step), behind = from(-step);
        for (const std::optional<float>& side : {ahead, behind})
            if (side) texel.spread = max(texel.spread, 0.5f * abs(*side));
        if (ahead && behind) texel.bend = max(texel.bend, 0.5f * abs(*ahead + *behind)), isBetween = true;
    }
    if (!isBetween) texel.bend = texel.spread;
}

void remember(Seams& seams, uint page, const Lightmap& lightmap, const TexelGuides& guides, const std::vector<uint>& owner)
{
    for (auto texel = texelFrom(seams, page, 0); texel != seams.texels.end() && texel->page == page; ++texel) {
        texel->measured = lightmap.valid[texel->texel] == 1;
        if (!texel->measured) continue;
        texel->position = guides.position[texel->texel];
        texel->normal = guides.normal[texel->texel];
        texel->variance = guides.variance[texel->texel];
        lookAround(lightmap, owner, *texel);
    }
}

// The texel with light of its own that says most of a lookup.
static const SeamTexel* foremost(const Seams& seams, const Lookup& at)
{
    const SeamTexel* found = nullptr;
    float most = 0.0f;
    for (const Weighted& w : footprint(seams, at))
        if (seams.texels[w.texel].measured && w.weight > most) found = &seams.texels[w.texel], most = w.weight;
    return found;
}

// Whether two points of the surface on either side see each other, on a line that passes above the seam however it is bent.
static bool seesAcross(const SeamPoint& point, vec3 from, vec3 to, const Sight& sight)
{
    const float rise = max(dot(point.position - from, point.normal), dot(point.position - to, point.normal)), apart = distance(from, to);
    return apart > 0.0f && sight(from, to, (max(rise, 0.0f) + kSightHeight * apart) * point.normal);
}

namespace
{
enum class Across : std::uint8_t { goesOn, turns, isParted };
}

static Across acrossOf(const Seams& seams, const SeamPoint& point, const Sight& sight, const Solids& solids)
{
    const SeamTexel *from = foremost(seams, point.side[0]), *to = foremost(seams, point.side[1]);
    if (!from || !to) return Across::isParted;
    if (dot(from->normal, to->normal) < kResolved) return Across::turns;
    const SurfacePlace place{point.position, point.normal};
    const bool isOpen = seesAcross(point, point.position + point.into[0], point.position + point.into[1], sight) && // nothing stands on it
                        seesAcross(point, from->position, to->position, sight) && // nor between what was measured
                        solids.standsOf({&place, 1}).front() == Stand::open;
    return isOpen ? Across::goesOn : Across::isParted;
}

std::size_t dropParted(Seams& seams, const Sight& sight, const Solids& solids, int threads)
{
    std::vector<Across> across(seams.points.size());
    parallelFor(across.size(), threads, [&](std::size_t i) { across[i] = acrossOf(seams, seams.points[i], sight, solids); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < across.size(); i++)
        if (across[i] == Across::goesOn) seams.points[kept++] = seams.points[i];
    seams.points.resize(kept);
    return std::size_t(std::count(across.begin(), across.end(), Across::turns));
}
}
