#include "engine/effects/reflection/reflection.hpp"
#include "engine/effects/shading.h"
#include "engine/effects/tracing.hpp"

namespace afterglow
{
namespace
{
ReflectionFrame frameOf(const View& view, const ReflectionParameters& p)
{
    const auto row = [&](int r) { return length(vec3(view.worldToClip[0][r], view.worldToClip[1][r], view.worldToClip[2][r])); };
    ReflectionFrame frame;
    frame.worldToClip = view.worldToClip;
    frame.clipToWorld = view.clipToWorld;
    frame.eye = view.eye;
    frame.size = ivec2(view.size);
    frame.steps = p.steps;
    frame.bisections = p.bisections;
    frame.divisor = p.divisor;
    // An orthographic eye has no distance: the share is of the picture's height
    const bool perspective = view.eye.w > 0.0f;
    frame.thicknessShare = perspective ? p.thickness : 0.0f;
    frame.thicknessDepths = perspective ? 0.0f : p.thickness * row(2) * 2.0f / row(1);
    frame.pixelsPerMetre = 0.5f * float(view.size.y) * row(1);
    return frame;
}

// Halves evenly `levels` - 1 times.
ImageShape evenShape(VkFormat format, uvec2 size, std::uint32_t levels)
{
    const std::uint32_t step = 1u << (levels - 1);
    return {.format = format, .size = uvec3((size + step - 1u) / step * step, 1), .mips = levels};
}

Texture depthPyramid(Graph& graph, const Texture& depth)
{
    const Texture depths = graph.texture("depths", evenShape(VK_FORMAT_R32G32_SFLOAT, depth.size(), kReflectionDepthLevels));
    for (std::uint32_t level = 0; level < kReflectionDepthLevels; ++level) {
        Pass pass = graph.fullscreen("reflection.depth." + std::to_string(level), "engine/effects/reflection/depth.frag");
        pass.specialize(kReflectionFirst, level == 0).read(level == 0 ? depth : depths.mip(level - 1)).write(depths.mip(level));
    }
    return depths;
}

// What the mirrored rays met, each at its pixel's place.
struct Mirrored {
    Texture traced; // m to it, how sure that is, whose ray it was
    Texture seen;   // its colour times the share, the share; blurred
    Texture near;   // 1/m times the share; blurred
};

Mirrored mirroredShape(Graph& graph, uvec2 rays)
{
    const Texture seen = graph.texture("seen", evenShape(VK_FORMAT_R16G16B16A16_SFLOAT, rays, kReflectionBlurLevels));
    return {graph.texture("traced", VK_FORMAT_R32G32B32A32_UINT, seen.size()), seen,
            graph.texture("near", evenShape(VK_FORMAT_R16_SFLOAT, rays, kReflectionBlurLevels))};
}

void blur(Graph& graph, const Mirrored& mirrored)
{
    for (std::uint32_t level = 1; level < kReflectionBlurLevels; ++level) {
        Pass pass = graph.fullscreen("reflection.blur." + std::to_string(level), "engine/effects/reflection/blur.frag");
        pass.read(mirrored.seen.mip(level - 1), Sampler::linear).read(mirrored.near.mip(level - 1), Sampler::linear);
        pass.write(mirrored.seen.mip(level)).write(mirrored.near.mip(level));
    }
}
}

Lit reflection(Graph& graph, const View& view, const GBuffer& surfaces, const Shadows& shadows, const GpuLevel& level, const Lit& lit,
               const LightingParts& parts, ReflectionMethod method, const ReflectionParameters& asked, Layers* layers)
{
    const bool rays = method == ReflectionMethod::ray && level.scene.rays;
    ReflectionParameters parameters = asked;
    if (rays) parameters.divisor = 1; // what a ray meets is in no picture that a pixel without one could look at
    const Buffer frame = graph.upload("reflection", frameOf(view, parameters));
    const Mirrored mirrored = mirroredShape(graph, (view.size + parameters.divisor - 1u) / parameters.divisor);
    if (rays) {
        Pass pass = graph.fullscreen("reflection.rays", "engine/effects/reflection/rays.frag");
        shade(traces(pass, level.scene.rays), shadows, lit.frame, level, parts);
        pass.specialize(kReflectionSkyImage, bool(level.scene.skyImage)).specialize(kLightingTraced, bool(shadows.traced));
        pass.read(frame).read(surfaces.surface).read(surfaces.depth);
        pass.write(mirrored.traced).write(mirrored.seen.mip(0)).write(mirrored.near.mip(0));
    } else {
        const Texture depths = depthPyramid(graph, surfaces.depth);
        Pass pass = graph.fullscreen("reflection.trace", "engine/effects/reflection/trace.frag");
        pass.read(frame).read(surfaces.surface).read(depths).read(lit.radiance, Sampler::linear);
        pass.write(mirrored.traced).write(mirrored.seen.mip(0)).write(mirrored.near.mip(0));
    }
    blur(graph, mirrored);

    Lit reflected = lit;
    reflected.radiance = graph.texture("reflected", lit.radiance.format(), view.size);
    Pass pass = graph.fullscreen("reflection", "engine/effects/reflection/reflection.frag");
    pass.specialize(kReflectionCubemaps, parts.reflections).specialize(kReflectionRays, rays);
    pass.specialize(kReflectionFacets, bool(surfaces.facets));
    pass.read(frame).read(surfaces.surface).read(surfaces.depth).read(lit.radiance, Sampler::linear).read(lit.mirrored);
    pass.read(mirrored.traced).read(mirrored.seen, Sampler::linear).read(mirrored.near, Sampler::linear).read(surfaces.facets);
    pass.write(reflected.radiance);
    if (layers) {
        layers->reflection = reflected.mirrored = graph.texture("reflected layer", lit.mirrored.format(), view.size);
        pass.specialize(kReflectionLayer, true).write(reflected.mirrored);
    }
    return reflected;
}
}
