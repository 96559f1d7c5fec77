#include "engine/upload/gpu_scene.hpp"
#include "engine/core/error.hpp"
#include "engine/scene/closed.hpp"
#include "engine/scene/material.hpp"
#include "engine/upload/layer_tables.hpp"
#include "engine/upload/storage.hpp"
#include "shaders/gbuffer.h"
#include "shaders/lightmap.h"
#include "shaders/microfacet.h"
#include <algorithm>
#include <limits>
#include <map>

namespace afterglow
{
namespace
{
GpuImage uploadTexture(Gpu& gpu, const SceneTexture& texture)
{
    const Image8& image = texture.image;
    ImageShape shape;
    shape.format = texture.srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM;
    shape.size = {image.width, image.height, 1};
    shape.mips = texture.nearest ? 1 : mipCount(glm::uvec2(shape.size));
    GpuImage result = gpu.memory.image("texture " + texture.name, shape);
    gpu.memory.upload(result, image.pixels.data(), image.pixels.size());
    if (shape.mips > 1) gpu.memory.makeMips(result);
    return result;
}

GpuImage uploadSky(Gpu& gpu, const Image& sky)
{
    if (sky.pixels.empty()) return {};
    std::vector<u16vec4> texels(std::size_t(sky.width) * sky.height);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const float* p = &sky.pixels[i * sky.channels];
        const vec3 radiance = clampToHalf(sky.channels >= 3 ? vec3(p[0], p[1], p[2]) : vec3(p[0]));
        texels[i] = u16vec4(packHalf1x16(radiance.x), packHalf1x16(radiance.y), packHalf1x16(radiance.z), packHalf1x16(1.0f));
    }
    GpuImage image = gpu.memory.image("sky", {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .size = {sky.width, sky.height, 1}});
    gpu.memory.upload(image, texels.data(), texels.size() * sizeof(texels[0]));
    return image;
}

// By the first index of their primitive. Their indices go behind those of the level.
std::map<uint, std::vector<CoarserLevel>> appendLevels(std::vector<uint>& indices, const Scene& scene, std::span<const MeshLods> lods)
{
    std::map<uint, std::vector<CoarserLevel>> levels;
    for (std::size_t m = 0; m < lods.size(); ++m)
        for (std::size_t p = 0; p < lods[m].primitives.size(); ++p)
            for (const LodLevel& level : lods[m].primitives[p]) {
                levels[scene.meshes[m].primitives[p].firstIndex].push_back(
                    {uint(indices.size()), uint(level.indices.size()), level.error, level.turn});
                indices.insert(indices.end(), level.indices.begin(), level.indices.end());
            }
    return levels;
}

// Whether it may show a metal whose facets lose light (shaders/facets.h): textures make it less metallic and less rough alone.
bool isRoughMetal(const Material& material)
{
    if (material.flags & (kMaterialLambert | kMaterialUnlit)) return false;
    return material.metallic > 0.0f && !isMirror(roughnessToAlpha(material.roughness, material.anisotropy));
}

// Alpha of the narrowest lobe that the material shows anywhere; 1: matte.
float narrowestLobe(const Scene& scene, const Material& material)
{
    const float roughness = (material.flags & kMaterialLambert) != 0 ? 1.0f : lowestRoughness(scene, material);
    return roughness * roughness;
}

DrawItem drawItem(const Scene& scene, const Instance& instance)
{
    const Material& material = scene.materials[instance.material];
    DrawItem item;
    item.instance = instance;
    item.before = instance.toWorld;
    item.lower = item.objectLower = vec3(std::numeric_limits<float>::max());
    item.upper = item.objectUpper = -item.lower;
    for (uint i = 0; i < instance.indexCount; ++i) {
        const uint vertex = instance.firstVertex + scene.indices[instance.firstIndex + i];
        const vec3 local = scene.vertices[vertex].position, p = instance.toWorld * vec4(local, 1.0f);
        item.lower = min(item.lower, p);
        item.upper = max(item.upper, p);
        item.objectLower = min(item.objectLower, local);
        item.objectUpper = max(item.objectUpper, local);
    }
    if (isClear(material))
        item.kind = DrawKind::clear;
    else if (material.flags & kMaterialAlphaMask)
        item.kind = DrawKind::masked;
    item.emits = (material.flags & kMaterialUnlit) || material.emission != vec3(0.0f);
    item.roughMetal = isRoughMetal(material);
    return item;
}
}

