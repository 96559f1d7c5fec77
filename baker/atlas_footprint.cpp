#include "baker/atlas_footprint.hpp"
#include "baker/weld.hpp"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace afterglow
{
namespace
{
constexpr double kInset = 1e-6;   // of the sample spacing: what lies on the rim is outside
constexpr int kFinestGrid = 1024; // samples along a chart when looking for folds

struct Range {
    double low = 1e300, high = -1e300;
    void add(double x) { low = min(low, x), high = max(high, x); }
};

struct Segment {
    dvec2 lower, upper; // by y
    int enters;         // 1: what is counter-clockwise lies to the right of it; -1: to the left
    double slope;       // of x over y; of a level one never asked

    Segment(const dvec2& a, const dvec2& b)
        : lower(a.y > b.y ? b : a), upper(a.y > b.y ? a : b), enters(a.y > b.y ? 1 : -1), slope((b.x - a.x) / (b.y - a.y))
    {
    }

    double x(double y) const { return lower.x + (y - lower.y) * slope; }

    // The extent in x of the part with y in [low, high], which it reaches.
    Range across(double low, double high) const
    {
        Range range;
        range.add(lower.y >= low ? lower.x : x(low));
        range.add(upper.y <= high ? upper.x : x(high));
        return range;
    }
};

std::pair<dvec2, dvec2> bounds(std::span<const dvec2> corners)
{
    dvec2 lower(1e300), upper(-1e300);
    for (const dvec2& c : corners) lower = min(lower, c), upper = max(upper, c);
    return {lower, upper};
}

std::vector<Segment> segmentsOf(std::span<const dvec2> corners, std::span<const uint> rim, const dvec2& lower, double spacing)
{
    std::vector<Segment> segments;
    segments.reserve(rim.size());
    for (const uint side : rim) segments.emplace_back((corners[side] - lower) / spacing, (corners[nextCorner(side)] - lower) / spacing);
    return segments;
}

// Where the rim crosses the middle of each row: a point lies inside of as many triangles as the rim turns about it.
class Crossings
{
public:
    Crossings(const std::vector<Segment>& rim, int rows) : begins_(std::size_t(rows) + 2)
    {
        const auto each = [&](auto call) {
            for (const Segment& side : rim)
                for (int row = int(std::ceil(side.lower.y - 0.5)); row + 0.5 < side.upper.y; ++row)
                    call(std::size_t(row), Crossing{side.x(row + 0.5), side.enters});
        };
        each([&](std::size_t row, Crossing) { ++begins_[row + 2]; });
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        all_.resize(begins_.back());
        each([&](std::size_t row, Crossing crossing) { all_[begins_[row + 1]++] = crossing; });
        for (std::size_t row = 0; row < std::size_t(rows); ++row)
            std::sort(all_.begin() + std::ptrdiff_t(begins_[row]), all_.begin() + std::ptrdiff_t(begins_[row + 1]),
                      [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    }

    // Calls run(row, first, last, triangles) for the columns whose middles lie inside of at least one; stops when it returns true.
    template <typename Run>
    bool any(Run run) const
    {
        for (std::size_t row = 0; row + 2 < begins_.size(); ++row) {
            int inside = 0; // triangles, counter-clockwise ones less the others
            for (std::size_t i = begins_[row]; i + 1 < begins_[row + 1]; ++i) {
                inside += all_[i].enters;
                const int first = int(std::ceil(all_[i].x + kInset - 0.5)), last = int(std::floor(all_[i + 1].x - kInset - 0.5));
                if (inside != 0 && first <= last && run(int(row), first, last, inside)) return true;
            }
        }
        return false;
    }

private:
    struct Crossing {
        double x;
        int enters;
    };
    std::vector<std::size_t> begins_; // per row, the end of the last one, and once more
    std::vector<Crossing> all_;
};
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

Footprint footprint(std::span<const dvec2> corners, std::span<const uint> rim, double margin, ivec2& origin)
{
    const auto [lower, upper] = bounds(corners);
    origin = ivec2(floor(lower - margin - 0.5)) + 1;
    const ivec2 size = ivec2(ceil(upper + margin - 0.5)) - origin;
    std::vector<std::uint8_t> taken(std::size_t(size.x) * size.y);
    const auto take = [&](int row, int begin, int end) {
        auto texels = taken.begin() + std::ptrdiff_t(row) * size.x;
        std::fill(texels + begin, texels + end, std::uint8_t(1));
    };
    for (const Segment& side : segmentsOf(corners, rim, dvec2(0.0), 1.0)) {
        const int first = int(std::floor(side.lower.y - margin - 0.5)) + 1, end = int(std::ceil(side.upper.y + margin - 0.5));
        for (int row = first; row < end; ++row) {
            const Range x = side.across(row + 0.5 - margin, row + 0.5 + margin);
            take(row - origin.y, int(std::floor(x.low - margin - 0.5)) + 1 - origin.x, int(std::ceil(x.high + margin - 0.5)) - origin.x);
        }
    }
    Crossings(segmentsOf(corners, rim, dvec2(origin), 1.0), size.y).any([&](int row, int first, int last, int) {
        take(row, first, last + 1);
        return false;
    });
    return {size, blocksOf(taken, size)};
}

bool foldsOver(std::span<const dvec2> corners, std::span<const uint> rim, double spacing)
{
    const auto [lower, upper] = bounds(corners);
    const dvec2 extent = upper - lower;
    spacing = max(spacing, max(extent.x, extent.y) / kFinestGrid);
    if (!(spacing > 0.0)) return false;
    return Crossings(segmentsOf(corners, rim, lower, spacing), int(extent.y / spacing) + 1).any([](int, int, int, int triangles) {
        return std::abs(triangles) > 1;
    });
}

bool coversTexel(std::span<const dvec2> corners, std::span<const uint> rim)
{
    const auto [lower, upper] = bounds(corners);
    const dvec2 origin = floor(lower);
    return Crossings(segmentsOf(corners, rim, origin, 1.0), int(upper.y - origin.y) + 1).any([](int, int, int, int) { return true; });
}
}
