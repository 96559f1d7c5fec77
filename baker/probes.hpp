// Irradiance probes: where they stand, and the light that meets them from everywhere.
// Space is parted by the level's walls (partition.hpp), then cut where the light between the probes of a cell is not what they say.
#pragma once
#include "baker/context.hpp"
#include "engine/baked/probe_tree.hpp"
#include <optional>

namespace afterglow
{
constexpr int kMoreProbePaths = 32; // times the least paths of a probe, at most, where it is noisy

struct ProbeEffort {
    double spacing = 1.0;        // m: no cell is larger, but outside of the boxes of a level that places some
    int samples = 256;           // paths of a probe, at least; up to kMoreProbePaths times as many where it is noisy
    double noise = 0.03;         // relative RMSE of lookups by noise, over all of space
    double error = 0.0;          // relative, mean over all of space: cells are cut until they err by no more; 0: as the spacing says
    std::uint64_t bytes = ~0ull; // or until the tree is as large
    std::optional<std::uint64_t> memory; // bytes of the process, at most; if cells need more, Error is thrown before they are lit
    int order = 2;                       // of the harmonics that are kept: 1 is four numbers a channel in the place of nine
    bool walls = true;                   // false: a plain grid, which reaches through walls, to compare with
};

struct ProbesResult {
    ProbeTree tree;
    double samples = 0.0;            // paths of a probe, mean over the probes
    float estimatedError = 0.0f;     // relative RMSE of lookups by noise, over all of space, from two halves of the paths
    float interpolationError = 0.0f; // relative RMSE between probes, mean over space; 0: was not asked for
};

// Of the factor by which errors are too large, as their number grows while errors go with the square of their size.
constexpr double kCuts = 1.5;

// Cells of that size that fill a box; fewer than one along no axis.
double cellsIn(dvec3 extent, double spacing);

// `wanted`, or as much more as takes to fill a box with no more cells than that, m.
double spacingWithin(dvec3 extent, double wanted, double cells);

ProbesResult bakeProbes(BakeContext& context, const ProbeEffort& effort);

std::uint64_t bytesOf(const ProbeTree& tree); // in the files, before they are packed
}
