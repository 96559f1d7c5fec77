#include "engine/scene/material.hpp"
#include "engine/scene/extras.hpp"
#include "engine/scene/fields.hpp"
#include "engine/scene/repair.hpp"
#include "engine/scene/texture.hpp"
#include "shaders/constants.h"
#include "shaders/reflection.h"
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

constexpr float kBrightest = 1e18f;   // of radiance: its square is still a finite float
constexpr float kLargestIor = 100.0f; // and what glTF's 0 ("reflects all") becomes
constexpr float kFarthest = std::numeric_limits<float>::infinity();
constexpr const char* kOutOfRange = "material values outside their range";
constexpr const char* kAlbedo = "albedos outside 0 to 1";

float share(const json& object, const char* key, double fallback, Dropped& dropped) // 0..1
{
    return clamped(number(object, key, fallback), 0.0f, 1.0f, dropped, kOutOfRange);
}

void readMetallicRoughness(const json& source, Material& material, Dropped& dropped)
{
    const dvec4 color = quadruple(source, "baseColorFactor", dvec4(1.0));
    material.baseColor = vec4(clamped(dvec3(color), 0.0f, 1.0f, dropped, kAlbedo), clamped(color.w, 0.0f, 1.0f, dropped, kOutOfRange));
    material.metallic = share(source, "metallicFactor", 1.0, dropped);
    material.roughness = share(source, "roughnessFactor", 1.0, dropped);
}

void readEmission(const json& source, Material& material, Dropped& dropped)
{
    const double strength = number(extension(source, "KHR_materials_emissive_strength"), "emissiveStrength", 1.0);
    const dvec3 emission = triple(source, "emissiveFactor", dvec3(0.0)) * strength;
    material.emission = clamped(emission, 0.0f, kBrightest, dropped, "emissions below 0 or beyond 1e18");
}

void readExtensions(const json& source, Material& material, Dropped& dropped)
{
    const json& ior = extension(source, "KHR_materials_ior");
    const double index = number(ior, "ior", 1.5);
    material.ior = index == 0.0 ? kLargestIor : clamped(index, 1.0f, kLargestIor, dropped, kOutOfRange);

    const json& specular = extension(source, "KHR_materials_specular");
    material.specular = share(specular, "specularFactor", 1.0, dropped);
    material.specularColor = clamped(triple(specular, "specularColorFactor", dvec3(1.0)), 0.0f, kBrightest, dropped, kOutOfRange);

    material.transmission = share(extension(source, "KHR_materials_transmission"), "transmissionFactor", 0.0, dropped);

    const json& volume = extension(source, "KHR_materials_volume");
    material.thickness = clamped(number(volume, "thicknessFactor", 0.0), 0.0f, kLargestCoordinate, dropped, kOutOfRange);
    material.attenuationColor = clamped(triple(volume, "attenuationColor", dvec3(1.0)), 0.0f, 1.0f, dropped, kOutOfRange);
    constexpr float kNearest = 1e-9f; // m: opaque at any scale of a level
    material.attenuationDistance =
        clamped(number(volume, "attenuationDistance", double(kFarthest)), kNearest, kFarthest, dropped, kOutOfRange);

    const json& anisotropy = extension(source, "KHR_materials_anisotropy");
    material.anisotropy = share(anisotropy, "anisotropyStrength", 0.0, dropped);
    material.anisotropyRotation = float(std::remainder(number(anisotropy, "anisotropyRotation", 0.0), 2.0 * double(kPi)));
}

uint readFlags(const json& source, Material& material, Dropped& dropped)
{
    uint flags = flag(source, "doubleSided", false) ? kMaterialDoubleSided : 0;
    const std::string alpha = text(source, "alphaMode", "OPAQUE");
    if (alpha == "MASK") flags |= kMaterialAlphaMask;
    if (alpha == "BLEND") flags |= kMaterialAlphaBlend;
    if (alpha == "OPAQUE") material.baseColor.w = 1.0f;
    material.alphaCutoff = clamped(number(source, "alphaCutoff", 0.5), 0.0f, kBrightest, dropped, kOutOfRange);
    if (!extension(source, "KHR_materials_unlit").is_null()) flags |= kMaterialUnlit;
    return flags;
}

