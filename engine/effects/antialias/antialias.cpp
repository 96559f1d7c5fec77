#include "engine/effects/antialias/antialias.hpp"
#include "engine/effects/antialias/antialias.h"
#include "engine/effects/motion.hpp"
#include "shaders/camera.h"
#include <algorithm>

namespace afterglow
{
namespace
{
// How far apart the depths of neighbouring pixels of one surface may lie. Of a perspective, depth = near / distance, it is a share of the
// depth; of an orthographic eye, a depth. Both are a few pixels' worth of a surface at 45 degrees.
vec2 depthTolerance(const View& view)
{
    constexpr float kPixels = 4.0f;
    constexpr float kLeast = 0.01f; // of the distance: what remains of large pictures
    const vec3 near_ = worldFromDepth(vec2(0.5f), 1.0f, view.clipToWorld);
    const vec3 above = worldFromDepth(vec2(0.5f, 0.5f + 1.0f / float(view.size.y)), 1.0f, view.clipToWorld);
    const float pixel = length(above - near_);
    if (view.eye.w > 0.0f) return vec2(std::max(kPixels * pixel / std::max(length(near_ - vec3(view.eye)), 1e-9f), kLeast), 0.0f);
    const float depth = length(worldFromDepth(vec2(0.5f), 0.0f, view.clipToWorld) - near_);
    return vec2(0.0f, std::min(kPixels * pixel / depth, kLeast));
}

// One picture of the frame, and its own past.
Texture gather(Graph& graph, const std::string& name, const Texture& image, const GBuffer& surfaces, const Texture& moved,
               const AntialiasPush& push, const ShownSize& shown)
{
    const History colors = graph.history(name + " mean", VK_FORMAT_R32G32B32A32_SFLOAT, shown.size);
    const History depths = graph.history(name + " depth", VK_FORMAT_R32_SFLOAT, shown.size);
    graph.fullscreen(name, "engine/effects/antialias/antialias.frag")
        .read(image)
        .read(surfaces.depth)
        .read(moved)
        .read(colors.previous, Sampler::linear)
        .read(depths.previous)
        .write(colors.current)
        .write(depths.current)
        .specialize(kAntialiasUpscale, shown.upscaled)
        .specialize(kAntialiasMotion, bool(moved))
        .push(push);
    return colors.current;
}
}

uint restingFrames(const View& view, const GpuScene& scene, const Gathered& gathered)
{
    const bool moves = std::any_of(scene.draws.begin(), scene.draws.end(), [](const DrawItem& item) { return item.moved; });
    return gathered.frames > 0 && !moves && view.last == view.steady ? gathered.resting + 1 : 0;
}

Texture antialias(Graph& graph, const View& view, const GBuffer& surfaces, const GpuScene& scene, const Texture& image,
                  const ShownSize& shown, Gathered& gathered, Layers* layers)
{
    const Texture moved = movedSurfaces(graph, "antialias.motion", view, surfaces, scene);
    gathered.resting = restingFrames(view, scene, gathered);
    const bool still = gathered.resting > 0;

    AntialiasPush push{};
    push.toLast = mat4(view.last * inverse(jittered(view)));
    push.jitter = view.jitter;
    push.depthTolerance = depthTolerance(view);
    push.most = still ? std::min(float(gathered.resting) + kCarriedFrames, kRestingFrames) : kMovingFrames;
    if (gathered.frames == 0) push.most = 0.0f;
    push.still = still;
    ++gathered.frames;

    if (layers)
        for (Texture* part : {&layers->direct, &layers->indirect, &layers->reflection, &layers->emission, &layers->fog, &layers->occlusion})
            if (*part) *part = gather(graph, "antialias." + graph.resources[part->index].name, *part, surfaces, moved, push, shown);
    return gather(graph, "antialias", image, surfaces, moved, push, shown);
}
}
