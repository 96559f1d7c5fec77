// What a bake is reckoned to take, held against bakes: how much there is to do, and what that costs beside the rest of the same bake.
// Seconds of clocks are nobody's promise; those of the processor, of one stage to another's, are.
#include "baker/reckon.hpp"
#include "baker/stages.hpp"
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

namespace afterglow
{
// How far a level's work may lie from what levels are reckoned to be like, as a factor. Of content/ paths of a lightmap cost up to 1.3
// times as much or as little, those of probes twice; so many probes of a level's size there are by four times more or fewer.
static constexpr double kOneCost = 3.0, kManyProbes = 5.0;

struct Stages {
    std::map<std::string, double> units; // of each stage that was
    nlohmann::json products;
};

static Stages baked(const Scene& scene, const BakeOptions& options)
{
    testing::internal::CaptureStderr();
    Progress progress(ProgressStyle::json);
    nlohmann::json manifest;
    bakeScene(scene, options, progress, manifest);
    Stages stages{{}, manifest["products"]};
    std::istringstream lines(testing::internal::GetCapturedStderr());
    for (std::string line; std::getline(lines, line);)
        if (const nlohmann::json said = nlohmann::json::parse(line, nullptr, /* allow_exceptions= */ false); said.is_object())
            stages.units[said["stage"]] = said["total"];
    return stages;
}

// Each product's seconds of the processor against those reckoned for what its stages turned out to have to do; over all products 1.
static void expectReckoned(const char* level, BakeOptions options)
{
    options.lods = options.voxels = false;
    options.threads = 1;
    const Scene scene = loadLevel(std::string("content/") + level);
    const Stages stages = baked(scene, options);
    BakeOptions made = resolved(options, scene);
    for (auto [asked, product] : {std::pair(&made.lightmaps, "lightmaps"), {&made.probes, "probes"}, {&made.reflections, "reflections"}})
        *asked = stages.products.contains(product);
    std::map<std::string, double> reckonedOf;
    std::map<std::string, std::string> productOf = {
        {"denoise", "lightmaps"}, {"light", "probes"}, {"places", "reflections"}, {"prefilter", "reflections"}};
    std::map<std::string, double> units;
    for (StageForecast stage : reckoned(scene, made, staticArea(scene))) {
        units[stage.name] = stage.units;
        if (!stages.units.contains(stage.name)) continue;
        expect(stage, stages.units.at(stage.name));
        reckonedOf[productOf.contains(stage.name) ? productOf[stage.name] : stage.name] += stage.units * stage.cost;
    }
    for (const auto& [stage, count] : stages.units) EXPECT_TRUE(units.contains(stage)) << level << ": nobody reckoned with " << stage;
    const char* texels = made.lightmaps ? "lightmaps" : "light";
    EXPECT_NEAR(std::log(stages.units.at(texels) / units[texels]), 0.0, std::log(1.5)) << level;
    EXPECT_NEAR(std::log(stages.units.at("probes") / units["probes"]), 0.0, std::log(kManyProbes)) << level;

    double seconds = 0.0, all = 0.0;
    for (const auto& [product, row] : stages.products.items()) seconds += row.value("cpu_seconds", 0.0), all += reckonedOf[product];
    for (const auto& [product, row] : stages.products.items()) {
        const double slowness = row.value("cpu_seconds", 0.0) / reckonedOf[product];
        std::printf("| %s | %s | %.2f s | %.2f |\n", level, product.c_str(), row.value("cpu_seconds", 0.0), slowness * all / seconds);
        EXPECT_NEAR(std::log(slowness * all / seconds), 0.0, std::log(kOneCost)) << level << ", " << product;
    }
}

// Lightmaps, probes that are few and have few paths, and reflection probes that look for their places.
TEST(Reckoned, weighsTheStagesOfADraft) { expectReckoned("hanging_cube/hanging_cube.glb", {.quality = Quality::draft}); }

// Probes alone, whose cache is filled for them.
TEST(Reckoned, weighsProbesThatFillALightCache)
{
    BakeOptions options;
    options.lightmaps = options.reflections = false;
    options.probeError = 0.2f;
    expectReckoned("cornell/cornell.glb", options);
}

// A light cache halves what the paths of probes cost, and little of those of lightmaps.
TEST(Reckoned, weighsManyPathsWithALightCacheAndWithout)
{
    for (const bool caches : {true, false})
        for (const auto& [level, density] : {std::pair("cornell/cornell.glb", 30.0f), {"two_rooms/two_rooms_closed.glb", 6.0f}}) {
            BakeOptions options;
            options.texelsPerMetre = density;
            options.lightCache = caches;
            options.reflections = false;
            options.probeError = 0.2f;
            expectReckoned(level, options);
        }
}
}
