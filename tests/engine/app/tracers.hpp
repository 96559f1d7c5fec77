// Both tracers on one level: the CPU's (Embree) and the GPU's (ray query), asked for the same picture.
#pragma once
#include "baker/baker.hpp"
#include "engine/frame/frame.hpp"
#include "engine/graph/executor.hpp"
#include "tests/engine/gpu/validated.hpp"

namespace afterglow
{
class Tracers : public Validated
{
protected:
    void SetUp() override
    {
        if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    }

    Image byRayQuery(const Scene& scene, const TruthOptions& asked)
    {
        Settings settings;
        settings.size = uvec2(asked.size);
        settings.mode = Mode::truth;
        settings.portal.depth = uint(asked.portalDepth);
        TruthParameters& truth = settings.truth;
        truth.samples = uint(asked.samples);
        truth.perFrame = min(truth.samples, 4096u); // a device may end what takes it longer than seconds
        truth.seed = asked.seed;
        truth.bounces = uint(asked.bounces);
        if (asked.scatterings) truth.scatterings = uint(*asked.scatterings);
        Stage stage = makeStage(gpu, scene, nullptr, settings);
        Executor executor(gpu);
        Texture radiance;
        while (stage.traced.count < truth.samples) {
            Graph graph;
            radiance = drawTruth(graph, stage, asked.camera, settings).radiance;
            graph.output(radiance);
            executor.run(graph, stage.level->set);
        }
        return executor.download(radiance);
    }

    static Image byEmbree(const Scene& scene, const TruthOptions& asked)
    {
        Progress silent(ProgressStyle::none);
        return truth(scene, asked, silent);
    }
};

inline TruthOptions pictureOf(const Scene& scene, const std::string& camera, ivec2 size, int samples)
{
    TruthOptions options;
    options.camera = findCamera(scene, camera);
    options.size = size;
    options.samples = samples;
    return options;
}
}
