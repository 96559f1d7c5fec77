// The fixture of tests that trace rays on the GPU, and on the CPU beside it.
#pragma once
#include "baker/world.hpp"
#include "engine/graph/executor.hpp"
#include "engine/upload/scene_set.hpp"
#include "shaders/ray_scene.h"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <cstring>

namespace afterglow
{
// As tests/shaders/trace.comp writes it.
struct TracedAnswer {
    Hit hit;
    vec3 passed;
    vec3 position;
    vec3 geometricNormal;
    vec3 normal;
    vec3 diffuse;
    vec3 emission;
    uint vertex;
    uint instance;
};

class TracesRays : public Validated
{
protected:
    void SetUp() override
    {
        if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    }

    std::vector<TracedAnswer> trace(const Scene& scene, const std::vector<Ray>& rays)
    {
        GpuScene uploaded = uploadScene(gpu, scene, instances(scene), {});
        uploaded.rays = buildRays(gpu, scene, instances(scene));
        const bool filtered = uploaded.rays.filtered, tinted = uploaded.rays.tinted;
        const GpuLevel level(gpu, std::move(uploaded), {});
        Graph graph;
        const Buffer answers = graph.buffer("answers", rays.size() * sizeof(TracedAnswer));
        graph.compute("trace", "tests/shaders/trace.comp")
            .read(graph.upload("rays", std::span<const Ray>(rays)))
            .write(answers)
            .specialize(kTraceFiltered, filtered)
            .specialize(kTraceTinted, tinted)
            .dispatch(uvec2(uint(rays.size()), 1));
        graph.output(answers);
        Executor executor(gpu);
        executor.run(graph, level.set);
        const std::vector<std::uint8_t> bytes = executor.download(answers);
        std::vector<TracedAnswer> result(rays.size());
        std::memcpy(result.data(), bytes.data(), bytes.size());
        return result;
    }
};
}
