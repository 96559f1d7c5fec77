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

Footprints together(const std::vector<Footprints>& objects, const std::vector<std::size_t>& chosen)
{
    Footprints all;
    for (std::size_t o : chosen) all.insert(all.end(), objects[o].begin(), objects[o].end());
    return all;
}

void addPage(Pages& pages, const std::vector<Footprints>& objects, const std::vector<std::size_t>& chosen, const Packing& packing)
{
    auto spot = packing.spots.begin();
    for (std::size_t o : chosen) {
        pages.page[o] = int(pages.sizes.size());
        pages.spots[o].assign(spot, spot + std::ptrdiff_t(objects[o].size()));
        spot += std::ptrdiff_t(objects[o].size());
    }
    pages.sizes.push_back(packing.size);
}

struct Waiting {
    std::vector<double> areas;        // texels, per object
    std::vector<std::size_t> objects; // largest first

    explicit Waiting(const std::vector<Footprints>& all)
    {
        for (const Footprints& object : all) areas.push_back(footprintArea(object));
        for (std::size_t o = 0; o < all.size(); ++o)
            if (!all[o].empty()) objects.push_back(o);
        std::stable_sort(objects.begin(), objects.end(), [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
    }

    // The largest, and what else has room beside it on so many texels.
    std::vector<std::size_t> choose(double room) const
    {
        std::vector<std::size_t> chosen;
        for (std::size_t o : objects)
            if (chosen.empty() || areas[o] <= room) {
                chosen.push_back(o);
                room -= areas[o];
            }
        return chosen;
    }

    void drop(const Pages& pages)
    {
        std::erase_if(objects, [&](std::size_t o) { return pages.page[o] >= 0; });
    }
};

Pages noPages(std::size_t objects) { return {{}, std::vector<int>(objects, -1), std::vector<std::vector<Spot>>(objects)}; }
}

bool fitsPage(const Footprints& object, const PageLimits& limits) { return packAlone(object, limits).has_value(); }

Pages sharePages(const std::vector<Footprints>& objects, const PageLimits& limits)
{
    Pages pages = noPages(objects.size());
    Waiting waiting(objects);
    double total = std::accumulate(waiting.areas.begin(), waiting.areas.end(), 0.0);
    int edge = limits.edge;
    while (total > kPagesBeforeGrowth * edge * edge && 2 * edge <= limits.largestEdge) edge *= 2;

    double fill = kFirstFill;
    while (!waiting.objects.empty()) {
        const std::vector<std::size_t> chosen = waiting.choose(fill * edge * edge);
        std::optional<Packing> packing = pack(together(objects, chosen), edge, limits.grain);
        if (!packing && chosen.size() > 1) {
            fill -= kFillStep;
            continue;
        }
        for (double larger = 1.25 * edge; !packing; larger *= 1.25) {
            int limit = min(int(larger), limits.largestEdge);
            packing = pack(objects[chosen[0]], limit, limits.grain);
            check(packing || limit < limits.largestEdge, "an object is larger than the largest page");
        }
        addPage(pages, objects, chosen, *packing);
        waiting.drop(pages);
        fill = kFirstFill;
    }
    return pages;
}

Pages fillPages(const std::vector<Footprints>& objects, int count, const PageLimits& limits)
{
    Pages pages = noPages(objects.size());
    Waiting waiting(objects);
    double fill = kFirstFill;
    while (!waiting.objects.empty()) {
        const bool last = int(pages.sizes.size()) + 1 == count;
        const std::vector<std::size_t> chosen = last ? waiting.objects : waiting.choose(fill * limits.edge * limits.edge);
        Packing packing = packUpwards(together(objects, chosen), limits.edge, limits.edge);
        if (!last && packing.size.y > limits.edge && chosen.size() > 1) {
            fill -= kFillStep;
            continue;
        }
        packing.size = ivec2(limits.edge, last ? packing.size.y : max(packing.size.y, limits.edge));
        addPage(pages, objects, chosen, packing);
        waiting.drop(pages);
        fill = kFirstFill;
    }
    return pages;
}

std::optional<Pages> pressPages(const std::vector<Footprints>& objects, Pages pages, double larger, Patience& patience)
{
    for (std::size_t page = 0; page < pages.sizes.size(); ++page) {
        Footprints footprints;
        std::vector<Spot> spots;
        for (std::size_t o = 0; o < objects.size(); ++o)
            if (pages.page[o] == int(page)) {
                footprints.insert(footprints.end(), objects[o].begin(), objects[o].end());
                spots.insert(spots.end(), pages.spots[o].begin(), pages.spots[o].end());
            }
        for (Spot& spot : spots) spot.origin = ivec2(dvec2(spot.origin) * larger);
        std::optional<std::vector<Spot>> pressed = press(footprints, std::move(spots), pages.sizes[page], patience);
        if (!pressed) return {};
        auto next = pressed->begin();
        for (std::size_t o = 0; o < objects.size(); ++o)
            if (pages.page[o] == int(page))
                for (Spot& spot : pages.spots[o]) spot = *next++;
    }
    return pages;
}
}
