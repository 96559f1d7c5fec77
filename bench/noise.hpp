// Lightmaps baked in memory, and how far they are from what they would be with all paths there are.
#pragma once
#include "bench/bench.hpp"

namespace afterglow
{
struct BakedPages {
    std::vector<Lightmap> pages;
    double seconds = 0.0, cpuSeconds = 0.0; // of the lightmaps alone
    double texels = 0.0, samples = 0.0;     // baked ones; paths of each, on average
};
BakedPages bakePages(const Scene& scene, const BakeOptions& options);
BakeOptions lightmapsAlone(const BenchOptions& options);

// The mean of two bakes without a filter, of seeds that no other bake takes.
struct Reference {
    BakedPages bake;
    double variance = 0.0; // of it, over the square of the mean: measured, and taken out of what is held against it
};
constexpr std::uint32_t kReferenceSeed = 1000;
Reference reference(const Scene& scene, BakeOptions options);

// Relative RMSE of a texel. The bake may be filtered.
double errorOf(const BakedPages& pages, const Reference& reference);

// {"samples","none":{"seconds","cpu_seconds","error"},"builtin":{the same}}.
nlohmann::json noiseRow(const Scene& scene, BakeOptions options, const Reference& truth);
}
