// The stages of a bake, each with its progress; bake.cpp has their order. Those of a product return what bake.json says of it.
#pragma once
#include "baker/atlas.hpp"
#include "baker/baker.hpp"
#include "baker/lightmap.hpp"
#include "baker/oidn.hpp"
#include "baker/probes.hpp"
#include "baker/seam_texels.hpp"
#include <nlohmann/json_fwd.hpp>

namespace afterglow
{
// One bake on its way: what is asked for, and what is made.
struct Bake {
    const BakeOptions& options; // resolved
    Progress& progress;
    Baked baked;
    std::size_t told = 0; // warnings of the level

    Advance advance()
    {
        return [this](std::uint64_t units) { progress.advance(units); };
    }
};

std::uint64_t trianglesOf(const Scene& scene);
double staticArea(const Scene& scene); // m2 of everything that may carry a lightmap
void tellWarnings(Bake& bake);         // as soon as they are known, not after an hour

Atlas layOut(Bake& bake, float texelsPerMetre); // places in lightmap pages
// No path is clamped, however bright; those that are not finite have no say in the mean, and are counted. `seams`: of the atlas; what is
// not known yet is filled in. `oidn`: null, the filter is ours.
nlohmann::json lightmapStage(Bake& bake, BakeContext& context, const Atlas& atlas, Seams& seams, const Oidn* oidn);
nlohmann::json probeStage(Bake& bake, BakeContext& context);
constexpr int kMostReflections = 8; // where nobody placed any
nlohmann::json reflectionStage(Bake& bake, BakeContext& context);
nlohmann::json lodStage(Bake& bake, Journal* journal);
nlohmann::json voxelStage(Bake& bake);
}
