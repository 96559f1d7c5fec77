#include "baker/owners.hpp"
#include "baker/atlas_footprint.hpp"
#include "baker/sets.hpp"
#include <algorithm>
#include <numeric>
#include <tuple>

namespace afterglow
{
static constexpr double kTouch = 1.0 - 1.0 / 256.0; // texels from the chart: further, a lookup's weight is below a sampler's eight bits

// Of each triangle the first of its chart.
static std::vector<uint> firstOfChart(const World& world)
{
    struct Corner {
        uint object;
        vec2 uv;
        uint triangle;
        auto key() const { return std::tie(object, uv.x, uv.y, triangle); }
    };
    std::vector<Corner> corners;
    for (uint t = 0; t < world.triangles().size(); t++)
        for (uint vertex : world.triangles()[t].vertex) corners.push_back({world.triangles()[t].object, world.vertices()[vertex].uv1, t});
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.key() < b.key(); });
    Sets sets(world.triangles().size());
    for (std::size_t i = 1; i < corners.size(); i++)
        if (corners[i].object == corners[i - 1].object && corners[i].uv == corners[i - 1].uv)
            sets.join(corners[i - 1].triangle, corners[i].triangle);
    std::vector<uint> first;
    for (uint t = 0; t < world.triangles().size(); t++) first.push_back(sets.root(t));
    return first;
}

dvec2 onPage(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes, uint triangle, uint corner)
{
    const World::Triangle& t = world.triangles()[triangle];
    const LightmapPlace& place = places[t.object];
    return dvec2(world.vertices()[t.vertex[corner]].uv1 * place.scale + place.offset) * dvec2(pageSizes[std::size_t(place.page)]);
}

Owners findOwners(const World& world, const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes)
{
    Owners owners;
    owners.chartOf = firstOfChart(world);
    for (ivec2 size : pageSizes) owners.texelOf.emplace_back(std::size_t(size.x) * std::size_t(size.y), kNobody);
    std::vector<std::vector<dvec2>> charts(world.triangles().size()); // corners, by the chart's first triangle
    for (uint t = 0; t < world.triangles().size(); t++) {
        if (places[world.triangles()[t].object].page < 0)
            owners.chartOf[t] = kNobody;
        else
            for (uint corner = 0; corner < 3; corner++) charts[owners.chartOf[t]].push_back(onPage(world, places, pageSizes, t, corner));
    }
    for (uint chart = 0; chart < charts.size(); chart++) {
        if (charts[chart].empty()) continue;
        const std::size_t page = std::size_t(places[world.triangles()[chart].object].page);
        const ivec2 size = pageSizes[page];
        std::vector<uint> sides(charts[chart].size()); // all of them: which are the rim is not known here
        std::iota(sides.begin(), sides.end(), 0u);
        ivec2 origin;
        for (const Block& block : footprint(charts[chart], sides, kTouch, origin).blocks) {
            const ivec2 lower = max(origin + block.lower, ivec2(0)), upper = min(origin + block.lower + block.size, size);
            for (int y = lower.y; y < upper.y; y++)
                for (int x = lower.x; x < upper.x; x++) {
                    uint& owner = owners.texelOf[page][std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
                    owner = min(owner, chart);
                }
        }
    }
    return owners;
}
}
