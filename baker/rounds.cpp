// This work is based on: Neyman 1934 (optimal allocation of samples among strata).
#include "baker/rounds.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
// Samples of a tile at `pace` paths for each unit of deviation: even, so that both halves grow alike, and no fewer than it has.
static int samplesAt(const TileNoise& tile, double deviation, double pace)
{
    const double wanted = std::min(std::ceil(0.5 * pace * deviation) * 2.0, double(kMostSamples));
    return std::max(tile.samples, int(wanted));
}

std::vector<int> nextSamples(const std::vector<TileNoise>& tiles, double error, double target)
{
    double texels = 0.0, deviations = 0.0, noise = 0.0, paths = 0.0;
    for (const TileNoise& tile : tiles) {
        const double count = double(tile.texels);
        texels += count;
        deviations += count * std::sqrt(tile.variance);
        paths += count * tile.samples;
        if (tile.samples > 0) noise += count * tile.variance / tile.samples;
    }
    const double least = texels > 0.0 ? kLeastDeviation * deviations / texels : 0.0;
    const auto deviationOf = [&](const TileNoise& tile) { return std::max(std::sqrt(tile.variance), least); };
    const double wanted = noise * std::pow(kAimedShare * target / error, 2.0);

    // The slowest pace that serves, by bisection; between the least growth and the most
    const auto serves = [&](double pace) {
        double left = 0.0, all = 0.0;
        for (const TileNoise& tile : tiles) {
            const int samples = samplesAt(tile, deviationOf(tile), pace);
            if (samples > 0) left += double(tile.texels) * tile.variance / samples;
            all += double(tile.texels) * samples;
        }
        return all >= kRoundGrowth * paths || (left <= wanted && all >= kLeastGrowth * paths);
    };
    double slow = 0.0, fast = least > 0.0 ? kMostSamples / least : 0.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (slow + fast);
        (serves(middle) ? fast : slow) = middle;
    }
    std::vector<int> next;
    for (const TileNoise& tile : tiles) next.push_back(samplesAt(tile, deviationOf(tile), fast));
    return next;
}
}
