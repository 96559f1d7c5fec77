// From a level's file to its baked folder, complete or not at all.
#include "baker/baker.hpp"
#include "baker/journal.hpp"
#include "baker/key.hpp"
#include "baker/pace.hpp"
#include "engine/baked/manifest.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/log.hpp"
#include "engine/core/machine.hpp"
#include "engine/core/scaffold.hpp"
#include <algorithm>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

// The bake takes the whole folder's place: its level must not be lost with it.
static void refuseInside(const std::filesystem::path& level, const std::filesystem::path& place)
{
    const std::filesystem::path from = placeOf(level);
    if (std::mismatch(place.begin(), place.end(), from.begin(), from.end()).first == place.end())
        throw Error("the level " + level.string() + " lies in the output " + place.string() +
                        ", which the bake replaces; name another folder",
                    Exit::usage);
}

// A slip of the output's name is told before the bake of another level is gone.
static void tellReplaced(const std::filesystem::path& level, const std::filesystem::path& place)
try {
    const json manifest = readManifest(place);
    if (!manifest.contains("level") || !manifest["level"].is_object() || !manifest["level"].contains("path")) return;
    const json& former = manifest["level"]["path"];
    if (former.is_string() && former != level.filename().string())
        note(place.string() + " holds a bake of " + former.get<std::string>() + ", which this one replaces when it is done");
} catch (const Error&) { // there is none
}

// What a bake keeps for the next one of its level, beside its folder: no other program needs it.
static std::filesystem::path leftBy(const std::filesystem::path& directory) { return bakedPlace(directory).string() + ".kept"; }

// What an earlier process chose stays chosen, whatever the clock would say now.
static BakeOptions pacedOnce(const Scene& scene, const BakeOptions& asked, Progress& progress, json& manifest, Journal& journal)
{
    json& told = manifest["time_budget"];
    BakeOptions kept = asked;
    if (const std::optional<Done> done = journal.recall({Job::pace})) {
        const json said = json::parse(done->bytes);
        told = said["told"];
        kept.quality = said["quality"], kept.samples = said["samples"], kept.texelsPerMetre = said["texels_per_metre"];
        return resolved(kept, scene);
    }
    kept = paced(scene, asked, *asked.timeBudget, progress, manifest);
    const std::string said =
        json{{"told", told}, {"quality", kept.quality}, {"samples", *kept.samples}, {"texels_per_metre", *kept.texelsPerMetre}}.dump();
    journal.keep({Job::pace}, {reinterpret_cast<const std::uint8_t*>(said.data()), said.size()}, {});
    return kept;
}

static void bakeLevel(const std::filesystem::path& level, const std::filesystem::path& directory, const BakeOptions& options,
                      Progress& progress, Journal& journal, json manifest)
{
    std::vector<std::uint8_t> bytes = readFile(level);
    manifest["level"] = {{"path", level.filename().string()}, {"sha256", sha256(bytes.data(), bytes.size())}};
    Scene scene = loadLevel(level);
    if (const std::string line = droppedText(scene); !line.empty()) note(line);
    if (scene.objects.empty()) scene.warnings.push_back("the level draws nothing");
    for (const std::string& line : scene.warnings) warning(line);
    const double unpaced = journal.spent().seconds - journal.before(Job::pace).seconds;
    const BakeOptions kept = options.timeBudget ? pacedOnce(scene, options, progress, manifest, journal) : options;
    const double paced = journal.spent().seconds - unpaced; // trials of a time budget, whose rays are not counted
    const std::filesystem::path left = options.keeps() ? leftBy(directory) : std::filesystem::path();
    const std::unique_ptr<const Journal> earlier = std::filesystem::exists(left) ? std::make_unique<const Journal>(left) : nullptr;
    const Baked baked = bakeScene(std::move(scene), kept, progress, manifest, &journal, earlier.get());

    const Spent spent = journal.spent();
    manifest["memory"]["peak_bytes"] = memoryPeak();
    manifest["seconds"] = spent.seconds;
    manifest["cpu_seconds"] = spent.cpuSeconds;
    manifest["rays_per_second"] = manifest["rays"].get<double>() / std::max(spent.seconds - paced, 1e-9);
    progress.begin("writing", packedFiles(baked, options.exr), "files");
    writeBaked(directory, baked, manifest, options.exr, [&](std::uint64_t units) { progress.advance(units); });
    journal.finish(left);
    progress.end();
}

void bakeLevel(const std::filesystem::path& level, const std::filesystem::path& directory, const BakeOptions& options, Progress& progress)
{
    const std::filesystem::path place = bakedPlace(directory);
    refuseInside(level, place);
    requireWritableFolder(directory);
    const std::string key = bakeKey(level, options);
    if (!options.force && holdsBake(place, key))
        return note(place.string() + " is this bake already, of the same level and options: nothing is done; --force bakes it again");
    tellReplaced(level, place);
    Journal journal(place, key, options.resume ? Journal::Start::resume : Journal::Start::afresh);
    try {
        bakeLevel(level, directory, options, progress, journal, {{"key", key}});
    } catch (const Error& error) {
        if (!journal.resumable()) throw;
        const std::string kept = "what was done is kept in " + place.string() + ".journal; ";
        if (error.exit == Exit::interrupted)
            throw Error("interrupted: " + kept + "the same command with --resume goes on from there", Exit::interrupted);
        note(kept + "the same command with --resume, and more --max-memory where that was too little, goes on from there");
        throw;
    }
}
}
