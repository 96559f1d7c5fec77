#include "baker/atlas_press.hpp"
#include "baker/atlas_silhouette.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace afterglow
{
namespace
{
constexpr int kCoarse = 4;          // texels along a cell, where footprints look for room all over the page
constexpr int kReach = 8;           // texels that they move at most, at a time, once they are asked texel by texel
constexpr int kTries = 4;           // coarse, then fine
constexpr int kCoarsePasses = 60;   // over the footprints, in a try
constexpr int kFinePasses = 80;     // the same texel by texel
constexpr double kNearly = 2e-4;    // of the page: coarse silhouettes that overlap less may yet be parted texel by texel
constexpr double kCost = 1024.0;    // of an overlap as large as the smaller of two, in units of its square root
constexpr double kGain = 1.2;       // times the weight of two that overlap, after a pass
constexpr double kWorstGain = 2.0;  // and of those that overlap most
constexpr double kLoss = 0.95;      // of two that do not
constexpr double kHeaviest = 300.0; // times what it was
constexpr std::size_t kMost = 2000; // footprints: pairs are remembered

constexpr std::array<int, 8> kRows{0, 4, 2, 6, 1, 5, 3, 7}; // of every eight, in the order in which they are asked

using Silhouettes = std::vector<Silhouette>; // the stances of one footprint

struct Place {
    ivec2 at; // cells
    std::size_t stance;
};

// The page as cells of one size.
class Sheet
{
public:
    Sheet(std::vector<Silhouettes> all, ivec2 size)
        : all_(std::move(all)), size_(size), weights_(all_.size() * all_.size(), 1.0f), pitch_(std::size_t(size.x) + 1),
          costs_(pitch_ * std::size_t(size.y))
    {
    }

    // On the page, as near as can be.
    void stand(std::vector<Place> places)
    {
        places_ = std::move(places);
        for (std::size_t i = 0; i < all_.size(); ++i) places_[i].at = clamp(places_[i].at, ivec2(0), size_ - shape(i).size);
    }

    const std::vector<Place>& places() const { return places_; }

    // True as soon as no more than so many cells are taken twice. `reach`: cells that one moves at a time, as it stands; 0: anywhere, turned.
    bool part(int passes, int reach, int allowed, Patience& patience)
    {
        std::vector<std::size_t> order(all_.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        for (int pass = 0; pass < passes && patience.moves > 0; ++pass) {
            stopIfInterrupted();
            for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[patience.random() % k]);
            for (std::size_t i : order)
                if (overlaps(i)) move(i, reach), --patience.moves;
            if (weigh() <= allowed) return true;
        }
        return false;
    }

private:
    const Silhouette& shape(std::size_t i) const { return all_[i][places_[i].stance]; }
    float& weight(std::size_t i, std::size_t j) { return weights_[i * all_.size() + j]; }

    int between(std::size_t i, std::size_t j) const { return overlap(shape(i), shape(j), places_[j].at - places_[i].at); }

    bool overlaps(std::size_t i) const
    {
        for (std::size_t j = 0; j < all_.size(); ++j)
            if (j != i && between(i, j) > 0) return true;
        return false;
    }

    // Makes those heavier that overlap, the others lighter. Returns the cells taken twice.
    int weigh()
    {
        struct Pair {
            std::size_t i, j;
            int cells;
        };
        std::vector<Pair> pairs;
        int sum = 0, most = 0;
        for (std::size_t i = 0; i < all_.size(); ++i)
            for (std::size_t j = i + 1; j < all_.size(); ++j) {
                if (const int cells = between(i, j); cells > 0)
                    pairs.push_back({i, j, cells}), sum += cells, most = max(most, cells);
                else
                    weight(i, j) = weight(j, i) = std::max(1.0f, weight(i, j) * float(kLoss));
            }
        for (const Pair& p : pairs) {
            const double gain = kGain + (kWorstGain - kGain) * p.cells / most;
            weight(p.i, p.j) = weight(p.j, p.i) = float(min(kHeaviest, double(weight(p.i, p.j)) * gain));
        }
        return sum;
    }

    // To where it costs least. Of equals the lowest, then leftmost.
    void move(std::size_t i, int reach)
    {
        const Place stands = places_[i];
        const auto [low, high] = reach > 0 ? std::pair(max(stands.at - reach, ivec2(0)), min(stands.at + shape(i).size + reach, size_))
                                           : std::pair(ivec2(0), size_);
        chart(i, low, high);
        int least = cheapest(shape(i), stands.at.y, stands.at.x, stands.at.x, std::numeric_limits<int>::max()).second + 1;
        for (std::size_t stance = 0; stance < all_[i].size() && least > 0; ++stance) {
            if (reach > 0 && stance != stands.stance) continue;
            const ivec2 last = high - all_[i][stance].size;
            if (last.x < low.x) continue;
            for (int y = low.y; y <= last.y && least > 0; ++y) {
                const auto [x, cost] = cheapest(all_[i][stance], y, low.x, last.x, least);
                if (cost < least) least = cost, places_[i] = {{x, y}, stance};
            }
        }
    }

    // costs_: what row y, from `low` to x, costs footprint i where others stand.
    void chart(std::size_t i, ivec2 low, ivec2 high)
    {
        for (int y = low.y; y < high.y; ++y) std::fill_n(&costs_[pitch_ * std::size_t(y) + std::size_t(low.x)], high.x - low.x + 1, 0);
        for (std::size_t j = 0; j < all_.size(); ++j) {
            const Silhouette& other = shape(j);
            const ivec2 at = places_[j].at, from = max(low, at), to = min(high, at + other.size);
            if (j == i || from.x >= to.x || from.y >= to.y) continue;
            const int cost = max(1, int(kCost * double(weight(i, j)) / std::sqrt(min(shape(i).area, other.area) + 1.0)));
            for (int y = from.y; y < to.y; ++y)
                for (const Run& run : other.row(y - at.y)) {
                    int* row = &costs_[pitch_ * std::size_t(y)];
                    for (int x = max(at.x + run.begin, low.x); x < min(at.x + run.end, high.x); ++x) row[x] += cost;
                }
        }
        for (int y = low.y; y < high.y; ++y) {
            int sum = 0, *row = &costs_[pitch_ * std::size_t(y)];
            for (int x = low.x; x <= high.x; ++x) sum += std::exchange(row[x], sum);
        }
    }

    // Of the places [first, last] along a row, if it costs less than `bound`: few rows of the silhouette tell most places off.
    std::pair<int, int> cheapest(const Silhouette& s, int y, int first, int last, int bound)
    {
        const std::size_t count = std::size_t(last - first) + 1;
        sums_.assign(count, 0);
        int least = 0;
        for (int start : kRows) {
            for (int r = start; r < s.size.y; r += int(kRows.size()))
                for (const Run& run : s.row(r)) {
                    const int* row = &costs_[pitch_ * std::size_t(y + r) + std::size_t(first)];
                    const int *end = row + run.end, *begin = row + run.begin;
                    int* sums = sums_.data();
                    for (std::size_t k = 0; k < count; ++k) sums[k] += end[k] - begin[k];
                }
            least = sums_[0];
            for (const int sum : sums_) least = std::min(least, sum);
            if (least >= bound) break;
        }
        return {first + int(std::find(sums_.begin(), sums_.end(), least) - sums_.begin()), least};
    }

    std::vector<Silhouettes> all_;
    ivec2 size_;
    std::vector<Place> places_;
    std::vector<float> weights_; // per pair
    std::size_t pitch_;
    std::vector<int> costs_, sums_;
};

std::vector<Silhouettes> silhouettesOf(const std::vector<std::vector<Stance>>& stances, int cell)
{
    std::vector<Silhouettes> all;
    for (const std::vector<Stance>& of : stances) {
        Silhouettes& silhouettes = all.emplace_back();
        for (const Stance& stance : of) silhouettes.push_back(silhouette(stance, cell));
    }
    return all;
}

std::vector<Place> scaled(std::vector<Place> places, int up, int down)
{
    for (Place& place : places) place.at = (place.at * up + down / 2) / down;
    return places;
}

std::vector<Spot> spotsOf(const std::vector<Place>& places, const std::vector<std::vector<Stance>>& stances)
{
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < places.size(); ++i) spots.push_back({places[i].at, stances[i][places[i].stance].turns});
    return spots;
}
}

