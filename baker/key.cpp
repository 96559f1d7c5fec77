#include "baker/key.hpp"
#include "engine/baked/manifest.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/machine.hpp"
#include "shaders/random.h"
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

std::string bakeKey(const std::filesystem::path& level, const BakeOptions& o)
{
    json all = {{"program", AFTERGLOW_VERSION " " + buildId()}, {"name", level.filename().string()}};
    for (const std::filesystem::path& file : filesOf(level)) {
        const bool isThere = std::filesystem::is_regular_file(file);
        const std::vector<std::uint8_t> bytes = isThere ? readFile(file) : std::vector<std::uint8_t>();
        all["files"].push_back(isThere ? sha256(bytes.data(), bytes.size()) : "");
    }
    const auto add = [&](const char* name, const auto& value) { all[name] = value; };
    const auto addAsked = [&](const char* name, const auto& value) {
        if (value) all[name] = *value;
    };
    add("quality", int(o.quality));
    addAsked("texels_per_metre", o.texelsPerMetre);
    addAsked("lightmap_pages", o.lightmapPages);
    addAsked("samples", o.samples);
    addAsked("target_error", o.targetError);
    addAsked("bounces", o.bounces);
    addAsked("probe_spacing", o.probeSpacing);
    addAsked("probe_error", o.probeError);
    addAsked("probe_bytes", o.probeBytes);
    addAsked("probe_noise", o.probeNoise);
    add("probe_order", o.probeOrder);
    add("probe_walls", o.probeWalls);
    addAsked("probe_samples", o.probeSamples);
    addAsked("reflection_size", o.reflectionSize);
    addAsked("reflection_samples", o.reflectionSamples);
    add("seed", o.seed);
    addAsked("directional", o.directional);
    add("direct_all", o.directAll);
    add("products", std::vector<bool>{o.lightmaps, o.probes, o.reflections, o.lods, o.voxels});
    add("exr", o.exr);
    add("denoiser", int(o.denoiser));
    add("stitch", o.stitch);
    addAsked("light_cache", o.lightCache);
    addAsked("time_budget", o.timeBudget);
    add("light_layers", o.lightLayers);
    add("incremental", o.incremental);
    const std::string text = all.dump(-1, ' ', /* ensure_ascii= */ false, json::error_handler_t::replace);
    return sha256(text.data(), text.size());
}

namespace
{
// Text that stands for everything put into it.
struct Digest {
    std::string text;

    template <class T>
    Digest& list(const std::vector<T>& items)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        text += sha256(items.data(), items.size() * sizeof(T)) + ' ';
        return *this;
    }
    template <class... T>
    Digest& values(const T&... all)
    {
        ((text += sha256(&all, sizeof all) + ' '), ...); // each is a number or of numbers, with no gap between
        return *this;
    }
    std::string sum() const { return sha256(text.data(), text.size()); }
    std::uint64_t number() const { return std::max<std::uint64_t>(std::stoull(sum().substr(0, 16), nullptr, 16), 1); }
};
}

static Digest digestOf(const Glow& glow)
{
    Digest light;
    return light.list(glow.lights).list(glow.materials).list(glow.media).values(glow.sky);
}

LayerKeys::LayerKeys(const Scene& scene, const Atlas& atlas, const Solids& solids, const BakeOptions& o, bool directional) : scene_(scene)
{
    std::vector<Material> materials = scene.materials;
    for (Material& material : materials) material.emission = vec3(0.0f);
    std::vector<Medium> media = scene.media;
    for (Medium& medium : media) medium.emission = vec3(0.0f);
    Digest all{"program " AFTERGLOW_VERSION " " + buildId() + " "};
    all.list(scene.vertices).list(scene.indices).list(materials).list(media).list(scene.mediumPlanes).list(atlas.pageSizes);
    for (const SceneTexture& texture : scene.textures)
        all.list(texture.image.pixels)
            .values(texture.image.width, texture.image.height, texture.srgb, texture.wrapU, texture.wrapV, texture.nearest);
    for (const Mesh& mesh : scene.meshes) all.list(mesh.primitives);
    for (const Object& object : scene.objects) all.values(object.mesh, object.isStatic);
    for (const LightmapPlace& place : atlas.places) all.values(place.page, place.scale, place.offset);
    all.values(o.targetError ? 0 : *o.samples, o.targetError.value_or(0.0f), *o.bounces, o.seed, o.directAll, directional, o.lightLayers,
               o.incremental);
    family_ = all.sum();
    for (const Object& object : scene.objects)
        if (object.isStatic) all.values(object.toWorld); // others take no part
    for (bool solid : solids.byObject()) all.values(solid);
    level_ = all.sum();
    if (!o.incremental) family_ = level_;
}

LayerKey LayerKeys::of(const Glow& glow) const
{
    Digest light = digestOf(glow);
    if (glow.sky != vec3(0.0f)) light.list(scene_.sky.image.pixels).values(scene_.sky.image.width, scene_.sky.rotation);
    return {Digest{level_ + light.text}.number(), Digest{family_ + light.text}.number()};
}

std::uint32_t layerSeed(const Glow& glow, std::uint32_t seed) { return hash2(seed, std::uint32_t(digestOf(glow).number())); }

bool holdsBake(const std::filesystem::path& directory, const std::string& key)
try {
    const json manifest = readManifest(directory);
    if (!manifest.contains("key") || manifest["key"] != key) return false;
    const std::optional<std::set<std::string>> files = ownFiles(directory);
    if (!files) return false;
    for (const std::string& name : *files) readBakedFile(manifest, directory, name); // throws unless it is whole
    return true;
} catch (const Error&) {
    return false;
}
}
