// What a quality stands for, and what follows from it of what nobody has said.
#include "baker/baker.hpp"
#include "baker/probes.hpp"
#include "baker/stages.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
// What a quality stands for.
struct Preset {
    const char* name;
    float texelsPerMetre;
    float leastTexels;  // a small level gets at least about as many in all, whatever its size in metres
    int samples;        // paths per texel
    float spacing;      // m between probes
    float leastProbes;  // along the longest axis of a small level
    int probeSamples;   // of each at least; what they add to the noise of lookups says how many more
    float probeError;   // between probes
    int reflectionSize; // texels
    int reflectionSamples;
};

// Paths as many as leave no more noise behind the filter than texels of that size are off by themselves, in draft and medium (`./run bench
// --noise`): Cornell's box after the filter 4.9 % with 16 paths, 2.7 with 64, and its floor is 5 % off for the texels of draft, 2 for those
// of medium. High is to be looked at without a filter.
static constexpr Preset kPresets[] = {
    {"draft", 8.0f, 16e3f, 16, 2.0f, 4.0f, 32, 0.2f, 64, 32},
    // Of probes, 4 %: against Cycles the 95th percentile of three seeds is 11.6 to 13.3 % off in the gallery, 13.9 to 14.3 in two open rooms.
    {"medium", 16.0f, 64e3f, 64, 1.0f, 4.0f, 256, 0.04f, 64, 64},
    {"high", 32.0f, 128e3f, 384, 1.0f, 4.0f, 512, 0.03f, 128, 128},
};

static constexpr double kMostCells = 2e4;               // of an open level before its light is looked at
static constexpr std::uint64_t kProbeBytes = 32u << 20; // unless said otherwise

const char* nameOf(Quality quality) { return kPresets[int(quality)].name; }

const char* nameOf(Denoiser denoiser) { return denoiser == Denoiser::none ? "none" : denoiser == Denoiser::builtin ? "builtin" : "oidn"; }

float probeNoiseFor(float between) { return 0.4f * between; }

int samplesOf(Quality quality) { return kPresets[int(quality)].samples; }

BakeOptions resolved(BakeOptions o, const Scene& scene)
{
    const Preset& preset = kPresets[int(o.quality)];
    const auto otherwise = [](auto& value, auto said) { value = value.value_or(said); };
    if (!o.texelsPerMetre)
        o.texelsPerMetre =
            std::max(preset.texelsPerMetre, float(std::sqrt(double(preset.leastTexels) / std::max(staticArea(scene), 1e-12))));
    otherwise(o.samples, preset.samples);
    otherwise(o.probeNoise, probeNoiseFor(o.probeError && *o.probeError > 0.0f ? *o.probeError : preset.probeError));
    // Who says how far probes stand apart means it; otherwise the light says
    otherwise(o.probeError, o.probeSpacing || !scene.probeVolumes.empty() ? 0.0f : preset.probeError);
    otherwise(o.probeBytes, kProbeBytes);
    const vec3 extent = scene.upper - scene.lower;
    otherwise(o.probeSpacing,
              float(spacingWithin(dvec3(extent), double(min(preset.spacing, largestOf(extent) / preset.leastProbes)), kMostCells)));
    otherwise(o.probeSamples, preset.probeSamples);
    otherwise(o.reflectionSize, preset.reflectionSize);
    otherwise(o.reflectionSamples, preset.reflectionSamples);
    otherwise(o.bounces, TruthOptions{}.bounces);
    o.lightCache = o.lightCache.value_or(o.denoiser != Denoiser::none) && !o.keeps() && *o.bounces >= kCachedBounces;
    return o;
}
}
