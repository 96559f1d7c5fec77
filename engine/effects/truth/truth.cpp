#include "engine/effects/truth/truth.hpp"
#include "engine/core/error.hpp"
#include "engine/effects/tracing.hpp"
#include "engine/effects/truth/waves.hpp"
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

const std::map<std::string, Tracing>& tracingWords()
{
    static const std::map<std::string, Tracing> words = {
        {"auto", Tracing::automatic}, {"kernel", Tracing::kernel}, {"pipeline", Tracing::pipeline}, {"wavefront", Tracing::wavefront}};
    return words;
}

bool canTrace(const Device& device, Tracing tracing)
{
    if (tracing == Tracing::automatic) return device.rayQuery || device.rayPipeline;
    return tracing == Tracing::pipeline ? device.rayPipeline : device.rayQuery;
}

Tracing tracingOn(const Device& device, Tracing asked)
{
    const auto wordOf = [](Tracing tracing) {
        const auto& words = tracingWords();
        return std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.second == tracing; })->first;
    };
    const auto refuse = [&](const std::string& what) { throw Error(what, Exit::noDevice); };
    if (!canTrace(device, Tracing::automatic))
        refuse("--mode truth: " + device.deviceName + " traces no rays; `afterglow truth` traces the same paths on the CPU");
    if (!canTrace(device, asked) && asked == Tracing::pipeline)
        refuse("--tracing pipeline: " + device.deviceName + " has no ray-tracing pipelines; --tracing kernel traces the same paths");
    if (!canTrace(device, asked))
        refuse("--tracing " + wordOf(asked) + ": " + device.deviceName + " has no ray queries; --tracing pipeline traces the same paths");
    if (!device.rayQuery) return Tracing::pipeline;
    if (asked != Tracing::automatic) return asked;
    // Measured on Mesa's lavapipe alone (README, Cost): small kernels keep its vectors full where paths are long, and compile sooner than a
    // large one; short paths in a small picture take a third longer. What has queries and was not measured asks them in one kernel.
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device.physical, &properties);
    return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? Tracing::wavefront : Tracing::kernel;
}

Pass& give(Pass& pass, const PathTracing& to)
{
    const GpuPaths& paths = to.traced.paths;
    const GpuScene& scene = to.traced.level.scene;
    const TruthFrame& frame = to.samples.of;
    const auto given = [&](const GpuBuffer& buffer) { return buffer ? to.graph.import(buffer) : Buffer{}; };
    pass.read(to.frame).read(given(paths.lights)).read(given(paths.emitters)).read(given(paths.densities));
    pass.read(given(paths.skyRows)).read(paths.sky ? to.graph.import(paths.sky) : Texture{});
    pass.read(given(paths.portals)).read(given(paths.portalOf));
    pass.modify(to.graph.import(to.samples.sum)).modify(to.graph.import(to.samples.lost));
    return traces(pass, scene.rays)
        .specialize(kTraceExact, bool(scene.rays.texels))
        .specialize(kTruthLights, frame.lights > 0)
        .specialize(kTruthEmitters, frame.emitters > 0)
        .specialize(kTruthSky, paths.skyRows ? 2u
                               : paths.sky   ? 1u
                                             : 0u)
        .specialize(kTruthMedia, frame.media > 0)
        .specialize(kTruthGlow, scene.mediumEmits)
        .specialize(kTruthPortals, bool(paths.portals));
}

// Opaque surfaces are asked nothing; where all of a level's are, there are no programs that ask.
static RayPrograms programsOf(const GpuRays& rays)
{
    static const std::string kFolder = "engine/effects/truth/";
    static_assert(kRayNearest == 0 && kRayShadow == 1 && kHitOpaque == 0 && kHitFiltered == 1, "the order of what follows");
    RayPrograms programs{
        kFolder + "truth.rgen", {kFolder + "nearest.rmiss", kFolder + "shadow.rmiss"}, {{kFolder + "nearest.rchit", ""}, {}}};
    if (rays.filtered) {
        programs.hits.push_back({kFolder + "nearest.rchit", kFolder + "nearest.rahit"});
        programs.hits.push_back({"", kFolder + "shadow.rahit"});
    }
    return programs;
}

Texture truth(Graph& graph, const Traced& traced, const Picture& picture, TracedSamples& samples, const TruthParameters& parameters)
{
    const GpuScene& scene = traced.level.scene;
    check(bool(scene.rays), "paths need something to meet, even in an empty level");
    const TruthFrame frame = frameOf(scene, traced.paths, picture, parameters);
    const uvec3 size(picture.size, 1);
    if (samples.sum.shape.size != size || !samples.sum)
        for (GpuImage* image : {&samples.sum, &samples.lost})
            *image = traced.memory.image("traced samples", {VK_FORMAT_R32G32B32A32_SFLOAT, size}, VK_IMAGE_USAGE_STORAGE_BIT);
    if (std::memcmp(&samples.of, &frame, sizeof(frame)) != 0) samples.count = 0; // 4-byte members without a gap
    samples.of = frame;
    const uint added = std::min(parameters.perFrame, parameters.samples - std::min(samples.count, parameters.samples));

    const PathTracing paths{graph, traced, samples, graph.upload("truth.frame", frame), {samples.count, added}};
    samples.count += added;
    if (traced.tracing == Tracing::wavefront) return traceWaves(paths);
    const Texture mean = graph.texture("truth", VK_FORMAT_R32G32B32A32_SFLOAT, picture.size);
    Pass pass = traced.tracing == Tracing::pipeline ? graph.trace("truth", programsOf(scene.rays))
                                                    : graph.compute("truth", "engine/effects/truth/truth.comp");
    give(pass, paths).write(mean).push(paths.added).dispatch(picture.size);
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
