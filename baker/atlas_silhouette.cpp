#include "baker/atlas_silhouette.hpp"
#include <algorithm>
#include <cstdint>

namespace afterglow
{
Silhouette silhouette(const Stance& stance, int cell)
{
    Silhouette result;
    result.size = (stance.size + cell - 1) / cell;
    result.turns = stance.turns;
    std::vector<int> texels(std::size_t(result.size.x) * result.size.y);
    for (const Block& block : stance.blocks)
        for (int y = block.lower.y; y < block.lower.y + block.size.y; ++y) {
            const int begin = block.lower.x, end = begin + block.size.x, first = begin / cell, last = (end - 1) / cell;
            int* row = &texels[std::size_t(y / cell) * std::size_t(result.size.x)];
            for (int x = first; x <= last; ++x) row[x] += cell;
            row[first] -= begin - first * cell, row[last] -= (last + 1) * cell - end; // what the block leaves of its first and last cell
        }

    std::vector<std::uint8_t> taken(std::size_t(result.size.x)); // of a row: bytes, for they are sought fastest
    for (int y = 0; y < result.size.y; ++y) {
        const int* row = &texels[std::size_t(y) * std::size_t(result.size.x)];
        for (std::size_t x = 0; x < taken.size(); ++x) taken[x] = 2 * row[x] >= cell * cell;
        for (auto begin = std::find(taken.begin(), taken.end(), 1); begin != taken.end();) {
            const auto end = std::find(begin, taken.end(), 0);
            result.runs.push_back({int(begin - taken.begin()), int(end - taken.begin())});
            result.area += double(end - begin);
            begin = std::find(end, taken.end(), 1);
        }
        result.firstOf.push_back(result.runs.size());
    }
    return result;
}

int overlap(const Silhouette& a, const Silhouette& b, ivec2 apart)
{
    if (apart.x >= a.size.x || -apart.x >= b.size.x) return 0;
    int cells = 0;
    for (int y = max(0, apart.y); y < min(a.size.y, b.size.y + apart.y); ++y)
        for (const Run& p : a.row(y))
            for (const Run& q : b.row(y - apart.y)) cells += max(0, min(p.end, q.end + apart.x) - max(p.begin, q.begin + apart.x));
    return cells;
}
}
