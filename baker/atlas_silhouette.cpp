#include "baker/atlas_silhouette.hpp"
#include <algorithm>

namespace afterglow
{
Silhouette silhouette(const Stance& stance, int cell)
{
    Silhouette result;
    result.size = (stance.size + cell - 1) / cell;
    result.turns = stance.turns;
    std::vector<int> texels(std::size_t(result.size.x) * result.size.y);
    for (const Block& block : stance.blocks)
        for (int y = block.lower.y; y < block.lower.y + block.size.y; ++y)
            for (int begin = block.lower.x, end = begin + block.size.x, x = begin / cell; x * cell < end; ++x)
                texels[std::size_t(y / cell) * result.size.x + x] += min(end, (x + 1) * cell) - max(begin, x * cell);

    const auto taken = [&](int x, int y) { return 2 * texels[std::size_t(y) * result.size.x + x] >= cell * cell; };
    for (int y = 0; y < result.size.y; ++y) {
        for (int x = 0; x < result.size.x; ++x) {
            if (!taken(x, y)) continue;
            if (x == 0 || !taken(x - 1, y)) result.runs.push_back({x, x});
            ++result.runs.back().end, ++result.area;
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
