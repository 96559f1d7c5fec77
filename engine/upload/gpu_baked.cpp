#include "engine/upload/gpu_baked.hpp"
#include "engine/baked/probes.hpp"
#include "engine/core/error.hpp"
#include "engine/upload/probe_grid.hpp"
#include "engine/upload/split_sum.hpp"
#include "engine/upload/storage.hpp"
#include "shaders/gbuffer.h"
#include "shaders/lightmap.h"
#include <span>

namespace afterglow
{
namespace
{
u16vec4 half4(vec3 c)
{
    const vec3 v = clampToHalf(c);
    return u16vec4(packHalf1x16(v.x), packHalf1x16(v.y), packHalf1x16(v.z), packHalf1x16(1.0f));
}

GpuImage uploadLightmap(Gpu& gpu, const Lightmap& map, std::size_t page)
{
    std::vector<uint> texels(map.texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = encodeSharedExponent(map.texels[i]);
    GpuImage image = gpu.memory.image("lightmap " + std::to_string(page),
                                      {.format = VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, .size = {map.width, map.height, 1}});
    gpu.memory.upload(image, texels.data(), texels.size() * sizeof(texels[0]));
    return image;
}

GpuImage uploadDirection(Gpu& gpu, const Lightmap& map, std::size_t page)
{
    std::vector<u16vec4> texels;
    for (const vec4& d : map.direction)
        texels.push_back(u16vec4(packHalf1x16(d.x), packHalf1x16(d.y), packHalf1x16(d.z), packHalf1x16(d.w)));
    GpuImage image = gpu.memory.image("direction " + std::to_string(page),
                                      {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .size = {map.width, map.height, 1}});
    gpu.memory.upload(image, texels.data(), texels.size() * sizeof(texels[0]));
    return image;
}

GpuBuffer texelBuffer(Gpu& gpu, const std::string& name, const std::vector<vec4>& texels)
{
    if (texels.size() > gpu.device.limits.maxTexelBufferElements)
        throw Error("the bake's irradiance probes take " + std::to_string(texels.size()) + " texels, and " + gpu.device.deviceName +
                    " reads " + std::to_string(gpu.device.limits.maxTexelBufferElements) +
                    ": bake with a larger --probe-spacing or a --probe-budget");
    return storage(gpu, name, texels, VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
}

void uploadProbes(Gpu& gpu, const ProbeTree& tree, GpuBaked& to)
{
    const QuickTree quick = quickTree(tree);
    to.probeTree = texelBuffer(gpu, "probe tree", probeTreeTexels(quick.nodes, tree.cells));
    to.probes = texelBuffer(gpu, "probes", probeTexels(tree, tree.positions, /* order= */ 2));
    std::vector<std::byte> starts;
    for (const std::span<const std::byte> part : {std::as_bytes(std::span(&quick.grid, 1)), std::as_bytes(std::span(quick.starts))})
        starts.insert(starts.end(), part.begin(), part.end());
    to.probeStarts = storage(gpu, "probe starts", starts);
}

GpuImage uploadReflection(Gpu& gpu, const ReflectionProbe& probe)
{
    ImageShape shape{.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                     .size = {probe.size, probe.size, 1},
                     .mips = uint(probe.mips.size()),
                     .layers = 6,
                     .kind = ImageKind::cube};
    GpuImage image = gpu.memory.image("reflection " + probe.name, shape);
    for (uint mip = 0; mip < shape.mips; ++mip) {
        std::vector<u16vec4> texels(probe.mips[mip].size());
        for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = half4(probe.mips[mip][i]);
        gpu.memory.upload(image, texels.data(), texels.size() * sizeof(texels[0]), mip);
    }
    return image;
}
}

GpuBaked uploadBaked(Gpu& gpu, const Baked& baked, const BakedParts& parts)
{
    GpuBaked result;
    if (baked.lightmaps.size() > kGBufferBackPage)
        throw Error(baked.scene.path.string() + ": the bake has " + std::to_string(baked.lightmaps.size()) +
                    " lightmaps, and a frame tells " + std::to_string(kGBufferBackPage) + " apart: bake with fewer --texels-per-metre");
    if (parts.lightmaps)
        for (const Lightmap& map : baked.lightmaps) result.lightmaps.push_back(uploadLightmap(gpu, map, result.lightmaps.size()));
    if (parts.lightmaps && parts.directional)
        for (const Lightmap& map : baked.lightmaps)
            if (!map.direction.empty()) result.directions.push_back(uploadDirection(gpu, map, result.directions.size()));
    if (parts.probes && !baked.probes.empty()) uploadProbes(gpu, baked.probes, result);
    if (parts.reflections && !baked.reflections.empty()) {
        std::vector<ReflectionBox> boxes;
        for (const ReflectionProbe& probe : baked.reflections) {
            boxes.push_back({probe.position, float(probe.mips.size()), probe.boxLower, probe.boxUpper});
            result.reflections.push_back(uploadReflection(gpu, probe));
        }
        result.reflectionBoxes = storage(gpu, "reflection boxes", boxes);
        result.splitSum = uploadSplitSum(gpu);
    }
    return result;
}

std::vector<Instance> placedInstances(const Baked& baked)
{
    std::vector<Instance> placed = instances(baked.scene);
    for (Instance& instance : placed) {
        if (instance.object >= baked.places.size()) continue;
        const LightmapPlace& place = baked.places[instance.object];
        instance.lightmap = place.page;
        instance.lightmapScale = place.scale;
        instance.lightmapOffset = place.offset;
    }
    return placed;
}
}
