// The stages of a bake, each with its progress; bake.cpp has their order. Those of a product return what bake.json says of it.
#pragma once
#include "baker/atlas.hpp"
#include "baker/baker.hpp"
#include "baker/probes.hpp"
#include <nlohmann/json_fwd.hpp>

namespace afterglow
{
// What a quality stands for.
struct Preset {
    const char* name;
    float texelsPerMetre;
    float leastTexels; // a small level gets at least about as many in all, whatever its size in metres
    int samples;       // paths per texel
    float spacing;     // m between probes
    float leastProbes; // along the longest axis of a small level
    int probeSamples;
    int reflectionSize; // texels
    int reflectionSamples;
};

// One bake on its way: what is asked for, and what is made.
struct Bake {
    const BakeOptions& options;
    const Preset& preset;
    Progress& progress;
    Baked baked;
    std::size_t told = 0; // warnings

    Advance advance()
    {
        return [this](std::uint64_t units) { progress.advance(units); };
    }
};

void tellWarnings(Bake& bake); // as soon as they are known, not after an hour

Atlas layOut(Bake& bake, float texelsPerMetre); // places in the lightmap pages
nlohmann::json lightmapStage(Bake& bake, BakeContext& context, const Atlas& atlas, int samples);
nlohmann::json probeStage(Bake& bake, BakeContext& context, ProbesResult& probed);
nlohmann::json reflectionStage(Bake& bake, BakeContext& context, ProbesResult& probed); // probes itself when nobody did
nlohmann::json lodStage(Bake& bake);
nlohmann::json voxelStage(Bake& bake);
void writingStage(Bake& bake, const std::filesystem::path& directory, const nlohmann::json& manifest);
}
