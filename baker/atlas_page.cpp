#include "baker/atlas_page.hpp"
#include <algorithm>
#include <bit>

namespace afterglow
{
namespace
{
constexpr int kStep = 16; // a footprint looks for room in steps of its height / this, and then sinks as deep as it can

using Bitmap = std::vector<std::uint8_t>; // row after row

// to[x] = from[x] | from[x + by]. `from` goes on behind the row, in zeros.
void orShifted(const std::uint64_t* __restrict from, std::uint64_t* __restrict to, std::size_t words, int by)
{
    const std::uint64_t* ahead = from + by / 64;
    const int bits = by % 64;
    for (std::size_t i = 0; i < words; ++i) to[i] = from[i] | ahead[i] >> bits | ahead[i + 1] << 1 << (63 - bits);
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

Stance stanceOf(ivec2 size, int turns, std::vector<Block> blocks, const Block& largest)
{
    Stance stance{size, turns, std::move(blocks), {}};
    stance.asked = stance.blocks;
    std::stable_sort(stance.asked.begin(), stance.asked.end(),
                     [](const Block& a, const Block& b) { return a.size.x * a.size.y > b.size.x * b.size.y; });
    if (stance.asked.size() > 1) stance.asked.insert(stance.asked.begin(), largest);
    return stance;
}

Bitmap quarterTurned(const Bitmap& taken, ivec2 size)
{
    Bitmap turned(taken.size());
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) turned[std::size_t(x) * size.y + std::size_t(size.y - 1 - y)] = taken[std::size_t(y) * size.x + x];
    return turned;
}

Block quarterTurned(const Block& block, ivec2 size)
{
    return {{size.y - block.lower.y - block.size.y, block.lower.x}, {block.size.y, block.size.x}};
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

    const Block largest = largestInside(taken, size);
    std::vector<Stance> stances{stanceOf(size, 0, footprint.blocks, largest)};
    if (!footprint.turns) return stances;
    const Bitmap turned = quarterTurned(taken, size);
    if (size == lying && turned == taken) return stances;
    stances.push_back(stanceOf(lying, 1, blocksOf(turned, lying), quarterTurned(largest, size)));
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
        if (!hasRoom(row, block.size.x)) return row - block.lower.y + 1;
    return y;
}

// A row that has changed since its longest run was asked can but have a shorter one.
bool Page::hasRoom(int row, int width)
{
    FreeRun& longest = longest_[std::size_t(row)];
    if (longest.texels >= width && !longest.known) longest = {longestFree(row), true};
    return longest.texels >= width;
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
    longest_.resize(std::size_t(height_), {width_, true});
    for (int row = at.y; row < at.y + stance.size.y; ++row) longest_[std::size_t(row)].known = false;
}

int Page::longestFree(int row) const
{
    int run = 0, longest = 0;
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
    return max(longest, run);
}

// Calls with rows of the levels that together take what the rows [first, end) take.
template <typename Call>
void Page::eachRow(int first, int end, Call call) const
{
    for (std::size_t k = 0; first < end; first >>= 1, end >>= 1, ++k) {
        if (first % 2 == 1) call(&levels_[k][std::size_t(first++) * words_]);
        if (end % 2 == 1) call(&levels_[k][std::size_t(--end) * words_]);
    }
}

// Bit x of blocked_ says that the block cannot stand at x, its lowest row at y.
void Page::blockFor(ivec2 size, int y)
{
    std::fill_n(blocked_.begin(), words_, std::uint64_t(0));
    eachRow(y, min(y + size.y, height_), [&](const std::uint64_t* row) {
        for (std::size_t i = 0; i < words_; ++i) blocked_[i] |= row[i];
    });
    for (int done = 1; done < size.x;) { // bit x is the OR of bits [x, x + done)
        const int step = min(done, size.x - done);
        orShifted(blocked_.data(), smeared_.data(), words_, step);
        blocked_.swap(smeared_);
        done += step;
    }
}

// Of the texels [from, from + size), the one furthest right that is taken; -1: none.
int Page::lastTaken(ivec2 from, ivec2 size) const
{
    int last = -1;
    const int left = from.x / 64, right = (from.x + size.x - 1) / 64;
    eachRow(from.y, min(from.y + size.y, height_), [&](const std::uint64_t* row) {
        for (int word = right; word >= max(left, last / 64); --word) {
            std::uint64_t taken = row[word];
            if (word == right) taken &= ~std::uint64_t(0) >> (63 - (from.x + size.x - 1) % 64);
            if (word == left) taken &= ~std::uint64_t(0) << from.x % 64;
            if (taken == 0) continue;
            last = max(last, 64 * word + 63 - std::countl_zero(taken));
            return;
        }
    });
    return last;
}

// The first x at which none of the footprint is taken, its lower row at y; -1: none. All places are asked at once for the block that is asked
// first; where that one is free, another that is in the way tells how far the next place is.
int Page::firstFree(const Stance& stance, int y)
{
    const Block& largest = stance.asked.front();
    blockFor(largest.size, y + largest.lower.y);
    const auto next = [&](int x) { return firstUnblocked(x + largest.lower.x) - largest.lower.x; };
    int x = next(0);
    for (std::size_t free = 1, i = 0; free < stance.asked.size() && x + stance.size.x <= width_;) {
        i = i + 1 < stance.asked.size() ? i + 1 : 1;
        const Block& block = stance.asked[i];
        const int taken = lastTaken(ivec2(x, y) + block.lower, block.size);
        if (taken < 0)
            ++free;
        else
            free = 1, x = next(taken + 1 - block.lower.x), --i;
    }
    return x + stance.size.x <= width_ ? x : -1;
}

int Page::firstUnblocked(int x) const
{
    if (x >= width_) return x;
    std::size_t word = std::size_t(x) / 64;
    std::uint64_t free = ~blocked_[word] & ~std::uint64_t(0) << x % 64;
    while (free == 0 && ++word < words_) free = ~blocked_[word];
    return int(word) * 64 + std::countr_zero(free);
}
}
