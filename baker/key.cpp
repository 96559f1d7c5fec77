#include "baker/key.hpp"
#include "engine/baked/manifest.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/machine.hpp"
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
    addAsked("time_budget", o.timeBudget);
    const std::string text = all.dump(-1, ' ', /* ensure_ascii= */ false, json::error_handler_t::replace);
    return sha256(text.data(), text.size());
}

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
