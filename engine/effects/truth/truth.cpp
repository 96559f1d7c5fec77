#include "engine/effects/truth/truth.hpp"
#include "engine/core/error.hpp"
#include "engine/effects/tracing.hpp"
#include <algorithm>
#include <cstring>

namespace afterglow
{
static TruthFrame frameOf(const GpuScene& scene, const GpuPaths& paths, const Picture& picture, const TruthParameters& parameters)
{
    TruthFrame frame{picture,          defaultPathSettings(), paths.skyTint, paths.skyRotation, scene.mediumCount(),
                     paths.lightCount, paths.emitterCount};
    frame.limits.maxBounces = parameters.bounces;
    frame.limits.maxCollisions = parameters.scatterings;
    return frame;
}

Texture truth(Graph& graph, const Traced& traced, const Picture& picture, TracedSamples& samples, const TruthParameters& parameters)
{
    const GpuScene& scene = traced.level.scene;
    const GpuPaths& paths = traced.paths;
    check(bool(scene.rays), "paths need something to meet, even in an empty level");
    const TruthFrame frame = frameOf(scene, paths, picture, parameters);
    const uvec3 size(picture.size, 1);
    if (samples.sum.shape.size != size || !samples.sum)
        for (GpuImage* image : {&samples.sum, &samples.lost})
            *image = traced.memory.image("traced samples", {VK_FORMAT_R32G32B32A32_SFLOAT, size}, VK_IMAGE_USAGE_STORAGE_BIT);
    if (std::memcmp(&samples.of, &frame, sizeof(frame)) != 0) samples.count = 0; // 4-byte members without a gap
    samples.of = frame;
    const uint added = std::min(parameters.perFrame, parameters.samples - std::min(samples.count, parameters.samples));

    const Texture mean = graph.texture("truth", VK_FORMAT_R32G32B32A32_SFLOAT, picture.size);
    Pass pass = graph.compute("truth", "engine/effects/truth/truth.comp");
    const auto given = [&](const GpuBuffer& buffer) { return buffer ? graph.import(buffer) : Buffer{}; };
    pass.read(graph.upload("truth.frame", frame)).read(given(paths.lights)).read(given(paths.emitters)).read(given(paths.densities));
    pass.read(given(paths.skyRows)).read(paths.sky ? graph.import(paths.sky) : Texture{});
    pass.read(given(paths.portals)).read(given(paths.portalOf));
    pass.modify(graph.import(samples.sum)).modify(graph.import(samples.lost)).write(mean);
    traces(pass, scene.rays)
        .specialize(kTraceExact, bool(scene.rays.texels))
        .specialize(kTruthLights, frame.lights > 0)
        .specialize(kTruthEmitters, frame.emitters > 0)
        .specialize(kTruthSky, paths.skyRows ? 2u
                               : paths.sky   ? 1u
                                             : 0u)
        .specialize(kTruthMedia, frame.media > 0)
        .specialize(kTruthGlow, scene.mediumEmits)
        .specialize(kTruthPortals, bool(paths.portals))
        .push(TruthPush{samples.count, added})
        .dispatch(picture.size);
    samples.count += added;
    return mean;
}

Texture wipe(Graph& graph, const Texture& left, const Texture& right, float share)
{
    const Texture both = graph.texture("wiped", VK_FORMAT_R32G32B32A32_SFLOAT, left.size());
    graph.fullscreen("wipe", "engine/effects/truth/wipe.frag")
        .read(left)
        .read(right)
        .write(both)
        .push(WipePush{share * float(left.size().x)});
    return both;
}
}
