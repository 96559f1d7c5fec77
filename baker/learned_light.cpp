#include "baker/learned_light.hpp"
#include "baker/probes.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
// Of paths that probes are expected to take. Not what a forecast reckons: a better forecast is not to change what is baked.
static constexpr double kLearned = 0.4;   // of each probe's least
static constexpr double kProbes = 3.0;    // in a cell of the spacing
static constexpr double kCut = 12.0;      // times as many where the light says how many
static constexpr float kCoarsest = 0.45f; // of the density of lightmaps: at 0.3 the draft of two closed rooms errs by 36 % for 29

int learnedOf(Quality quality) { return samplesOf(quality) / 4; }

float learnedDensity(const Scene& scene, const BakeOptions& made, double area)
{
    const double probes = kProbes * cellsIn(dvec3(scene.upper - scene.lower), double(*made.probeSpacing)) *
                          (*made.probeError > 0.0f ? kCut : 1.0),
                 texels = kLearned * probes * *made.probeSamples / learnedOf(made.quality);
    const auto density = float(std::sqrt(texels / std::max(area, 1e-12)));
    return density < kCoarsest * *made.texelsPerMetre ? 0.0f : std::min(*made.texelsPerMetre, density);
}
}
