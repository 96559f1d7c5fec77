// Paths of probes where they lessen most what lookups err by.
#pragma once
#include "baker/probe_search.hpp"

namespace afterglow
{
// What noise adds to the relative mean square error of lookups, mean over space, by each probe's variance: adds[i] * variance.
std::vector<double> addedByProbes(const Search& search);

// Relative RMSE of lookups by noise, over space, as the halves of the probes' paths differ.
double lookupNoise(const Search& search);

// As many paths for each, from its least to `most`, as leave `target` with the least sum. `adds`: of one path, to the mean square. By the root
// of what each adds. Based on: Neyman 1934
std::vector<double> allotted(const std::vector<double>& adds, double target, const std::vector<double>& least, double most);

// Traces until lookups err by no more than the search's effort says, and no probe by more than kOfOne times as much, for space is large outdoors
// and small where one looks; or each probe has kMoreProbePaths times its least paths.
constexpr double kOfOne = 4.0;
void lessenNoise(Search& search);

// What that would take with the probes of now, as Search::work.
double noiseWork(const Search& search);
}
