#include "baker/atlas_pages.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <numeric>

namespace afterglow
{
namespace
{
constexpr double kFirstFill = 0.95;      // of a page's area, tried first, by footprints
constexpr double kFillStep = 0.04;       // less each time they did not fit
constexpr double kPagesBeforeGrowth = 8; // a level of more than so many pages gets larger ones

std::optional<Packing> packAlone(const Footprints& object, const PageLimits& limits)
{
    for (double edge = limits.edge;; edge *= 1.25) {
        int limit = min(int(edge), limits.largestEdge);
        if (std::optional<Packing> packing = pack(object, limit, limits.grain)) return packing;
        if (limit == limits.largestEdge) return {};
    }
}

// Puts the chosen objects on a new page, if they fit.
bool addPage(Pages& pages, const std::vector<Footprints>& objects, const std::vector<std::size_t>& chosen, int limit, int grain)
{
    Footprints all;
    for (std::size_t o : chosen) all.insert(all.end(), objects[o].begin(), objects[o].end());
    std::optional<Packing> packing = pack(all, limit, grain);
    if (!packing) return false;
    auto origin = packing->origins.begin();
    for (std::size_t o : chosen) {
        pages.page[o] = int(pages.sizes.size());
        pages.origins[o].assign(origin, origin + std::ptrdiff_t(objects[o].size()));
        origin += std::ptrdiff_t(objects[o].size());
    }
    pages.sizes.push_back(packing->size);
    return true;
}
}

bool fitsPage(const Footprints& object, const PageLimits& limits) { return packAlone(object, limits).has_value(); }

Pages sharePages(const std::vector<Footprints>& objects, const PageLimits& limits)
{
    Pages pages;
    pages.page.assign(objects.size(), -1);
    pages.origins.resize(objects.size());

    std::vector<double> areas;
    for (const Footprints& object : objects) areas.push_back(footprintArea(object));
    double total = std::accumulate(areas.begin(), areas.end(), 0.0);
    int edge = limits.edge;
    while (total > kPagesBeforeGrowth * edge * edge && 2 * edge <= limits.largestEdge) edge *= 2;

    std::vector<std::size_t> waiting; // largest first
    for (std::size_t o = 0; o < objects.size(); ++o)
        if (!objects[o].empty()) waiting.push_back(o);
    std::stable_sort(waiting.begin(), waiting.end(), [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });

    double fill = kFirstFill;
    while (!waiting.empty()) {
        std::vector<std::size_t> chosen;
        double taken = 0.0;
        for (std::size_t o : waiting)
            if (chosen.empty() || taken + areas[o] <= fill * edge * edge) {
                chosen.push_back(o);
                taken += areas[o];
            }
        if (!addPage(pages, objects, chosen, edge, limits.grain)) {
            if (chosen.size() > 1) {
                fill -= kFillStep;
                continue;
            }
            bool placed = false;
            for (double larger = 1.25 * edge; !placed; larger *= 1.25) {
                int limit = min(int(larger), limits.largestEdge);
                placed = addPage(pages, objects, chosen, limit, limits.grain);
                check(placed || limit < limits.largestEdge, "an object is larger than the largest page");
            }
        }
        std::erase_if(waiting, [&](std::size_t o) { return pages.page[o] >= 0; });
        fill = kFirstFill;
    }
    return pages;
}
}
