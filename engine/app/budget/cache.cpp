#include "engine/app/budget/cache.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/log.hpp"
#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

namespace
{
constexpr int kSchema = 1; // of the files and of how they are measured

std::filesystem::path fileOf(const std::string& key, const char* ending)
{
    return cacheFolder() / ("budget-" + sha256(key.data(), key.size()).substr(0, 16) + ending);
}

// Of a bake what it says of itself; of a level the file, and what it names beside itself: a .gltf keeps its shapes and pictures elsewhere.
std::string hashOf(const Sitter& sitter)
{
    const bool baked = std::filesystem::is_directory(sitter.path);
    const std::vector<std::uint8_t> bytes = readFile(baked ? sitter.path / "bake.json" : sitter.path);
    std::string all = sha256(bytes.data(), bytes.size());
    if (baked) return all;
    const auto add = [&](const auto& elements) { all += sha256(elements.data(), elements.size() * sizeof(elements[0])); };
    const Scene& scene = sitter.target.scene();
    add(scene.vertices), add(scene.indices), add(scene.sky.image.pixels);
    for (const SceneTexture& texture : scene.textures) add(texture.image.pixels);
    return sha256(all.data(), all.size());
}

std::vector<float> elements(const Camera& c)
{
    std::vector<float> all(&c.toWorld[0][0], &c.toWorld[0][0] + 16);
    all.insert(all.end(), {c.fovY, c.orthoHeight, c.nearPlane});
    return all;
}
}

std::string keyOf(const Sitter& sitter, const std::vector<Group>& offered)
{
    const Settings& s = sitter.setup.settings;
    json names;
    for (const Group& group : offered)
        for (const Option& option : group.options) names[group.effect].push_back(option.name);
    return json{{"schema", kSchema},
                {"version", AFTERGLOW_VERSION},
                {"device", {sitter.executor.gpu.device.deviceName, sitter.executor.gpu.device.driverVersion}},
                {"level", hashOf(sitter)},
                {"camera", elements(sitter.setup.truth.camera)},
                {"size", {s.size.x, s.size.y}},
                {"base", int(s.effects.base)},
                {"forced", s.effects.forced},
                {"methods", {int(s.shadowMethod), int(s.occlusionMethod), int(s.reflectionMethod)}},
                {"knobs", {s.renderScale, s.lodError, s.occlusion.range, s.fog.steps, s.fog.divisor, s.portal.depth, s.outline.kinds}},
                {"style", {s.toon.everyone, s.toon.steps, s.outline.width}},
                {"offered", names}}
        .dump();
}

std::filesystem::path cacheFolder()
{
    for (const auto& [variable, below] : {std::pair("XDG_CACHE_HOME", ""), std::pair("HOME", ".cache")})
        if (const char* folder = std::getenv(variable); folder && std::filesystem::path(folder).is_absolute())
            return std::filesystem::path(folder) / below / "afterglow";
    return {};
}

std::optional<Curves> recall(const std::string& key, const std::vector<Group>& offered)
{
    try {
        if (cacheFolder().empty()) return {};
        const json kept = json::parse(readText(fileOf(key, ".json")));
        if (kept.at("key") != key) return {};
        Curves curves;
        curves.ms = kept.at("ms"), curves.error = kept.at("error"), curves.skipped = kept.at("skipped");
        curves.truth = truthOf(readImage(fileOf(key, "-a.exr")), readImage(fileOf(key, "-b.exr")));
        for (const Group& group : offered) {
            Group priced{group.effect, {group.options.front()}};
            for (const json& row : kept.at("options").at(group.effect)) {
                const auto same = std::find_if(group.options.begin(), group.options.end(),
                                               [&](const Option& option) { return option.name == row.at("name"); });
                if (same == group.options.end()) return {};
                priced.options.push_back(*same);
                priced.options.back().price = {row.at("ms"), row.at("error")};
            }
            curves.groups.push_back(std::move(priced));
        }
        return curves;
    } catch (const json::exception&) {
        return {};
    } catch (const Error&) {
        return {};
    }
}

void remember(const std::string& key, const Curves& curves)
{
    if (cacheFolder().empty()) return;
    json kept = {{"key", key}, {"ms", curves.ms}, {"error", curves.error}, {"skipped", curves.skipped}, {"options", json::object()}};
    for (const Group& group : curves.groups) {
        json& rows = kept["options"][group.effect] = json::array();
        for (std::size_t i = 1; i < group.options.size(); ++i)
            rows.push_back({{"name", group.options[i].name}, {"ms", group.options[i].price.ms}, {"error", group.options[i].price.error}});
    }
    try {
        writeExr(fileOf(key, "-a.exr"), curves.truth.a);
        writeExr(fileOf(key, "-b.exr"), curves.truth.b);
        writeText(fileOf(key, ".json"), kept.dump(1) + "\n"); // the last: it says that all is there
    } catch (const Error& error) {
        note(std::string("what was measured is not kept: ") + error.what());
    }
}
}
