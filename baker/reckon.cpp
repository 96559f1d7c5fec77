#include "baker/reckon.hpp"
#include "baker/probes.hpp"
#include "baker/stages.hpp"
#include "engine/core/jobs.hpp"

namespace afterglow
{
namespace
{
// s of one thread. Measured at draft on content/ (gallery, still_life, two_rooms, cornell); those of light only count beside one another.
constexpr double kTriangleAtlas = 2.9e-6, kTriangleLods = 27e-6, kTexelDenoise = 5e-6, kTexelPrefilter = 10e-6, kTexelWriting = 2e-6;
constexpr double kPathLightmap = 1e-6; // of a texel, some of which lie outside of every chart: a third, as tiles go
constexpr double kPathProbe = 1.7e-6, kPathReflection = 1.4e-6;
constexpr double kProbesOfCell = 3.0; // for walls part cells
constexpr double kVoxels = 0.1;
constexpr double kReflections = 2.0; // cubemaps of a level that places none
}

std::vector<StageForecast> reckoned(const Scene& scene, const BakeOptions& made, double area, std::size_t layers)
{
    const double threads = threadCount(made.threads), triangles = double(trianglesOf(scene));
    const double texels = made.lightmaps ? area * double(*made.texelsPerMetre) * double(*made.texelsPerMetre) : 0.0;
    const double size = *made.reflectionSize, faceTexels = 6.0 * size * size;
    std::vector<StageForecast> stages;
    const auto add = [&](const char* name, double units, double cost, Tempo tempo = Tempo::machine) {
        stages.push_back({.name = name, .units = units, .cost = cost, .tempo = tempo});
    };
    if (made.lightmaps) {
        add("atlas", triangles, kTriangleAtlas);
        add("lightmaps", 1.5 * double(layers) * texels * *made.samples, kPathLightmap / threads, Tempo::light);
        if (made.denoiser != Denoiser::none) add("denoise", 1.0, kTexelDenoise * texels / threads);
    }
    if (made.probes) {
        const dvec3 along = max(dvec3(scene.upper - scene.lower) / double(*made.probeSpacing), dvec3(1.0));
        const double count = kProbesOfCell * along.x * along.y * along.z * (*made.probeError > 0.0f ? kProbesCut : 1.0);
        add("probes", count, kPathProbe * *made.probeSamples / threads, Tempo::light);
    }
    if (made.reflections) {
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
