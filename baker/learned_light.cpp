#include "baker/learned_light.hpp"
#include "baker/reckon.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
static constexpr double kLearned = 0.1; // of the paths of probes

int learnedOf(Quality quality) { return samplesOf(quality) / 4; }

float learnedDensity(const Scene& scene, const BakeOptions& made, double area)
{
    const double paths = kLearned * probesReckoned(scene, made) * *made.probeSamples, texels = paths / learnedOf(made.quality);
    return std::min(*made.texelsPerMetre, float(std::sqrt(texels / std::max(area, 1e-12))));
}
}
