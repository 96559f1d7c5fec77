// What a bake costs: whole, product by product, and on two threads against one.
#include "bench/bench.hpp"
#include "bench/child.hpp"
#include "engine/core/file.hpp"
#include <algorithm>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

// The time of lightmaps is in proportion to their paths, and their memory does not know of them: a part of the paths tells both.
constexpr int kPart = 4;

static json bakeAndRead(const BenchOptions& options, const std::filesystem::path& directory, BakeOptions bake)
{
    bake.force = true; // two bakes of one level are to be compared, not spared
    return inChild([&] {
        Progress progress(ProgressStyle::automatic);
        bakeLevel(options.level, directory, bake, progress);
        return json::parse(readText(directory / "bake.json"));
    });
}

json benchBake(const BenchOptions& options, const std::filesystem::path& directory)
{
    BakeOptions bake;
    bake.quality = options.quick ? Quality::draft : Quality::medium;
    bake.threads = options.threads;
    const int samples = samplesOf(bake.quality), fewer = samples / kPart;
    const bool part = !options.quick && !options.full;
    if (part) bake.samples = fewer;
    const json manifest = bakeAndRead(options, directory, bake);
    json result = {{"quality", manifest["options"]["quality"]}, {"samples", manifest["options"]["samples"]}};
    for (const char* key : {"seconds", "cpu_seconds", "rays", "threads", "products", "process"}) result[key] = manifest[key];
    if (part && result["products"].contains("lightmaps")) {
        result["projected"] = {{"samples", samples}};
        for (const char* key : {"seconds", "cpu_seconds"}) {
            const double lightmaps = result["products"]["lightmaps"][key];
            result["projected"][key] = result[key].get<double>() + lightmaps * (double(samples) / fewer - 1.0);
        }
    }
    return result;
}

// Both bakes of a pair run one right after the other, so that whatever else the machine does weighs on both.
json benchThreads(const BenchOptions& options, const std::filesystem::path& directory)
{
    constexpr int kTrial = 4;        // paths per texel of a bake that only tells how large the others may be
    constexpr double kSeconds = 3.0; // of the processor, for one bake
    const int pairs = options.quick ? 3 : 5;
    BakeOptions bake;
    bake.quality = Quality::draft;
    bake.samples = kTrial;
    bake.threads = 1;
    bake.probes = bake.reflections = bake.lods = false;

    const json trial = bakeAndRead(options, directory, bake)["products"].value("lightmaps", json::object());
    if (!(trial.value("cpu_seconds", 0.0) > 0.0)) return {{"missing", "the level has no lightmaps to share out"}};
    bake.samples = std::clamp(int(kTrial * kSeconds / trial["cpu_seconds"].get<double>()), 1, 1024);

    json rows = json::array();
    std::vector<double> speedups, growths, cores;
    for (int i = 0; i < pairs; ++i) {
        json row;
        for (int threads : {1, 2}) {
            bake.threads = threads;
            const json product = bakeAndRead(options, directory, bake)["products"]["lightmaps"];
            row["seconds"].push_back(product["seconds"]);
            row["cpu_seconds"].push_back(product["cpu_seconds"]);
        }
        speedups.push_back(row["seconds"][0].get<double>() / row["seconds"][1].get<double>());
        growths.push_back(row["cpu_seconds"][1].get<double>() / row["cpu_seconds"][0].get<double>());
        cores.push_back(row["cpu_seconds"][1].get<double>() / row["seconds"][1].get<double>());
        rows.push_back(row);
    }
    return {{"pairs", rows},
            {"samples", *bake.samples},
            {"speedup", median(speedups)},
            {"cpu_growth", median(growths)},
            {"cores", median(cores)}};
}
}
