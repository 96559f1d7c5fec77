#include "engine/scene/needs.hpp"
#include "engine/scene/flats.hpp"
#include "engine/scene/material.hpp"
#include "shaders/reflection.h"
#include <algorithm>
#include <fmt/format.h>

#include "engine/core/error.hpp" // after fmt, which has functions called check

namespace afterglow
{
namespace
{
constexpr std::size_t kLodTriangles = 512; // of a mesh: fewer cost less than a draw call

// What the questions below ask for, gathered once.
struct Census {
    std::size_t triangles = 0, largestMesh = 0;
    std::size_t moving = 0, standing = 0; // objects
    std::size_t suns = 0, spots = 0, points = 0;
    std::size_t baked = 0;                                  // lights that a bake does not ignore
    float sharpest = 2.0f;                                  // lowest roughness of a glossy surface; 2: there is none
    float glossiest = 2.0f;                                 // the same of those that no light passes
    std::string sharpestName, glossiestName, emitter, bent; // materials; bent: of a static object, lit, with a normal map
    bool onlyUnlit = true;
};

std::string nameOf(const Scene& scene, uint material)
{
    return material < scene.materialNames.size() ? "\"" + scene.materialNames[material] + "\"" : "a material";
}

bool reflects(const Material& material) { return (material.flags & (kMaterialLambert | kMaterialUnlit)) == 0; }

void count(Census& census, const Scene& scene, uint index)
{
    const Material& material = scene.materials[index];
    if ((material.flags & kMaterialUnlit) == 0) census.onlyUnlit = false;
    if (material.emission != vec3(0.0f) && census.emitter.empty()) census.emitter = nameOf(scene, index);
    if (!reflects(material)) return;
    const float roughness = lowestRoughness(scene, material);
    if (roughness < census.sharpest && isGlossy(scene, material)) {
        census.sharpest = roughness;
        census.sharpestName = nameOf(scene, index);
    }
    const bool clear = (material.flags & kMaterialAlphaBlend) != 0 || material.transmission > 0.0f;
    const bool mirrors = material.specular > 0.0f || material.metallic > 0.0f;
    if (roughness < census.glossiest && mirrors && !clear) {
        census.glossiest = roughness;
        census.glossiestName = nameOf(scene, index);
    }
}

Census takeCensus(const Scene& scene, bool directAll)
{
    Census census;
    std::vector<bool> used(scene.materials.size(), false);
    for (const Object& object : scene.objects) {
        ++(object.isStatic ? census.standing : census.moving);
        std::size_t triangles = 0;
        for (const Primitive& primitive : scene.meshes[object.mesh].primitives) {
            triangles += primitive.indexCount / 3;
            used[primitive.material] = true;
            if (object.isStatic && census.bent.empty() && isBent(scene.materials[primitive.material]))
                census.bent = nameOf(scene, primitive.material);
        }
        census.triangles += triangles;
        census.largestMesh = std::max(census.largestMesh, triangles);
    }
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) count(census, scene, uint(i));
    for (const Light& light : scene.lights) {
        ++(light.type == kLightDirectional ? census.suns : light.type == kLightSpot ? census.spots : census.points);
        if (light.bake != kBakeNone || directAll) ++census.baked;
    }
    return census;
}

std::string counted(std::size_t count, const char* one, const char* many) { return fmt::format("{} {}", count, count == 1 ? one : many); }

// Where light comes from, or nothing.
std::string lightSource(const Scene& scene, const Census& census)
{
    if (!census.emitter.empty()) return "material " + census.emitter + " emits";
    if (census.baked > 0) return counted(census.baked, "light", "lights") + " to bake";
    if (scene.sky.radiance != vec3(0.0f)) return "the sky shines";
    return "";
}

Need onIf(bool on, const char* effect, std::string because, std::string otherwise)
{
    return {effect, on, std::move(on ? because : otherwise)};
}

Need lightmaps(const Scene& scene, const Census& census)
{
    const std::string source = lightSource(scene, census);
    if (census.standing == 0) return {"lightmaps", false, "no static object"};
    if (census.onlyUnlit) return {"lightmaps", false, "every material is unlit"};
    return onIf(!source.empty(), "lightmaps", counted(census.standing, "static object", "static objects") + ", and " + source,
                "nothing in the level gives light");
}

// Lightmaps that tell normals apart.
Need directional(const Need& lightmaps, const Census& census)
{
    if (!lightmaps.on) return {"directional", false, "no lightmap is called for"};
    return onIf(!census.bent.empty(), "directional", "material " + census.bent + " has a normal map", "no static object has a normal map");
}

Need probes(const Scene& scene, const Census& census)
{
    const std::string source = lightSource(scene, census);
    if (source.empty()) return {"probes", false, "nothing in the level gives light"};
    if (!scene.probeVolumes.empty()) return {"probes", true, "node \"" + scene.probeVolumes.front().name + "\" says ag_probe_volume"};
    if (census.triangles == 0) return {"probes", false, "no triangle"};
    if (census.moving > 0) return {"probes", true, counted(census.moving, "object is", "objects are") + " not static"};
    return {"probes", true, "for what will move through the level"};
}

Need reflectionProbes(const Scene& scene, const Census& census)
{
    if (!scene.reflectionProbes.empty())
        return {"reflections", true, "node \"" + scene.reflectionProbes.front().name + "\" says ag_reflection_probe"};
    return onIf(census.sharpest <= 1.0f, "reflections",
                fmt::format("material {} reflects at roughness {:.3g}", census.sharpestName, census.sharpest),
                fmt::format("no metal, and nothing else down to roughness {:g}", kGlossyRoughness));
}

Need screenReflection(const Census& census)
{
    return onIf(census.glossiest < kScreenRoughness, "reflection",
                fmt::format("material {} has roughness {:.3g}", census.glossiestName, census.glossiest),
                fmt::format("no material below roughness {:.3g}", kScreenRoughness));
}

Need lods(const Census& census)
{
    return onIf(census.largestMesh > kLodTriangles, "lods", fmt::format("a mesh has {} triangles", census.largestMesh),
                fmt::format("no mesh above {} triangles", kLodTriangles));
}

Need shadow(const Census& census)
{
    std::string lights;
    if (census.suns > 0) lights = counted(census.suns, "directional light", "directional lights");
    if (census.spots > 0) lights += (lights.empty() ? "" : " and ") + counted(census.spots, "spot light", "spot lights");
    return onIf(!lights.empty() && census.triangles > 0, "shadow", lights, lights.empty() ? "no directional or spot light" : "no triangle");
}

// Space for those whose surroundings no lightmap tells.
Need voxels(const Census& census)
{
    if (census.standing == 0) return {"voxels", false, "no static object"};
    return onIf(census.moving > 0, "voxels",
                counted(census.moving, "object is", "objects are") + " not static, and what stands around may be out of sight",
                "every object is static: lightmaps hold what hides the light");
}

// Its cost goes by the number of planes: they are told.
Need flat(const char* effect, const std::vector<Flat>& found, const Flats& all, const char* one, const char* many, const char* otherwise)
{
    std::string names;
    for (const Flat& flat : found) names += (names.empty() ? ": \"" : ", \"") + flat.name + "\"";
    if (!found.empty()) return {effect, true, counted(found.size(), one, many) + names};
    for (const auto& [kind, sentence] : all.refused)
        if (kind == (std::string_view(effect) == "portal" ? FlatKind::portal : FlatKind::mirror)) return {effect, false, sentence};
    return {effect, false, otherwise};
}

std::string spoken(vec3 color)
{
    if (color.x == color.y && color.y == color.z) return fmt::format("{:.4g}", color.x);
    return fmt::format("{:.4g} {:.4g} {:.4g}", color.x, color.y, color.z);
}

Need fog(const Scene& scene)
{
    if (scene.media.empty()) return {"fog", false, "no ag_fog_scattering, ag_fog_absorption or ag_fog_emission"};
    const Medium& medium = scene.media.front();
    const bool scatters = medium.scattering != vec3(0.0f), absorbs = medium.absorption != vec3(0.0f);
    const char* key = scatters ? "ag_fog_scattering" : absorbs ? "ag_fog_absorption" : "ag_fog_emission";
    return {"fog", true,
            fmt::format("{} extras say {} {}", medium.wholeLevel != 0 ? "scene" : "a mesh node's", key,
                        spoken(scatters  ? medium.scattering
                               : absorbs ? medium.absorption
                                         : medium.emission))};
}

Need toon(const Scene& scene)
{
    for (const auto& [material, steps] : scene.toonRamps)
        if (!scene.display.toon && !steps.empty()) return {"toon", true, "material " + nameOf(scene, material) + " says ag_toon_ramp"};
    return onIf(scene.display.toon, "toon", "scene extras say ag_style toon", "no ag_style toon and no ag_toon_ramp");
}
}

