#include "engine/upload/gpu_baked.hpp"
#include "engine/upload/split_sum.hpp"
#include "shaders/lightmap.h"
#include "shaders/probe.h"

namespace afterglow
{
namespace
{
u16vec4 half4(vec3 c)
{
    const vec3 v = clampToHalf(c);
    return u16vec4(packHalf1x16(v.x), packHalf1x16(v.y), packHalf1x16(v.z), packHalf1x16(1.0f));
}

template <typename T>
GpuBuffer storage(Gpu& gpu, const std::string& name, const std::vector<T>& values)
{
    if (values.empty()) return {};
    GpuBuffer buffer = gpu.memory.buffer(name, values.size() * sizeof(T), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    gpu.memory.upload(buffer, values.data(), values.size() * sizeof(T));
    return buffer;
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

// Radiance averaged over all directions is the constant band: c00 * Y00. Probes inside solids borrow from their valid neighbours, so that
// the hardware's filter never blends in what they do not know.
GpuImage uploadMeanRadiance(Gpu& gpu, const ProbeVolume& volume)
{
    const ivec3 n = volume.count;
    std::vector<u16vec4> texels(volume.irradiance.size());
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x) {
                vec3 sum(0.0f);
                float weight = 0.0f;
                for (int corner = 0; corner < 27; ++corner) {
                    const ivec3 step(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1);
                    const ivec3 at = clamp(ivec3(x, y, z) + step, ivec3(0), n - 1);
                    const int index = probeIndex(at, n);
                    const float w = volume.validity[index] * (step == ivec3(0) ? 1.0f : 1e-4f);
                    sum += w * volume.irradiance[index].c[0] * shBasis(0, vec3(0.0f));
                    weight += w;
                }
                texels[probeIndex(ivec3(x, y, z), n)] = half4(weight > 0.0f ? sum / weight : vec3(0.0f));
            }
    GpuImage image = gpu.memory.image("mean radiance " + volume.name,
                                      {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .size = uvec3(n), .kind = ImageKind::volume});
    gpu.memory.upload(image, texels.data(), texels.size() * sizeof(texels[0]));
    return image;
}

void uploadProbes(Gpu& gpu, const std::vector<ProbeVolume>& volumes, GpuBaked& result)
{
    std::vector<ProbeBox> boxes;
    std::vector<Probe> probes;
    for (const ProbeVolume& volume : volumes) {
        ProbeBox box;
        box.toWorld = mat4x3(volume.toWorld);
        box.toUnit = mat4x3(inverse(volume.toWorld));
        box.count = volume.count;
        box.first = uint(probes.size());
        boxes.push_back(box);
        for (std::size_t i = 0; i < volume.irradiance.size(); ++i) probes.push_back({volume.irradiance[i], volume.validity[i]});
        result.meanRadiance.push_back(uploadMeanRadiance(gpu, volume));
    }
    result.probeBoxes = storage(gpu, "probe boxes", boxes);
    result.probes = storage(gpu, "probes", probes);
    result.probeBoxCount = uint(boxes.size());
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
    if (parts.lightmaps)
        for (const Lightmap& map : baked.lightmaps) result.lightmaps.push_back(uploadLightmap(gpu, map, result.lightmaps.size()));
    if (parts.probes) uploadProbes(gpu, baked.probes, result);
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
