#include "baker/learned_light.hpp"
#include "baker/reckon.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
static constexpr double kLearned = 0.1;   // of the paths of probes
static constexpr float kCoarsest = 0.45f; // of the density of lightmaps: at 0.3 the draft of two closed rooms errs by 36 % for 29

int learnedOf(Quality quality) { return samplesOf(quality) / 4; }

float learnedDensity(const Scene& scene, const BakeOptions& made, double area)
{
    const double paths = kLearned * probesReckoned(scene, made) * *made.probeSamples, texels = paths / learnedOf(made.quality);
    const auto density = float(std::sqrt(texels / std::max(area, 1e-12)));
    return density < kCoarsest * *made.texelsPerMetre ? 0.0f : std::min(*made.texelsPerMetre, density);
}
}
