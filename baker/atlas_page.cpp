#include "baker/atlas_page.hpp"
#include <algorithm>
#include <bit>

namespace afterglow
{
namespace
{
constexpr int kStep = 16; // a footprint looks for room in steps of its height / this, and then sinks as deep as it can

constexpr int kUnknown = -1; // longest run: the row has changed since it was asked

using Bitmap = std::vector<std::uint8_t>; // row after row

// row[x] |= row[x + by], ascending: what it reads is still as it was.
void orShifted(std::vector<std::uint64_t>& row, int by)
{
    const std::size_t words = std::size_t(by) / 64, n = row.size();
    const int bits = by % 64;
    if (bits == 0)
        for (std::size_t i = 0; i + words < n; ++i) row[i] |= row[i + words];
    else {
        for (std::size_t i = 0; i + words + 1 < n; ++i) row[i] |= row[i + words] >> bits | row[i + words + 1] << (64 - bits);
        if (words < n) row[n - 1 - words] |= row[n - 1] >> bits;
    }
}

// Bit x becomes the OR of bits [x, x + length).
void smear(std::vector<std::uint64_t>& row, int length)
{
    for (int done = 1; done < length;) {
        const int step = std::min(done, length - done);
        orShifted(row, step);
        done += step;
    }
}

// The largest rectangle of set texels: under the histogram of each row's columns, by a stack of rising ones. A row that the next one
// repeats is passed over, for what ends in it can grow.
Block largestInside(const Bitmap& taken, ivec2 size)
{
    Block best{ivec2(0), ivec2(0)};
    std::vector<int> heights(std::size_t(size.x) + 1), rising;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) heights[std::size_t(x)] = taken[std::size_t(y) * size.x + x] ? heights[std::size_t(x)] + 1 : 0;
        const auto row = taken.begin() + std::ptrdiff_t(y) * size.x;
        if (y + 1 < size.y && std::equal(row, row + size.x, row + size.x)) continue;
        rising.clear();
        for (int x = 0; x <= size.x; ++x) {
            while (!rising.empty() && heights[std::size_t(rising.back())] >= heights[std::size_t(x)]) {
                const int height = heights[std::size_t(rising.back())];
                rising.pop_back();
                const int left = rising.empty() ? 0 : rising.back() + 1;
                if ((x - left) * height > best.size.x * best.size.y) best = {{left, y - height + 1}, {x - left, height}};
            }
            rising.push_back(x);
        }
    }
    return best;
}

Stance stanceOf(const Bitmap& taken, ivec2 size, int turns)
{
    Stance stance{size, turns, blocksOf(taken, size), {}};
    stance.asked = stance.blocks;
    std::stable_sort(stance.asked.begin(), stance.asked.end(),
                     [](const Block& a, const Block& b) { return a.size.x * a.size.y > b.size.x * b.size.y; });
    if (stance.asked.size() > 1) stance.asked.insert(stance.asked.begin(), largestInside(taken, size));
    return stance;
}

Bitmap quarterTurned(const Bitmap& taken, ivec2 size)
{
    Bitmap turned(taken.size());
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) turned[std::size_t(x) * size.y + std::size_t(size.y - 1 - y)] = taken[std::size_t(y) * size.x + x];
    return turned;
}

Stance halfTurned(Stance stance)
{
    for (std::vector<Block>* blocks : {&stance.blocks, &stance.asked})
        for (Block& block : *blocks) block.lower = stance.size - block.lower - block.size;
    stance.turns += 2;
    return stance;
}
}

std::vector<Stance> stancesOf(const Footprint& footprint)
{
    const ivec2 size = footprint.size, lying(size.y, size.x);
    if (footprint.blocks.size() == 1) {
        std::vector<Stance> both{{size, 0, footprint.blocks, footprint.blocks}};
        const std::vector<Block> turned{{ivec2(0), lying}};
        if (footprint.turns && size.x != size.y) both.push_back({lying, 1, turned, turned});
        return both;
    }
    Bitmap taken(std::size_t(size.x) * size.y);
    for (const Block& block : footprint.blocks)
        for (int y = block.lower.y; y < block.lower.y + block.size.y; ++y)
            std::fill_n(taken.begin() + std::ptrdiff_t(y) * size.x + block.lower.x, block.size.x, std::uint8_t(1));

    std::vector<Stance> stances{stanceOf(taken, size, 0)};
    if (!footprint.turns) return stances;
    const Bitmap turned = quarterTurned(taken, size);
    if (size == lying && turned == taken) return stances;
    stances.push_back(stanceOf(turned, lying, 1));
    if (std::equal(taken.begin(), taken.end(), taken.rbegin())) return stances;
    stances.push_back(halfTurned(stances[0])), stances.push_back(halfTurned(stances[1]));
    return stances;
}

