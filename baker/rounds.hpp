// How many paths each tile of a lightmap gets, so that all of it reaches a stated error with the fewest.
#pragma once
#include <cstdint>
#include <vector>

namespace afterglow
{
constexpr int kPilotSamples = 16;       // of the first round, which tells where the noise is
constexpr int kMostSamples = 1 << 16;   // of a texel
constexpr double kRoundGrowth = 3.0;    // a round makes of all paths this many at most: what it foresees is the better for being near
constexpr double kAimedShare = 0.97;    // of the error: one round too few costs more than a few paths
constexpr double kLeastGrowth = 1.03;   // and a round at least this many
constexpr double kLeastDeviation = 0.1; // of the mean, with which a tile is reckoned: a few paths may all have missed a small light

// A tile after some rounds.
struct TileNoise {
    std::uint64_t texels = 0; // valid ones
    double variance = 0.0;    // of a path's luminance, mean over the texels
    int samples = 0;          // paths of each texel so far
};

// Samples of each tile after the next round, those it has included. `error` is what was measured over all tiles, `target` what is wanted
// of it. The error's square goes as the sum of texels * variance / samples; it is least for a number of paths when samples go as the square
// root of the variance. Randomised points do better than that law, so that a round may end below its aim.
std::vector<int> nextSamples(const std::vector<TileNoise>& tiles, double error, double target);
}