Material readMaterial(const Document& document, const json& source, TextureIndex& known, Scene& scene)
{
    Material material = plaster();
    const json& pbr = member(source, "pbrMetallicRoughness");
    readMetallicRoughness(pbr, material, scene.dropped);
    readEmission(source, material, scene.dropped);
    readExtensions(source, material, scene.dropped);
    material.flags = readFlags(source, material, scene.dropped);

    const auto texture = [&](const json& owner, const char* key, Slot slot) {
        return readTextureRef(document, member(owner, key), slot, known, scene);
    };
    const json& transmission = extension(source, "KHR_materials_transmission");
    material.baseColorTexture = texture(pbr, "baseColorTexture", Slot::baseColor);
    material.metallicRoughnessTexture = texture(pbr, "metallicRoughnessTexture", Slot::metallicRoughness);
    material.normalTexture = texture(source, "normalTexture", Slot::normal);
    material.emissiveTexture = texture(source, "emissiveTexture", Slot::emissive);
    material.transmissionTexture = texture(transmission, "transmissionTexture", Slot::transmission);
    material.normalScale = clamped(number(member(source, "normalTexture"), "scale", 1.0), -1e3f, 1e3f, scene.dropped, kOutOfRange);

    const bool hasMetal = material.metallic > 0.0f;
    if (material.specular == 0.0f && !hasMetal && material.transmission == 0.0f) material.flags |= kMaterialLambert;
    if (material.roughness == 0.0f && material.metallic == 1.0f && material.metallicRoughnessTexture.texture < 0)
        material.flags |= kMaterialMirror;
    readMaterialExtras({member(source, "extras"), "material \"" + text(source, "name") + "\"", scene}, material);
    return material;
}

std::array<TextureRef*, 5> textureRefs(Material& material)
{
    return {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture, &material.emissiveTexture,
            &material.transmissionTexture};
}

// True when the material's textures all read TEXCOORD_1: they read uv0 from now on.
bool moveToFirstUv(Material& material, const std::string& name, Scene& scene)
{
    bool first = false, second = false;
    for (const TextureRef* ref : textureRefs(material))
        if (ref->texture >= 0) (ref->uvSet == 1 ? second : first) = true;
    if (first && second) scene.warnings.push_back("material \"" + name + "\" reads TEXCOORD_0 and TEXCOORD_1, and a bake takes TEXCOORD_1");
    if (first || !second) return false;
    for (TextureRef* ref : textureRefs(material)) ref->uvSet = 0;
    return true;
}

// Maps that change how a surface looks and that nothing here reads.
void tellUnreadMaps(const json& source, Scene& scene)
{
    constexpr const char* kMaps[][2] = {{"KHR_materials_specular", "specularTexture"},
                                        {"KHR_materials_specular", "specularColorTexture"},
                                        {"KHR_materials_volume", "thicknessTexture"},
                                        {"KHR_materials_anisotropy", "anisotropyTexture"}};
    for (const auto& [owner, map] : kMaps)
        if (!member(extension(source, owner), map).is_null())
            scene.warnings.push_back("material \"" + text(source, "name") + "\": its " + map + " is not read");
}
}

Material plaster()
{
    Material material{};
    material.baseColor = vec4(0.8f, 0.8f, 0.8f, 1.0f);
    material.roughness = 1.0f;
    material.ior = 1.5f;
    material.specular = 1.0f;
    material.specularColor = vec3(1.0f);
    material.attenuationColor = vec3(1.0f);
    material.attenuationDistance = kFarthest;
    material.alphaCutoff = 0.5f;
    material.normalScale = 1.0f;
    for (TextureRef* ref : textureRefs(material)) *ref = noTexture();
    return material;
}

std::vector<bool> readMaterials(const Document& document, Scene& scene)
{
    TextureIndex known;
    std::vector<bool> secondUv;
    for (const json& source : listOf(*document.json, "materials")) {
        const std::string name = text(source, "name", "material " + std::to_string(scene.materials.size()));
        scene.materials.push_back(readMaterial(document, source, known, scene));
        scene.materialNames.push_back(name);
        secondUv.push_back(moveToFirstUv(scene.materials.back(), name, scene));
        tellUnreadMaps(source, scene);
    }
    decodeTextures(document, known, scene);
    return secondUv;
}

float lowestRoughness(const Scene& scene, const Material& material)
{
    const int texture = material.metallicRoughnessTexture.texture;
    if (texture < 0) return material.roughness;
    const Image8& image = scene.textures[texture].image;
    std::uint8_t lowest = 255;
    for (std::size_t i = 1; i < image.pixels.size(); i += 4) lowest = std::min(lowest, image.pixels[i]); // g
    return material.roughness * float(lowest) / 255.0f;
}

static bool isMetal(const Scene& scene, const Material& material)
{
    const int texture = material.metallicRoughnessTexture.texture;
    if (texture < 0 || !(material.metallic > 0.0f)) return material.metallic > 0.0f;
    const Image8& image = scene.textures[texture].image;
    for (std::size_t i = 2; i < image.pixels.size(); i += 4) // b
        if (image.pixels[i] > 0) return true;
    return false;
}

bool isGlossy(const Scene& scene, const Material& material)
{
    if ((material.flags & (kMaterialLambert | kMaterialUnlit)) != 0) return false;
    return isMetal(scene, material) || (material.specular > 0.0f && lowestRoughness(scene, material) <= kGlossyRoughness);
}
}