std::optional<ivec2> Page::find(const Stance& stance, int from, int mostHeight)
{
    const int step = 1 + stance.size.y / kStep, top = mostHeight - stance.size.y;
    const Block& widest = stance.asked.front();
    int untried = from; // rows from here to y were skipped
    for (int y = from; y <= top;) {
        if (const int above = aboveTightRows(widest, y); above > y) {
            y = untried = above;
            continue;
        }
        if (const int x = firstFree(stance, y); x >= 0) {
            for (; untried < y; ++untried)
                if (const int free = firstFree(stance, untried); free >= 0) return ivec2(free, untried);
            return ivec2(x, y);
        }
        untried = y + 1;
        y = y < top ? min(y + step, top) : top + 1;
    }
    return {};
}

// The lowest y from this one on at which no single row is too full for the block; more than one row may yet leave it no room.
int Page::aboveTightRows(const Block& block, int y)
{
    for (int row = min(y + block.lower.y + block.size.y, height_) - 1; row >= y + block.lower.y; --row)
        if (longestFree(row) < block.size.x) return row - block.lower.y + 1;
    return y;
}

void Page::take(const Stance& stance, ivec2 at)
{
    height_ = max(height_, at.y + stance.size.y);
    for (std::size_t k = 0; k == 0 || height_ >> (k - 1) > 1; ++k) {
        if (levels_.size() == k) {
            levels_.emplace_back();
            if (k > 0) // a level that begins late has seen nothing of what lies below
                for (std::size_t i = 0; i < levels_[k - 1].size(); ++i) {
                    const std::size_t to = i / words_ / 2 * words_ + i % words_;
                    if (levels_[k].size() <= to) levels_[k].resize(to + 1);
                    levels_[k][to] |= levels_[k - 1][i];
                }
        }
        Bits& bits = levels_[k];
        bits.resize(std::max(bits.size(), (std::size_t((height_ - 1) >> k) + 1) * words_));
        for (const Block& block : stance.blocks) {
            const int from = at.x + block.lower.x, to = from + block.size.x, top = at.y + block.lower.y + block.size.y;
            for (int row = (at.y + block.lower.y) >> k; row <= (top - 1) >> k; ++row)
                for (int word = from / 64; word <= (to - 1) / 64; ++word) {
                    const int low = max(from - 64 * word, 0), high = min(to - 64 * word, 64);
                    bits[std::size_t(row) * words_ + std::size_t(word)] |= ~std::uint64_t(0) >> (64 - (high - low)) << low;
                }
        }
    }
    longest_.resize(std::size_t(height_), width_);
    std::fill_n(longest_.begin() + at.y, stance.size.y, kUnknown);
}

int Page::longestFree(int row)
{
    int& longest = longest_[std::size_t(row)];
    if (longest != kUnknown) return longest;
    int run = 0;
    longest = 0;
    for (std::size_t i = 0; i < words_; ++i) {
        std::uint64_t word = levels_[0][std::size_t(row) * words_ + i];
        if (word == 0) run += min(64, width_ - 64 * int(i)); // the most common of all
        for (int left = word == 0 ? 0 : min(64, width_ - 64 * int(i)); left > 0;) {
            const int free = min(std::countr_zero(word), left);
            run += free, left -= free;
            if (left == 0) break;
            longest = max(longest, run), run = 0;
            const int taken = min(std::countr_one(word >> free), left);
            left -= taken;
            word = free + taken < 64 ? word >> (free + taken) : 0;
        }
    }
    return longest = max(longest, run);
}

// together_: what is taken in any of the rows [first, end).
void Page::gather(int first, int end)
{
    std::fill(together_.begin(), together_.end(), std::uint64_t(0));
    const auto add = [&](const Bits& bits, int row) {
        for (std::size_t i = 0; i < words_; ++i) together_[i] |= bits[std::size_t(row) * words_ + i];
    };
    for (std::size_t k = 0; first < end; first >>= 1, end >>= 1, ++k) {
        if (first % 2 == 1) add(levels_[k], first++);
        if (end % 2 == 1) add(levels_[k], --end);
    }
}

// Bit x of blocked_ says that the footprint cannot stand at x.
int Page::firstFree(const Stance& stance, int y)
{
    const int last = width_ - stance.size.x;
    std::fill(blocked_.begin(), blocked_.end(), std::uint64_t(0));
    for (const Block& block : stance.asked) {
        const int first = y + block.lower.y, end = min(first + block.size.y, height_);
        if (first >= end) continue;
        gather(first, end);
        smear(together_, block.size.x);
        const std::size_t words = std::size_t(block.lower.x) / 64;
        const int bits = block.lower.x % 64;
        for (std::size_t i = 0; i + words < words_; ++i) {
            std::uint64_t word = together_[i + words] >> bits;
            if (bits != 0 && i + words + 1 < words_) word |= together_[i + words + 1] << (64 - bits);
            blocked_[i] |= word;
        }
        if (firstZero(last) < 0) return -1;
    }
    return firstZero(last);
}

int Page::firstZero(int last) const
{
    for (int word = 0; word * 64 <= last; ++word) {
        const int x = word * 64 + std::countr_one(blocked_[std::size_t(word)]);
        if (x < word * 64 + 64) return x <= last ? x : -1;
    }
    return -1;
}
}
