#include "baker/probe_noise.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace afterglow
{
static constexpr int kGrowth = 4;        // times as many paths, at most, before their noise is asked again
static constexpr double kEvenest = 0.25; // of a variance by batches, at least, that evenly spread paths leave of it
static constexpr int kHalvings = 40;

// Integral over a cell of what two of its corners weigh there, over its volume.
static double shared(int a, int b)
{
    double product = 1.0;
    for (int axis = 0; axis < 3; axis++) product *= (a ^ b) >> axis & 1 ? 1.0 / 6.0 : 1.0 / 3.0;
    return product;
}

static double lightOf(const Search& search, const Chamber& chamber)
{
    double light = 0.0;
    for (uint probe : chamber.box.probe) light += 0.125 * search.lights[probe].light();
    return light;
}

// Volume of the cells, and the mean light in them.
static std::pair<double, double> spaceOf(const Search& search)
{
    double volume = 0.0, light = 0.0;
    for (std::size_t i = 0; i < search.chambers.size(); i++) {
        if (!search.alive(i) || !search.chambers[i].placed) continue;
        volume += search.chambers[i].volume, light += search.chambers[i].volume * lightOf(search, search.chambers[i]);
    }
    return {volume, volume > 0.0 ? light / volume : 0.0};
}

std::vector<double> addedByProbes(const Search& search)
{
    std::vector<double> adds(search.lights.size(), 0.0);
    const auto [volume, mean] = spaceOf(search);
    if (!(mean > 0.0)) return adds;
    for (std::size_t i = 0; i < search.chambers.size(); i++) {
        const Chamber& chamber = search.chambers[i];
        if (!search.alive(i) || !chamber.placed) continue;
        const double off = lightOf(search, chamber) + kDark * mean;
        for (int a = 0; a < 8; a++)
            for (int b = 0; b < 8; b++)
                if (chamber.box.probe[std::size_t(a)] == chamber.box.probe[std::size_t(b)])
                    adds[chamber.box.probe[std::size_t(a)]] += chamber.volume / volume * shared(a, b) / (off * off);
    }
    return adds;
}

double lookupNoise(const Search& search)
{
    const std::vector<double> adds = addedByProbes(search);
    double square = 0.0;
    for (std::size_t i = 0; i < adds.size(); i++) square += adds[i] * search.lights[i].variance();
    return std::sqrt(square);
}

std::vector<double> allotted(const std::vector<double>& adds, double target, const std::vector<double>& least, double most)
{
    std::vector<double> paths = least;
    const auto leftBy = [&](double times) {
        double square = 0.0;
        for (std::size_t i = 0; i < adds.size(); i++) {
            paths[i] = std::clamp(times * std::sqrt(adds[i]), least[i], most);
            square += adds[i] / paths[i];
        }
        return std::sqrt(square);
    };
    if (leftBy(0.0) <= target) return paths;
    double largest = 0.0, smallest = std::numeric_limits<double>::infinity(); // roots
    for (double add : adds)
        if (add > 0.0) largest = std::max(largest, std::sqrt(add)), smallest = std::min(smallest, std::sqrt(add));
    double more = 1.0 / largest;
    while (leftBy(more) > target && more * smallest < most) more *= 2.0;
    double fewer = 0.5 * more;
    for (int i = 0; i < kHalvings; i++) {
        const double times = 0.5 * (fewer + more);
        (leftBy(times) <= target ? more : fewer) = times;
    }
    leftBy(more);
    return paths;
}

// What is left of variances by batches since paths are spread evenly; as halves say, over all probes.
static double evennessOf(const Search& search, const std::vector<double>& adds)
{
    double halves = 0.0, batches = 0.0;
    for (std::size_t i = 0; i < adds.size(); i++)
        halves += adds[i] * search.lights[i].variance(), batches += adds[i] * search.sums[i].variance();
    return batches > 0.0 ? std::clamp(halves / batches, kEvenest, 1.0) : 1.0;
}

// Paths of each probe that leave the asked noise. `evenness`: of rounds before; it does not rise, for that would be the noise of the light
// that paths look up.
static std::vector<double> wantedPaths(const Search& search, double& evenness)
{
    const double most = double(search.effort.samples) * kMoreProbePaths, noise = search.effort.noise;
    std::vector<double> adds = addedByProbes(search), least(adds.size());
    evenness = std::min(evenness, evennessOf(search, adds));
    const double dark = kDark * spaceOf(search).second;
    for (std::size_t i = 0; i < adds.size(); i++) {
        const double ofPath = evenness * search.sums[i].variance() * search.sums[i].paths(), light = search.lights[i].light() + dark;
        const double own = adds[i] > 0.0 && light > 0.0 ? ofPath / std::pow(kOfOne * noise * light, 2.0) : 0.0;
        least[i] = std::clamp(own, double(search.effort.samples), most);
        adds[i] *= ofPath;
    }
    return allotted(adds, noise, least, most);
}

static double workOf(const Search& search, const std::vector<double>& wanted)
{
    double paths = 0.0;
    for (std::size_t i = 0; i < wanted.size(); i++) paths += std::max(wanted[i] - search.sums[i].paths(), 0.0);
    return paths / search.effort.samples;
}

double noiseWork(const Search& search)
{
    double evenness = 1.0;
    return workOf(search, wantedPaths(search, evenness));
}

void lessenNoise(Search& search)
{
    double evenness = 1.0;
    for (bool more = true; more;) {
        stopIfInterrupted();
        const std::vector<double> wanted = wantedPaths(search, evenness);
        search.foretold = double(search.work) + workOf(search, wanted);
        std::vector<int> paths(wanted.size());
        more = false;
        for (std::size_t i = 0; i < wanted.size(); i++) {
            paths[i] = int(std::min(std::ceil(wanted[i]), double(kGrowth) * search.sums[i].paths()));
            more = more || paths[i] > search.sums[i].paths();
        }
        if (more) tracePaths(search, paths);
    }
}
}
