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
constexpr int kSchema = 3; // of the files and of how they are measured

std::filesystem::path fileOf(const std::string& key, const char* ending)
{
    return cacheFolder() / ("budget-" + sha256(key.data(), key.size()).substr(0, 16) + ending);
}

// Whatever is written; false when it cannot be.
template <class Work>
bool written(Work write)
{
    if (cacheFolder().empty()) return false;
    try {
        write();
        return true;
    } catch (const Error& error) {
        note(std::string("what was measured is not kept: ") + error.what());
        return false;
    }
}

// Whatever is read; nothing when it is not there or damaged.
template <class Work>
auto readAgain(Work read) -> std::optional<decltype(read())>
{
    try {
        if (!cacheFolder().empty()) return read();
    } catch (const json::exception&) {
    } catch (const Error&) {
    }
    return {};
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

json sightOf(const Sitter& sitter)
{
    const uvec2 size = smallSize(sitter.settings.size);
    return {{"schema", kSchema},        {"version", AFTERGLOW_VERSION},
            {"level", hashOf(sitter)},  {"camera", elements(sitter.camera)},
            {"size", {size.x, size.y}}, {"portals", sitter.settings.portal.depth}};
}
}

std::string truthKeyOf(const Sitter& sitter) { return sightOf(sitter).dump(); }

std::string keyOf(const Sitter& sitter)
{
    const Settings& s = sitter.settings;
    json key = sightOf(sitter);
    key["device"] = {sitter.executor.gpu.device.deviceName, sitter.executor.gpu.device.driverVersion};
    key["base"] = int(s.effects.base), key["forced"] = s.effects.forced;
    key["methods"] = {int(s.shadowMethod), int(s.occlusionMethod), int(s.reflectionMethod)};
    key["knobs"] = {s.renderScale, s.lodError, s.occlusion.range, s.fog.steps, s.fog.divisor, s.outline.kinds};
    key["style"] = {s.toon.everyone, s.toon.steps, s.outline.width};
    return key.dump();
}

std::filesystem::path cacheFolder()
{
    for (const auto& [variable, below] : {std::pair("XDG_CACHE_HOME", ""), std::pair("HOME", ".cache")})
        if (const char* folder = std::getenv(variable); folder && std::filesystem::path(folder).is_absolute())
            return std::filesystem::path(folder) / below / "afterglow";
    return {};
}

std::optional<Measured> recall(const std::string& key)
{
    return readAgain([&] {
        const json kept = json::parse(readText(fileOf(key, ".json")));
        if (kept.at("key") != key) throw Error("of another key");
        Measured measured{.error = kept.at("error")};
        for (const json& row : kept.at("scales")) measured.scales[row.at("scale")] = row.at("error");
        for (const auto& [effect, options] : kept.at("options").items())
            for (const auto& [name, change] : options.items())
                measured.changes[effect][name] = {change.at("error"), change.at("times"), change.at("added")};
        return measured;
    });
}

std::optional<Truth> recallTruth(const std::string& key)
{
    return readAgain([&] { return truthOf(readImage(fileOf(key, "-a.exr")), readImage(fileOf(key, "-b.exr"))); });
}

bool remember(const std::string& key, const Measured& measured)
{
    json kept = {{"key", key}, {"error", measured.error}, {"scales", json::array()}, {"options", json::object()}};
    for (const auto& [scale, error] : measured.scales) kept["scales"].push_back({{"scale", scale}, {"error", error}});
    for (const auto& [effect, options] : measured.changes)
        for (const auto& [name, change] : options)
            kept["options"][effect][name] = {{"error", change.error}, {"times", change.times}, {"added", change.added}};
    return written([&] { writeText(fileOf(key, ".json"), kept.dump(1) + "\n"); });
}

bool rememberTruth(const std::string& key, const Truth& truth)
{
    return written([&] {
        writeLayers(fileOf(key, "-a.exr"), {{.image = truth.a, .exact = true}});
        writeLayers(fileOf(key, "-b.exr"), {{.image = truth.b, .exact = true}});
    });
}
}
