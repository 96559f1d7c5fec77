// The path tracer against levels that carry their own answer: content/truth/*.glb says in its extras (ag_truth) what must come out, and why.
#include "baker/baker.hpp"
#include "engine/core/file.hpp"
#include <cstring>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

static const std::filesystem::path kFolder = "content/truth";

static std::vector<std::string> levels()
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder))
        if (entry.path().extension() == ".glb") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

// The first scene's ag_truth, from the JSON chunk of a .glb.
static json statedTruth(const std::filesystem::path& path)
{
    std::vector<std::uint8_t> bytes = readFile(path);
    std::uint32_t length = 0;
    std::memcpy(&length, &bytes[12], 4);
    return json::parse(bytes.begin() + 20, bytes.begin() + 20 + length)["scenes"][0]["extras"]["ag_truth"];
}

class StatedTruth : public testing::TestWithParam<std::string>
{
};

// Four standard errors of the estimate, and what the level itself says of its own accuracy.
static void expectAgrees(vec3 mean, vec3 standardError, const json& row)
{
    for (int c = 0; c < 3; c++) {
        float value = row["value"][std::size_t(c)];
        float bound = row["relative_tolerance"].get<float>() * abs(value) + 4.0f * standardError[c];
        EXPECT_NEAR(mean[c], value, bound) << row["derivation"] << " channel " << c << ", standard error " << standardError[c];
    }
}

TEST_P(StatedTruth, isMetByThePathTracer)
{
    std::filesystem::path path = kFolder / (GetParam() + ".glb");
    Scene scene = loadLevel(path);
    Progress silent(ProgressStyle::none);
    for (const json& row : statedTruth(path)) {
        if (row["quantity"] == "irradiance") {
            ProbePoint point;
            for (int c = 0; c < 3; c++) point.position[c] = row["position"][std::size_t(c)];
            vec3 normal;
            for (int c = 0; c < 3; c++) normal[c] = row["normal"][std::size_t(c)];
            point.normal = normal;
            PointIrradiance found = probeTruth(scene, {point}, 16384, 3, 0)[0];
            expectAgrees(found.value[0], found.error[0], row);
            continue;
        }
        TruthOptions options;
        options.camera = findCamera(scene, row["camera"]);
        options.size = ivec2(16, 16);
        options.samples = 64;
        options.bounces = 256; // the furnaces end by roulette, not by the cut
        Image image = truth(scene, options, silent);
        dvec3 sum(0.0), squares(0.0);
        for (int i = 0; i < 256; i++) {
            dvec3 pixel(image.pixels[std::size_t(i) * 3], image.pixels[std::size_t(i) * 3 + 1], image.pixels[std::size_t(i) * 3 + 2]);
            sum += pixel;
            squares += pixel * pixel;
        }
        dvec3 mean = sum / 256.0;
        expectAgrees(vec3(mean), vec3(sqrt(max(squares / 256.0 - mean * mean, dvec3(0.0)) / 255.0)), row);
    }
}

INSTANTIATE_TEST_SUITE_P(Levels, StatedTruth, testing::ValuesIn(levels()), [](const auto& info) { return info.param; });
}
