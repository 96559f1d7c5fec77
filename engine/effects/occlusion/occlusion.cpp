#include "engine/effects/occlusion/occlusion.hpp"
#include "engine/core/error.hpp"
#include "engine/effects/tracing.hpp"
#include <glm/gtc/matrix_transform.hpp>

namespace afterglow
{
namespace
{
// Where places are counted from: the eye, or the middle of an orthographic one's plane.
dvec3 eyeOf(const View& view)
{
    const dvec4 middle = dmat4(view.clipToWorld) * dvec4(0, 0, 1, 1);
    return view.eye.w > 0.0f ? dvec3(vec3(view.eye)) : dvec3(middle) / middle.w;
}

OcclusionFrame frameOf(const View& view, const GpuVoxels& voxels, const OcclusionParameters& parameters)
{
    // From the eye itself, in double: far from the origin floats would not tell neighbouring pixels apart
    const dmat4 clipToWorld(view.clipToWorld);
    const dvec3 eye = eyeOf(view);
    const dvec2 size(view.size);
    // Centre of pixel i: (i + 1/2) 2 / size - 1
    const dmat4 pixelToClip = translate(dmat4(1), dvec3(1.0 / size - 1.0, 0.0)) * scale(dmat4(1), dvec3(2.0 / size, 1.0));
    OcclusionFrame frame;
    frame.pixelToEye = mat4(translate(dmat4(1), -eye) * clipToWorld * pixelToClip);
    frame.eyeToClip = mat4(dmat4(view.worldToClip) * translate(dmat4(1), eye));
    frame.eye = view.eye;
    frame.metres = metresOfDepth(view);
    frame.size = ivec2(view.size);
    frame.voxelLower = vec3(dvec3(voxels.lower) - eye);
    frame.voxelEdge = voxels.edge;
    frame.p = parameters;
    return frame;
}

// Of the method's pass and of its shader.
const char* nameOf(OcclusionMethod method)
{
    switch (method) {
    case OcclusionMethod::ssao:
        return "ssao";
    case OcclusionMethod::voxel:
        return "voxel";
    case OcclusionMethod::ray:
        return "ray";
    default:
        return "hbao";
    }
}
}

Texture occlusion(Graph& graph, const View& view, const GBuffer& surfaces, const Occluders& level, OcclusionMethod method,
                  const OcclusionParameters& parameters, bool mapped)
{
    check(parameters.range > 0.0f && (parameters.divisor == 1 || parameters.divisor == 2), "occlusion looks a way, at full or half size");
    const Buffer frame = graph.upload("occlusion", frameOf(view, level.voxels, parameters));
    const uvec2 size = (view.size + parameters.divisor - 1u) / parameters.divisor;
    Texture seen = graph.texture("occlusion.seen", VK_FORMAT_R32G32B32A32_SFLOAT, size);
    if (method == OcclusionMethod::ray && !level.rays) method = OcclusionMethod::hbao;
    const std::string name = nameOf(method);
    Pass look = graph.fullscreen("occlusion." + name, "engine/effects/occlusion/" + name + ".frag");
    look.read(frame).read(surfaces.surface).read(surfaces.depth).write(seen).specialize(kOcclusionMapped, mapped);
    if (method == OcclusionMethod::voxel) {
        const GpuImage& voxels = level.voxels.image;
        look.read(voxels ? graph.import(voxels) : Texture{}, Sampler::linear);
        look.specialize(kOcclusionVoxelMips, voxels ? voxels.shape.mips : 0u);
    }
    Texture noise;
    if (method == OcclusionMethod::ray) {
        const bool filtered = parameters.denoise > 0 && parameters.rays >= kFewestFiltered;
        if (filtered) noise = graph.texture("occlusion.noise", VK_FORMAT_R8_UNORM, size);
        traces(look, level.rays).push(OcclusionTrace{vec3(eyeOf(view)), view.frame}).specialize(kOcclusionNoise, filtered).write(noise);
    }
    if (noise || parameters.smooth_ > 0) {
        const Texture smoothed = graph.texture("occlusion.smoothed", seen.format(), size);
        const std::string how = noise ? "denoise" : "smooth";
        Pass average = graph.fullscreen("occlusion." + how, "engine/effects/occlusion/" + how + ".frag");
        average.read(frame).read(seen).write(smoothed);
        if (noise) average.read(noise).push(OcclusionDenoise{float(view.resting + 1)});
        seen = smoothed;
    }
    const Texture visibility = graph.texture("visibility", VK_FORMAT_R16_SFLOAT, view.size);
    Pass spread = graph.fullscreen("occlusion", "engine/effects/occlusion/occlusion.frag");
    spread.read(frame).read(surfaces.surface).read(surfaces.depth).read(seen).write(visibility).specialize(kOcclusionMapped, mapped);
    return visibility;
}
}
