#include "baker/atlas_pack.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace afterglow
{
namespace
{
using Row = std::vector<std::uint64_t>; // one bit per texel, texel 0 is bit 0 of word 0

constexpr int kWidthsTried = 6;
constexpr double kWidthStep = 1.1;

void shiftDown(Row& row, int by) // texel x + by becomes texel x
{
    std::size_t words = std::size_t(by) / 64, n = row.size();
    int bits = by % 64;
    for (std::size_t i = 0; i < n; ++i) {
        std::uint64_t low = i + words < n ? row[i + words] : 0, high = i + words + 1 < n ? row[i + words + 1] : 0;
        row[i] = bits == 0 ? low : low >> bits | high << (64 - bits);
    }
}

// Bit x becomes the OR of bits [x, x + length).
void smear(Row& row, int length, Row& scratch)
{
    for (int done = 1; done < length;) {
        int step = std::min(done, length - done);
        scratch = row;
        shiftDown(scratch, step);
        for (std::size_t i = 0; i < row.size(); ++i) row[i] |= scratch[i];
        done += step;
    }
}

class Page
{
public:
    explicit Page(int width) : width_(width), words_(std::size_t(width + 63) / 64) {}

    // The lowest, then leftmost free spot at or above `from`, that leaves the page no higher than `mostHeight`.
    std::optional<ivec2> find(const Footprint& f, int from, int mostHeight)
    {
        for (int y = from; y + f.size.y <= mostHeight; ++y) {
            int x = firstFree(f, y);
            if (x >= 0) return ivec2(x, y);
        }
        return {};
    }

    void take(const Footprint& f, ivec2 at)
    {
        if (int(rows_.size()) < at.y + f.size.y) rows_.resize(std::size_t(at.y + f.size.y), Row(words_));
        for (const Block& block : f.blocks)
            for (int y = at.y + block.lower.y; y < at.y + block.lower.y + block.size.y; ++y)
                for (int x = at.x + block.lower.x; x < at.x + block.lower.x + block.size.x; ++x)
                    rows_[std::size_t(y)][std::size_t(x / 64)] |= std::uint64_t(1) << x % 64;
    }

    int height() const { return int(rows_.size()); }

private:
    // blocked: bit x says that the footprint cannot stand at x.
    int firstFree(const Footprint& f, int y)
    {
        int last = width_ - f.size.x;
        blocked_.assign(words_, 0);
        for (const Block& block : f.blocks) {
            int first = y + block.lower.y, end = min(first + block.size.y, height());
            if (first >= end) continue;
            together_.assign(words_, 0);
            for (int row = first; row < end; ++row)
                for (std::size_t i = 0; i < words_; ++i) together_[i] |= rows_[std::size_t(row)][i];
            shiftDown(together_, block.lower.x);
            smear(together_, block.size.x, scratch_);
            for (std::size_t i = 0; i < words_; ++i) blocked_[i] |= together_[i];
            if (firstZero(last) < 0) return -1;
        }
        return firstZero(last);
    }

    int firstZero(int last) const
    {
        for (int word = 0; word * 64 <= last; ++word) {
            int x = word * 64 + std::countr_one(blocked_[word]);
            if (x < word * 64 + 64) return x <= last ? x : -1;
        }
        return -1;
    }

    int width_;
    std::size_t words_;
    std::vector<Row> rows_;
    Row blocked_, together_, scratch_;
};

int roundUp(int x, int grain) { return (x + grain - 1) / grain * grain; }

// Where footprints of about the same size stood last: the rows below are full of their like.
struct Floors {
    std::array<std::array<int, 16>, 16> rows{};
    int& of(const Footprint& f) { return rows[std::bit_width(unsigned(f.size.x)) & 15][std::bit_width(unsigned(f.size.y)) & 15]; }
};

std::optional<Packing> packAt(const std::vector<const Footprint*>& footprints, const std::vector<std::size_t>& order, int width,
                              int mostHeight, int grain)
{
    Page page(width);
    Floors floors;
    Packing result;
    result.origins.resize(footprints.size());
    int right = 0;
    for (std::size_t i : order) {
        stopIfInterrupted();
        const Footprint& f = *footprints[i];
        int& floor = floors.of(f);
        std::optional<ivec2> at = page.find(f, max(0, floor - f.size.y), mostHeight);
        if (!at) return {};
        page.take(f, *at);
        floor = at->y;
        result.origins[i] = *at;
        right = max(right, at->x + f.size.x);
    }
    result.size = {roundUp(right, grain), roundUp(page.height(), grain)};
    return result;
}
}

double footprintArea(const std::vector<const Footprint*>& footprints)
{
    double area = 0.0;
    for (const Footprint* f : footprints)
        for (const Block& block : f->blocks) area += double(block.size.x) * block.size.y;
    return area;
}

std::optional<Packing> pack(const std::vector<const Footprint*>& footprints, int limit, int grain)
{
    std::vector<std::size_t> order(footprints.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        ivec2 p = footprints[a]->size, q = footprints[b]->size;
        return p.y != q.y ? p.y > q.y : p.x != q.x ? p.x > q.x : a < b;
    });
    int widest = 0, highest = 0;
    for (const Footprint* f : footprints) widest = max(widest, f->size.x), highest = max(highest, f->size.y);
    const double area = footprintArea(footprints);
    if (max(widest, highest) > limit || area > double(limit) * limit) return {};

    double width = max(max(double(widest), area / limit), 0.9 * std::sqrt(area));
    std::optional<Packing> best;
    auto texels = [](const Packing& p) { return double(p.size.x) * p.size.y; };
    for (int attempt = 0; attempt < kWidthsTried && (attempt == 0 || width <= limit); ++attempt, width *= kWidthStep) {
        int w = min(roundUp(int(std::ceil(width)), grain), limit);
        int mostHeight = best ? min(limit, int(texels(*best) / w)) : limit;
        std::optional<Packing> packing = packAt(footprints, order, w, mostHeight, grain);
        if (packing && (!best || texels(*packing) < texels(*best))) best = std::move(packing);
    }
    if (best) return best;
    return packAt(footprints, order, limit, limit, grain);
}
}
