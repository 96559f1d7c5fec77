#include "baker/reckon.hpp"
#include "baker/learned_light.hpp"
#include "baker/light_cache.hpp"
#include "baker/probes.hpp"
#include "baker/stages.hpp"
#include "engine/core/jobs.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
// s of one thread. Measured at draft on content/ (gallery, still_life, two_rooms, cornell); those of light only count beside one another.
constexpr double kTriangleAtlas = 2.9e-6, kTriangleLods = 27e-6, kTexelDenoise = 5e-6, kTexelWriting = 2e-6;
constexpr double kVoxels = 0.1;
constexpr double kProbesOfCell = 3.0; // for walls part cells
// Times as many where the light says how many, those of its tests and of more paths among them: 6 to 92 in six levels.
double probesCut(double error) { return 27.0 * std::pow(0.04 / error, 0.37); }

// Of light: at draft and medium, whose paths are four and eight times as many, so that both parts are told. Geometric means of six levels,
// some off by half; the gallery's glass and textures cost four times as much, and its probes twenty times.
struct LightCost {
    double each, path; // of a texel or a probe, and of each of its paths
    double ofPath(double paths) const { return path + each / std::max(paths, 1.0); }
};

// A cache makes little quicker in lightmaps: they share their paths already, and it costs each texel that is asked for its base. It makes
// less noise of as many paths, and halves those of probes.
constexpr LightCost kLightmap = {3e-6, 0.6e-6}, kLightmapCached = {7e-6, 0.5e-6};
constexpr LightCost kProbe = {85e-6, 1.9e-6}, kProbeCached = {47e-6, 0.4e-6}; // of the least paths: most have more
constexpr double kOutside = 1.5;                                              // texels of tiles to those of charts

constexpr double kReflections = 3.0; // cubemaps of a level that places none: 2 to 4
constexpr double kPlaces = 1.5;      // of such a level, to find where they stand: 0.5 to 2.6
constexpr double kPathReflection = 0.7e-6, kTexelPrefilter = 29e-6;

// Of a path, mean over those of a texel, to one that looks up what the first have told.
double weightOf(int samples) { return 1.0 + (kPilotCost - 1.0) * pilotOf(samples) / samples; }

// With those of tests.
double probesReckoned(const Scene& scene, const BakeOptions& made)
{
    return kProbesOfCell * cellsIn(dvec3(scene.upper - scene.lower), double(*made.probeSpacing)) *
           (*made.probeError > 0.0f ? probesCut(double(*made.probeError)) : 1.0);
}
}

std::vector<StageForecast> reckoned(const Scene& scene, const BakeOptions& made, double area, std::size_t layers)
{
    const double threads = threadCount(made.threads), triangles = double(trianglesOf(scene));
    const auto texelsBy = [&](float density) { return area * double(density) * double(density); };
    const double texels = made.lightmaps ? texelsBy(*made.texelsPerMetre) : 0.0;
    const double size = *made.reflectionSize, faceTexels = 6.0 * size * size;
    const bool cached = *made.lightCache;
    std::vector<StageForecast> stages;
    const auto add = [&](const char* name, double units, double cost, Tempo tempo = Tempo::machine) {
        stages.push_back({.name = name, .units = units, .cost = cost, .tempo = tempo});
    };
    if (made.lightmaps) {
        add("atlas", triangles, kTriangleAtlas);
        const double cost = (cached ? kLightmapCached : kLightmap).ofPath(*made.samples),
                     weight = cached && layers == 1 ? weightOf(*made.samples) : 1.0;
        add("lightmaps", kOutside * double(layers) * texels * *made.samples * weight, cost / weight / threads, Tempo::light);
        if (made.denoiser != Denoiser::none) add("denoise", 1.0, kTexelDenoise * texels / threads);
    } else if (made.probes && cached) {
        add("atlas", triangles, kTriangleAtlas);
        const int paths = learnedOf(made.quality);
        const double weight = weightOf(paths), cost = kLightmapCached.ofPath(paths);
        add("light", kOutside * texelsBy(learnedDensity(scene, made, area)) * paths * weight, cost / weight / threads, Tempo::light);
    }
    if (made.probes) {
        const double cost = (cached ? kProbeCached : kProbe).ofPath(*made.probeSamples);
        add("probes", probesReckoned(scene, made), cost * *made.probeSamples / threads, Tempo::light);
    }
    if (made.reflections) {
        if (scene.reflectionProbes.empty()) add("places", 1.0, kPlaces / threads);
        const double cubes = scene.reflectionProbes.empty() ? kReflections : double(scene.reflectionProbes.size());
        add("reflections", cubes * 6.0 * size, kPathReflection * size * *made.reflectionSamples / threads, Tempo::light);
        add("prefilter", cubes * 6.0 * size, kTexelPrefilter * faceTexels / 3.0 / (6.0 * size) / threads); // mips: a third of the first
    }
    if (made.lods) add("lods", triangles, kTriangleLods / threads);
    if (made.voxels) add("voxels", 1.0, kVoxels);
    add("writing", 1.0, kTexelWriting * texels);
    return stages;
}
}