void move(GpuScene& scene, uint object, const mat4& toWorld)
{
    for (DrawItem& item : scene.draws) {
        if (item.instance.object != object) continue;
        item.instance.toWorld = mat4x3(toWorld);
        item.instance.normalToWorld = inverse(transpose(mat3(toWorld)));
        item.moved = item.instance.toWorld != item.before;
        item.lower = vec3(std::numeric_limits<float>::max());
        item.upper = -item.lower;
        for (int corner = 0; corner < 8; ++corner) {
            const bvec3 high(corner & 1, corner & 2, corner & 4);
            const vec3 p = item.instance.toWorld * vec4(mix(item.objectLower, item.objectUpper, high), 1.0f);
            item.lower = min(item.lower, p);
            item.upper = max(item.upper, p);
        }
    }
}

void findClosedBodies(GpuScene& uploaded, const Scene& scene)
{
    std::map<uint, bool> closed; // by the first index of a primitive
    for (const DrawItem& item : uploaded.draws)
        if (item.kind == DrawKind::opaque) closed[item.instance.firstIndex] = false;
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives)
            if (const auto asked = closed.find(primitive.firstIndex); asked != closed.end()) asked->second = isClosedBody(scene, primitive);
    for (DrawItem& item : uploaded.draws) item.closed = item.kind == DrawKind::opaque && closed.at(item.instance.firstIndex);
}

void settle(GpuScene& scene)
{
    for (DrawItem& item : scene.draws) {
        item.before = item.instance.toWorld;
        item.moved = false;
    }
}

bool isClear(const Material& material) { return (material.flags & kMaterialAlphaBlend) || material.transmission > 0.0f; }

std::vector<Light> runtimeLights(const Scene& scene, bool baked, bool directAll)
{
    std::vector<Light> lights;
    for (const Light& light : scene.lights) {
        const bool inTheBake = baked && (directAll || light.bake == kBakeAll);
        if (!inTheBake && light.intensity != vec3(0.0f)) lights.push_back(light);
    }
    return lights;
}

GpuScene uploadScene(Gpu& gpu, const Scene& scene, const std::vector<Instance>& placed, const std::vector<Light>& lights,
                     std::span<const MeshLods> lods)
{
    if (scene.materials.size() > kGBufferMaterials)
        throw Error("the level has " + std::to_string(scene.materials.size()) + " materials, and a picture can tell " +
                    std::to_string(kGBufferMaterials) + " apart: merge some, or bake without drawing");
    GpuScene result;
    result.vertices = storage(gpu, "vertices", scene.vertices);
    std::vector<uint> indices = scene.indices;
    const auto levels = appendLevels(indices, scene, lods);
    result.indices = storage(gpu, "indices", indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    result.materials = storage(gpu, "materials", scene.materials);
    result.lights = storage(gpu, "lights", lights);
    result.media = storage(gpu, "media", scene.media);
    for (const Medium& medium : scene.media) result.mediumEmits |= medium.emission != vec3(0.0f);
    result.mediumPlanes = storage(gpu, "medium planes", scene.mediumPlanes);
    result.skyImage = uploadSky(gpu, scene.sky.image);
    for (const SceneTexture& texture : scene.textures) {
        result.textures.push_back(uploadTexture(gpu, texture));
        SceneTexture how = texture;
        how.image = {};
        result.textureSamplers.push_back(std::move(how));
    }
    const auto layered = [](const Material& m) { return (m.flags & kMaterialLambert) == 0; };
    if (std::any_of(scene.materials.begin(), scene.materials.end(), layered)) {
        result.layerRatio = uploadLayerRatio(gpu);
        result.layerMean = uploadLayerMean(gpu);
    }
    result.runtimeLights = lights;
    std::map<uint, float> narrowest; // by material; every texel of a texture is looked at, and only levels of detail ask
    for (uint i = 0; i < placed.size(); ++i) {
        if (placed[i].indexCount == 0) continue;
        DrawItem& item = result.draws.emplace_back(drawItem(scene, placed[i]));
        item.place = i;
        const auto found = levels.find(placed[i].firstIndex);
        if (found == levels.end()) continue;
        item.coarser = found->second;
        const auto [lobe, isNew] = narrowest.try_emplace(placed[i].material);
        if (isNew) lobe->second = narrowestLobe(scene, scene.materials[placed[i].material]);
        item.alpha = lobe->second;
    }
    if (!result.draws.empty()) {
        result.lower = result.draws[0].lower;
        result.upper = result.draws[0].upper;
    }
    for (const DrawItem& item : result.draws) {
        result.lower = min(result.lower, item.lower);
        result.upper = max(result.upper, item.upper);
    }
    return result;
}
}
