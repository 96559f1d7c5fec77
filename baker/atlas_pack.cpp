#include "baker/atlas_pack.hpp"
#include "baker/atlas_page.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace afterglow
{
namespace
{
constexpr int kWidthsTried = 6;
constexpr double kWidthStep = 1.1;
constexpr double kSizesPerOctave = 4.0; // alike, when it is asked where the last of a size stood

using Stances = std::vector<Stance>;

int roundUp(int x, int grain) { return (x + grain - 1) / grain * grain; }

// Where footprints of about the same size stood last: the rows below are full of their like.
struct Floors {
    std::map<std::pair<int, int>, int> rows;
    static int step(int size) { return int(kSizesPerOctave * std::log2(double(size))); }
    int& of(ivec2 size) { return rows[{step(size.x), step(size.y)}]; }
};

double areaOf(const Footprint& footprint)
{
    double area = 0.0;
    for (const Block& block : footprint.blocks) area += double(block.size.x) * block.size.y;
    return area;
}

// What may be meant by largest: none of them is best for all, and which one is for these shows when they are packed.
using Rank = double (*)(const Footprint&);
constexpr std::array<Rank, 4> kRanks{[](const Footprint& f) { return double(f.size.x) * f.size.y; }, areaOf,
                                     [](const Footprint& f) { return double(max(f.size.x, f.size.y)); },
                                     [](const Footprint& f) { return std::sqrt(max(f.size.x, f.size.y)) * f.size.x * f.size.y; }};

struct Packer {
    const std::vector<const Footprint*>& footprints;
    std::vector<Stances> stances; // per footprint
    std::vector<std::size_t> order;

    explicit Packer(const std::vector<const Footprint*>& all) : footprints(all), order(all.size())
    {
        for (const Footprint* f : footprints) stances.push_back(stancesOf(*f));
        std::iota(order.begin(), order.end(), std::size_t(0));
        largestFirst(kRanks[0]);
    }

    void largestFirst(Rank rank)
    {
        std::vector<double> ranks;
        for (const Footprint* f : footprints) ranks.push_back(rank(*f));
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return ranks[a] != ranks[b] ? ranks[a] > ranks[b] : a < b; });
    }

    std::optional<Packing> onto(int width, int mostHeight, int grain) const
    {
        Page page(width);
        Floors floors;
        Packing result;
        result.spots.resize(stances.size());
        int right = 0;
        for (std::size_t i : order) {
            stopIfInterrupted();
            const Stance* best = nullptr;
            ivec2 at;
            for (const Stance& stance : stances[i]) {
                const int limit = best ? at.y + best->size.y - 1 : mostHeight, from = max(0, floors.of(stance.size) - stance.size.y);
                std::optional<ivec2> spot = page.find(stance, from, limit);
                if (!spot) continue;
                at = *spot, best = &stance;
            }
            if (!best) return {};
            page.take(*best, at);
            floors.of(best->size) = at.y;
            result.spots[i] = {at, best->turns};
            right = max(right, at.x + best->size.x);
        }
        result.size = {roundUp(right, grain), roundUp(page.height(), grain)};
        return result;
    }
};
}

double footprintArea(const std::vector<const Footprint*>& footprints)
{
    double area = 0.0;
    for (const Footprint* f : footprints) area += areaOf(*f);
    return area;
}

// Most of what they cover is rectangles: those lie well in any order.
static bool rectangular(const std::vector<const Footprint*>& footprints)
{
    double rectangles = 0.0;
    for (const Footprint* f : footprints)
        if (f->blocks.size() == 1) rectangles += areaOf(*f);
    return rectangles > 0.5 * footprintArea(footprints);
}

Packing packUpwards(const std::vector<const Footprint*>& footprints, int width, int enough)
{
    int rows = 0; // enough for one above the other
    for (const Footprint* f : footprints) rows += max(f->size.x, f->size.y);
    Packer packer(footprints);
    Packing best = *packer.onto(width, rows, 1);
    if (rectangular(footprints)) return best;
    for (std::size_t rank = 1; rank < kRanks.size() && best.size.y > enough; ++rank) {
        packer.largestFirst(kRanks[rank]);
        if (std::optional<Packing> lower = packer.onto(width, best.size.y - 1, 1)) best = std::move(*lower);
    }
    return best;
}

std::optional<Packing> pack(const std::vector<const Footprint*>& footprints, int limit, int grain)
{
    int longest = 0;
    for (const Footprint* f : footprints) longest = max(longest, max(f->size.x, f->size.y));
    const double area = footprintArea(footprints);
    if (longest > limit || area > double(limit) * limit) return {};

    const Packer packer(footprints);
    double width = max(area / limit, 0.9 * std::sqrt(area));
    std::optional<Packing> best;
    auto texels = [](const Packing& p) { return double(p.size.x) * p.size.y; };
    for (int attempt = 0; attempt < kWidthsTried && (attempt == 0 || width <= limit); ++attempt, width *= kWidthStep) {
        int w = min(roundUp(int(std::ceil(width)), grain), limit);
        int mostHeight = best ? min(limit, int(texels(*best) / w)) : limit;
        std::optional<Packing> packing = packer.onto(w, mostHeight, grain);
        if (packing && (!best || texels(*packing) < texels(*best))) best = std::move(packing);
    }
    if (best) return best;
    return packer.onto(limit, limit, grain);
}
}
