#include "engine/effects/reflection/reflection.hpp"

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
}

Lit reflection(Graph& graph, const View& view, const GBuffer& surfaces, const Lit& lit, bool cubemaps,
               const ReflectionParameters& parameters, Layers* layers)
{
    const Buffer frame = graph.upload("reflection", frameOf(view, parameters));
    const Texture depths = depthPyramid(graph, surfaces.depth);

    const uvec2 rays = (view.size + parameters.divisor - 1u) / parameters.divisor;
    const Texture seen = graph.texture("seen", evenShape(VK_FORMAT_R16G16B16A16_SFLOAT, rays, kReflectionBlurLevels));
    const Texture far = graph.texture("far", evenShape(VK_FORMAT_R16_SFLOAT, rays, kReflectionBlurLevels));
    const Texture traced = graph.texture("traced", VK_FORMAT_R32G32B32A32_UINT, seen.size());
    Pass trace = graph.fullscreen("reflection.trace", "engine/effects/reflection/trace.frag");
    trace.read(frame).read(surfaces.surface).read(depths).read(lit.radiance, Sampler::linear);
    trace.write(traced).write(seen.mip(0)).write(far.mip(0));
    for (std::uint32_t level = 1; level < kReflectionBlurLevels; ++level) {
        Pass blur = graph.fullscreen("reflection.blur." + std::to_string(level), "engine/effects/reflection/blur.frag");
        blur.read(seen.mip(level - 1), Sampler::linear).read(far.mip(level - 1), Sampler::linear);
        blur.write(seen.mip(level)).write(far.mip(level));
    }

    Lit reflected = lit;
    reflected.radiance = graph.texture("reflected", lit.radiance.format(), view.size);
    Pass pass = graph.fullscreen("reflection", "engine/effects/reflection/reflection.frag");
    pass.specialize(kReflectionCubemaps, cubemaps).read(frame).read(surfaces.surface).read(surfaces.depth);
    pass.read(lit.radiance, Sampler::linear).read(lit.mirrored).read(traced).read(seen, Sampler::linear).read(far, Sampler::linear);
    pass.write(reflected.radiance);
    if (layers) {
        layers->reflection = reflected.mirrored = graph.texture("reflected layer", lit.mirrored.format(), view.size);
        pass.specialize(kReflectionLayer, true).write(reflected.mirrored);
    }
    return reflected;
}
}
