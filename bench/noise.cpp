// What paths buy: the error of a lightmap's texels by the paths of each, with the filter and without, and the time it takes.
#include "bench/noise.hpp"
#include "bench/bench.hpp"
#include "bench/child.hpp"
#include "engine/core/error.hpp"
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

BakedPages bakePages(const Scene& scene, const BakeOptions& options)
{
    Progress silent(ProgressStyle::none);
    json told;
    BakedPages baked{bakeScene(scene, options, silent, told).lightmaps};
    const json& product = told["products"]["lightmaps"];
    baked.seconds = product["seconds"], baked.cpuSeconds = product["cpu_seconds"];
    baked.texels = product["valid_texels"], baked.samples = product["samples"];
    return baked;
}

// Of the texels that both baked, over all channels; and of the first's mean, its square.
static double meanSquare(const BakedPages& a, const BakedPages& b)
{
    double squares = 0.0, light = 0.0, count = 0.0;
    for (std::size_t p = 0; p < a.pages.size(); ++p)
        for (std::size_t i = 0; i < a.pages[p].texels.size(); ++i) {
            if (a.pages[p].valid[i] != 1 || b.pages[p].valid[i] != 1) continue;
            const dvec3 off = dvec3(a.pages[p].texels[i]) - dvec3(b.pages[p].texels[i]), bright(b.pages[p].texels[i]);
            squares += dot(off, off), light += bright.x + bright.y + bright.z, count += 3.0;
        }
    return light > 0.0 ? squares * count / (light * light) : 0.0;
}

Reference reference(const Scene& scene, BakeOptions options)
{
    options.denoiser = Denoiser::none;
    options.seed = kReferenceSeed;
    Reference made{bakePages(scene, options), 0.0};
    options.seed++;
    const BakedPages other = bakePages(scene, options);
    // Independent and unbiased: the variance of each is half of what they differ by, that of their mean a quarter
    made.variance = 0.25 * meanSquare(made.bake, other);
    for (std::size_t p = 0; p < other.pages.size(); ++p)
        for (std::size_t i = 0; i < other.pages[p].texels.size(); ++i)
            made.bake.pages[p].texels[i] = 0.5f * (made.bake.pages[p].texels[i] + other.pages[p].texels[i]);
    return made;
}

double errorOf(const BakedPages& pages, const Reference& reference)
{
    return std::sqrt(std::max(meanSquare(pages, reference.bake) - reference.variance, 0.0));
}

json noiseRow(const Scene& scene, BakeOptions options, const Reference& truth)
{
    json row = {{"samples", options.samples.value_or(0)}};
    for (const Denoiser denoiser : {Denoiser::none, Denoiser::builtin}) {
        options.denoiser = denoiser;
        const BakedPages pages = bakePages(scene, options);
        row[nameOf(denoiser)] = {{"seconds", pages.seconds}, {"cpu_seconds", pages.cpuSeconds}, {"error", errorOf(pages, truth)}};
    }
    return row;
}

json benchNoise(const BenchOptions& options)
{
    return inChild([&] {
        const Scene scene = loadLevel(options.level);
        BakeOptions bake = lightmapsAlone(options);
        bake.samples = options.quick ? 512 : 4096;
        const Reference truth = reference(scene, bake);
        json result = {{"texels", truth.bake.texels}, {"reference", {{"samples", *bake.samples}, {"error", std::sqrt(truth.variance)}}}};
        for (int samples = 4; samples <= (options.quick ? 128 : 512); samples *= 2) {
            bake.samples = samples;
            result["rows"].push_back(noiseRow(scene, bake, truth));
        }
        return result;
    });
}

BakeOptions lightmapsAlone(const BenchOptions& options)
{
    BakeOptions bake;
    bake.quality = Quality::draft;
    bake.threads = options.threads;
    bake.directAll = true; // the noise of all light
    bake.probes = bake.reflections = bake.lods = bake.voxels = false;
    return bake;
}
}