std::optional<std::vector<Spot>> press(const std::vector<const Footprint*>& footprints, std::vector<Spot> from, ivec2 page,
                                       Patience& patience)
{
    if (footprints.size() > kMost) return {};
    std::vector<std::vector<Stance>> stances;
    std::vector<Place> places;
    for (std::size_t i = 0; i < footprints.size(); ++i) {
        stances.push_back(stancesOf(*footprints[i]));
        const auto stance = std::find_if(stances[i].begin(), stances[i].end(), [&](const Stance& s) { return s.turns == from[i].turns; });
        places.push_back({from[i].origin, std::size_t(stance - stances[i].begin()) % stances[i].size()});
        const ivec2 size = stances[i][places[i].stance].size;
        if (size.x > page.x || size.y > page.y) return {};
    }
    Sheet fine(silhouettesOf(stances, 1), page), coarse(silhouettesOf(stances, kCoarse), (page + kCoarse - 1) / kCoarse);
    coarse.stand(scaled(places, 1, kCoarse));
    for (int tried = 0; tried < kTries; ++tried) {
        const int allowed = int(kNearly * (page.x / kCoarse) * (page.y / kCoarse));
        if (!coarse.part(kCoarsePasses, 0, allowed, patience)) return {};
        fine.stand(scaled(coarse.places(), kCoarse, 1));
        if (fine.part(kFinePasses, kReach, 0, patience)) return spotsOf(fine.places(), stances);
        coarse.stand(scaled(fine.places(), 1, kCoarse));
    }
    return {};
}
}
