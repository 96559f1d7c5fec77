#include "baker/atlas_footprint.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace afterglow
{
namespace
{
constexpr double kInset = 1e-6;   // of the sample spacing: a shared side belongs to neither triangle
constexpr int kFinestGrid = 1024; // samples along a chart when looking for folds

struct Range {
    double low = 1e300, high = -1e300;
    void add(double x) { low = min(low, x), high = max(high, x); }
    bool empty() const { return high < low; }
};

// A triangle's sides, each from its lower end up.
struct Sides {
    struct Side {
        dvec2 lower, upper;
        double slope; // of x over y; of a level side never asked
    };
    std::array<Side, 3> sides;

    explicit Sides(const dvec2* corner)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            dvec2 a = corner[i], b = corner[(i + 1) % 3];
            if (a.y > b.y) std::swap(a, b);
            sides[i] = {a, b, (b.x - a.x) / (b.y - a.y)};
        }
    }

    // The extent in x of the part of the triangle with y in [low, high].
    Range across(double low, double high) const
    {
        Range range;
        for (const Side& side : sides) {
            if (side.upper.y < low || side.lower.y > high) continue;
            range.add(side.lower.y >= low ? side.lower.x : side.lower.x + (low - side.lower.y) * side.slope);
            range.add(side.upper.y <= high ? side.upper.x : side.lower.x + (high - side.lower.y) * side.slope);
        }
        return range;
    }
};

std::pair<dvec2, dvec2> bounds(std::span<const dvec2> corners)
{
    dvec2 lower(1e300), upper(-1e300);
    for (const dvec2& c : corners) lower = min(lower, c), upper = max(upper, c);
    return {lower, upper};
}

// Calls inside(row, first, last) for the runs of grid points (i, j) + 1/2 strictly inside each triangle; stops when it returns true.
template <typename Inside>
bool anyRun(std::span<const dvec2> corners, Inside inside)
{
    for (std::size_t t = 0; t < corners.size(); t += 3) {
        const dvec2* c = &corners[t];
        int first = int(std::ceil(min(min(c[0].y, c[1].y), c[2].y) - 0.5)), last = int(std::floor(max(max(c[0].y, c[1].y), c[2].y) - 0.5));
        const Sides sides(c);
        for (int j = first; j <= last; ++j) {
            Range x = sides.across(j + 0.5, j + 0.5);
            if (x.empty()) continue;
            int begin = int(std::ceil(x.low + kInset - 0.5)), end = int(std::floor(x.high - kInset - 0.5)) + 1;
            if (begin < end && inside(j, begin, end)) return true;
        }
    }
    return false;
}
}

// The runs of each row, those that repeat the run below joined to it. Most rows are what is below them.
std::vector<Block> blocksOf(const std::vector<std::uint8_t>& taken, ivec2 size)
{
    std::vector<Block> blocks;
    std::vector<std::size_t> below, here; // blocks that reach the row
    for (int y = 0; y < size.y; ++y, below = std::move(here), here.clear()) {
        auto row = taken.begin() + std::ptrdiff_t(y) * size.x, end = row + size.x;
        if (y > 0 && std::equal(row, end, row - size.x)) {
            for (std::size_t block : below) ++blocks[block].size.y;
            std::swap(here, below);
            continue;
        }
        std::size_t next = 0;
        for (auto run = std::find(row, end, 1); run != end;) {
            auto stop = std::find(run, end, 0);
            const int x = int(run - row), width = int(stop - run);
            while (next < below.size() && blocks[below[next]].lower.x < x) ++next;
            if (next < below.size() && blocks[below[next]].lower.x == x && blocks[below[next]].size.x == width) {
                ++blocks[below[next]].size.y;
                here.push_back(below[next]);
            } else {
                here.push_back(blocks.size());
                blocks.push_back({{x, y}, {width, 1}});
            }
            run = std::find(stop, end, 1);
        }
    }
    return blocks;
}

Footprint footprint(std::span<const dvec2> corners, double margin, ivec2& origin)
{
    auto [lower, upper] = bounds(corners);
    origin = ivec2(floor(lower - margin - 0.5)) + 1;
    const ivec2 size = ivec2(ceil(upper + margin - 0.5)) - origin;
    std::vector<std::uint8_t> taken(std::size_t(size.x) * size.y);
    for (std::size_t t = 0; t < corners.size(); t += 3) {
        const dvec2* c = &corners[t];
        double bottom = min(min(c[0].y, c[1].y), c[2].y), top = max(max(c[0].y, c[1].y), c[2].y);
        int first = int(std::floor(bottom - margin - 0.5)) + 1, end = int(std::ceil(top + margin - 0.5));
        const Sides sides(c);
        for (int y = first; y < end; ++y) {
            Range x = sides.across(y + 0.5 - margin, y + 0.5 + margin);
            if (x.empty()) continue;
            auto row = taken.begin() + std::ptrdiff_t(y - origin.y) * size.x - origin.x;
            std::fill(row + int(std::floor(x.low - margin - 0.5)) + 1, row + int(std::ceil(x.high + margin - 0.5)), std::uint8_t(1));
        }
    }
    return {size, blocksOf(taken, size)};
}

bool foldsOver(std::span<const dvec2> corners, double spacing)
{
    auto [lower, upper] = bounds(corners);
    dvec2 extent = upper - lower;
    spacing = max(spacing, max(extent.x, extent.y) / kFinestGrid);
    if (!(spacing > 0.0)) return false;
    ivec2 size = ivec2(extent / spacing) + 2;
    std::vector<dvec2> onGrid(corners.begin(), corners.end());
    for (dvec2& c : onGrid) c = (c - lower) / spacing;

    std::vector<std::uint8_t> taken(std::size_t(size.x) * size.y);
    return anyRun(onGrid, [&](int j, int begin, int end) {
        auto row = taken.begin() + std::ptrdiff_t(j) * size.x;
        bool twice = std::find(row + begin, row + end, 1) != row + end;
        std::fill(row + begin, row + end, std::uint8_t(1));
        return twice;
    });
}

bool coversTexel(std::span<const dvec2> corners)
{
    return anyRun(corners, [](int, int, int) { return true; });
}
}
