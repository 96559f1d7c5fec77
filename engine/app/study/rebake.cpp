// Another edition of one baked product.
#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/study/studio.hpp"
#include "engine/core/error.hpp"
#include <nlohmann/json.hpp>

namespace afterglow
{
std::string editionOf(const BakeOptions& o, const std::string& product)
{
    return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {}", product, *o.texelsPerMetre, *o.samples, *o.bounces, *o.probeSpacing,
                       *o.probeError, *o.probeNoise, *o.probeSamples, o.probeOrder, o.probeWalls, *o.reflectionSize, *o.reflectionSamples,
                       o.directAll, nameOf(o.denoiser));
}

Baked rebaked(const Studio& studio, const Setup& setup, const std::string& product, double& ms)
{
    BakeOptions options = setup.bake;
    options.lightmaps = product == "lightmaps", options.probes = product == "probes", options.reflections = product == "reflections";
    options.lods = options.voxels = false;
    check(options.lightmaps || options.probes || options.reflections, "a product that can be baked alone");
    Progress unseen(ProgressStyle::none);
    nlohmann::json manifest;
    Scene level = studio.level;
    for (ProbeVolumeRequest& box : level.probeVolumes) box.spacing *= *options.probeSpacing / *studio.standard.bake.probeSpacing;
    Baked whole = bakeScene(std::move(level), options, unseen, manifest);
    if (!manifest["products"].contains(product)) throw Error("this level calls for no " + product + ", so there is nothing to bake again");
    ms = 1e3 * manifest["products"][product]["cpu_seconds"].get<double>();
    if (!options.lightmaps) { // the atlas of the other bake stays with its lightmaps
        Baked base = studio.baked;
        if (options.probes) base.probes = std::move(whole.probes);
        if (options.reflections) base.reflections = std::move(whole.reflections);
        return base;
    }
    whole.probes = studio.baked.probes;
    whole.reflections = studio.baked.reflections;
    whole.voxels = studio.baked.voxels;
    return whole;
}
}