bool isBent(const Material& material) { return material.normalTexture.texture >= 0 && (material.flags & kMaterialUnlit) == 0; }

std::vector<Need> needs(const Scene& scene, bool directAll)
{
    const Census census = takeCensus(scene, directAll);
    const Flats flats = findFlats(scene);
    const Display& display = scene.display;
    const bool drawn = census.triangles > 0;
    const Need mapped = lightmaps(scene, census);
    return {
        mapped,
        directional(mapped, census),
        probes(scene, census),
        reflectionProbes(scene, census),
        lods(census),
        voxels(census),
        onIf(drawn, "geometry", counted(census.triangles, "triangle", "triangles"), "no triangle"),
        shadow(census),
        onIf(drawn, "lighting", "surfaces are to be lit", "no triangle"),
        screenReflection(census),
        fog(scene),
        onIf(census.moving > 0, "occlusion",
             counted(census.moving, "object is", "objects are") + " not static, so no lightmap holds the contact",
             "every object is static: lightmaps hold it"),
        flat("planar", flats.mirrors, flats, "plane", "planes", "no ag_mirror and no metal of roughness 0"),
        flat("portal", flats.portals, flats, "portal", "portals", "no ag_portal"),
        toon(scene),
        onIf(display.outlinePixels > 0.0f, "outline", fmt::format("scene extras say ag_outline_px {:.3g}", display.outlinePixels),
             "no ag_outline_px"),
        onIf(display.bloom > 0.0f, "bloom", fmt::format("scene extras say ag_bloom {:.3g}", display.bloom), "no ag_bloom"),
        {"display", true, "a picture is shown"},
    };
}

const Need& need(const std::vector<Need>& all, std::string_view effect)
{
    const auto found = std::find_if(all.begin(), all.end(), [&](const Need& need) { return need.effect == effect; });
    check(found != all.end(), "no effect is called " + std::string(effect));
    return *found;
}
}
