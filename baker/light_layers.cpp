#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "baker/light_layers.hpp"
#include "engine/core/log.hpp"
#include <algorithm>
#include <cstring>

namespace afterglow
{
Glow glowOf(const Scene& scene)
{
    Glow glow{scene.lights, {}, {}, scene.sky.radiance};
    for (const Material& material : scene.materials) glow.materials.push_back(material.emission);
    for (const Medium& medium : scene.media) glow.media.push_back(medium.emission);
    return glow;
}

void setGlow(Scene& scene, const Glow& glow)
{
    scene.lights = glow.lights;
    scene.sky.radiance = glow.sky;
    for (std::size_t i = 0; i < glow.materials.size(); i++) scene.materials[i].emission = glow.materials[i];
    for (std::size_t i = 0; i < glow.media.size(); i++) scene.media[i].emission = glow.media[i];
}

static vec3 white(vec3 emission) { return emission == vec3(0.0f) ? emission : vec3(1.0f); }

Glow white(Glow glow)
{
    for (Light& light : glow.lights) light.intensity = white(light.intensity);
    for (std::vector<vec3>* emissions : {&glow.materials, &glow.media})
        for (vec3& emission : *emissions) emission = white(emission);
    glow.sky = white(glow.sky);
    return glow;
}

// Of a level of the same materials and media.
static Glow darkAs(const Glow& glow)
{
    return {{}, std::vector<vec3>(glow.materials.size(), vec3(0.0f)), std::vector<vec3>(glow.media.size(), vec3(0.0f))};
}

static std::string named(const char* kind, const std::vector<std::string>& names, std::size_t i)
{
    return i < names.size() && !names[i].empty() ? fmt::format("{} \"{}\"", kind, names[i]) : fmt::format("{} {}", kind, i);
}

// Of materials that some static object has.
static std::vector<bool> standing(const Scene& scene)
{
    std::vector<bool> used(scene.materials.size(), false);
    for (const Object& object : scene.objects)
        for (const Primitive& primitive : scene.meshes[object.mesh].primitives)
            used[primitive.material] = used[primitive.material] || object.isStatic;
    return used;
}

// What is beyond the bound shines together, as bright as it is: it has one strength no more.
static void bound(std::vector<LightLayer>& layers)
{
    if (layers.size() <= kMostLayers) return;
    const std::size_t apart = kMostLayers - 1, others = layers.size() - apart;
    note(
        fmt::format("of {} lights the first {} are kept apart, and the others together: where one of those changes, all of them are traced",
                    layers.size(), apart));
    LightLayer rest{.name = fmt::format("{} lights", others), .glow = darkAs(layers[apart].glow)};
    for (std::size_t l = apart; l < layers.size(); l++) {
        const vec3 strength = layers[l].strength;
        const Glow& glow = layers[l].glow;
        for (Light light : glow.lights) {
            light.intensity *= strength;
            rest.glow.lights.push_back(light);
        }
        for (std::size_t m = 0; m < glow.materials.size(); m++) rest.glow.materials[m] += glow.materials[m] * strength;
        for (std::size_t m = 0; m < glow.media.size(); m++) rest.glow.media[m] += glow.media[m] * strength;
        rest.glow.sky += glow.sky * strength;
    }
    layers.resize(apart);
    layers.push_back(std::move(rest));
}

std::vector<LightLayer> lightLayers(const Scene& scene, bool directAll)
{
    const Glow own = glowOf(scene), dark = darkAs(own);
    std::vector<LightLayer> layers;
    const auto add = [&](const std::string& name, vec3 strength) -> Glow& {
        return layers.emplace_back(LightLayer{.name = name, .glow = dark, .strength = strength}).glow;
    };
    for (std::size_t i = 0; i < own.lights.size(); i++) {
        Light light = own.lights[i];
        if (light.bake == kBakeNone && !directAll) continue;
        light.intensity = vec3(1.0f);
        const std::string name = named("light", scene.lightNames, i);
        const auto twin = std::find_if(layers.begin(), layers.end(),
                                       [&](const LightLayer& l) { return std::memcmp(&l.glow.lights[0], &light, sizeof light) == 0; });
        if (twin == layers.end())
            add(name, own.lights[i].intensity).lights = {light};
        else
            twin->strength += own.lights[i].intensity, twin->name += ", " + name;
    }
    const std::vector<bool> used = standing(scene);
    for (std::size_t i = 0; i < own.materials.size(); i++)
        if (used[i] && own.materials[i] != vec3(0.0f))
            add(named("material", scene.materialNames, i), own.materials[i]).materials[i] = vec3(1.0f);
    for (std::size_t i = 0; i < own.media.size(); i++)
        if (own.media[i] != vec3(0.0f)) add(named("medium", {}, i), own.media[i]).media[i] = vec3(1.0f);
    if (own.sky != vec3(0.0f)) add("sky", own.sky).sky = vec3(1.0f);
    bound(layers);
    if (layers.empty()) add("nothing", vec3(1.0f));
    return layers;
}

BakedLights bakedLights(const std::vector<Light>& lights, bool directAll)
{
    BakedLights baked;
    for (const Light& light : lights) {
        if (light.bake != kBakeNone || directAll) baked.seen.push_back(light);
        if (light.bake == kBakeAll || directAll) baked.direct.push_back(light);
    }
    return baked;
}

std::size_t layerCount(const BakeContext& whole) { return whole.layers ? whole.layers->all.size() : 1; }

void eachLayer(BakeContext& whole, const LayerStage& stage)
{
    if (!whole.layers) return stage(whole, vec3(1.0f));
    Scene& scene = whole.layers->scene;
    const Glow own = glowOf(scene);
    for (const LightLayer& layer : whole.layers->all) {
        setGlow(scene, layer.glow);
        const BakedLights lights = bakedLights(layer.glow.lights, whole.layers->directAll);
        LightTransport transport(whole.transport.world, lights.seen);
        if (!transport.sky.shines()) transport.sky.leaveUnsampled();
        transport.limits.rouletteFrom = whole.transport.limits.rouletteFrom;
        transport.limits.maxBounces = whole.transport.limits.maxBounces;
        BakeContext context(transport, whole.solids, lights.direct, whole.progress);
        context.seed = layer.seed;
        context.threads = whole.threads;
        context.directional = whole.directional;
        context.journal = whole.journal;
        context.streamed = whole.streamed;
        context.layer = layer.key;
        context.earlier = whole.earlier;
        stage(context, layer.strength);
        whole.count(context.rays());
    }
    setGlow(scene, own);
}
}
