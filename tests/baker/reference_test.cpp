// The path tracer against levels that carry their own answer: content/truth/*.glb says in its extras (ag_truth) what must come out, and why.
#include "baker/baker.hpp"
#include "engine/core/file.hpp"
#include "tests/engine/upload/toy_level.hpp"
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

// Mean of a small picture, and its standard error from the spread of the pixels.
struct MeanRadiance {
    vec3 value, error;
};
static MeanRadiance meanRadiance(const Scene& scene, TruthOptions options)
{
    Progress silent(ProgressStyle::none);
    options.size = ivec2(16, 16);
    Image image = truth(scene, options, silent);
    dvec3 sum(0.0), squares(0.0);
    for (int i = 0; i < 256; i++) {
        dvec3 pixel(image.pixels[std::size_t(i) * 3], image.pixels[std::size_t(i) * 3 + 1], image.pixels[std::size_t(i) * 3 + 2]);
        sum += pixel;
        squares += pixel * pixel;
    }
    dvec3 mean = sum / 256.0;
    return {vec3(mean), vec3(sqrt(max(squares / 256.0 - mean * mean, dvec3(0.0)) / 255.0))};
}

TEST_P(StatedTruth, isMetByThePathTracer)
{
    std::filesystem::path path = kFolder / (GetParam() + ".glb");
    Scene scene = loadLevel(path);
    for (const json& row : statedTruth(path)) {
        if (row["quantity"] == "irradiance") {
            ProbePoint point;
            for (int c = 0; c < 3; c++) point.position[c] = row["position"][std::size_t(c)];
            vec3 normal;
            for (int c = 0; c < 3; c++) normal[c] = row["normal"][std::size_t(c)];
            point.normal = normal;
            Progress silent(ProgressStyle::none);
            PointIrradiance found = probeTruth(scene, {point}, 16384, 3, 0, silent)[0];
            expectAgrees(found.value[0], found.error[0], row);
            continue;
        }
        TruthOptions options;
        options.camera = findCamera(scene, row["camera"]);
        options.samples = 64;
        options.bounces = 256; // the furnaces end by roulette, not by the cut
        MeanRadiance found = meanRadiance(scene, options);
        expectAgrees(found.value, found.error, row);
    }
}

INSTANTIATE_TEST_SUITE_P(Levels, StatedTruth, testing::ValuesIn(levels()), [](const auto& info) { return info.param; });

// A furnace whose paths are cut: Le (1 - rho^(n + 1)) / (1 - rho) after n reflections, Le / (1 - rho) without an end. The picture's first
// surface and `bounces` more reflect, each lit directly.
TEST(Furnace, missesWhatTheCutTakes)
{
    Scene scene = loadLevel(kFolder / "furnace.glb");
    struct Row {
        float emission, albedo;
        int reflections;
        double radiance;
    };
    for (const Row& r : {Row{0.5f, 0.0f, 8, 0.5}, Row{0.5f, 0.5f, 1, 0.75}, Row{0.5f, 0.5f, 8, 0.998046875}, Row{1.0f, 0.9f, 1000, 10.0}}) {
        for (Material& material : scene.materials) {
            material.emission = vec3(r.emission);
            material.baseColor = vec4(vec3(r.albedo), 1.0f);
        }
        TruthOptions options;
        options.camera = scene.cameras.at(0);
        options.samples = 512;
        options.bounces = r.reflections - 1;
        MeanRadiance found = meanRadiance(scene, options);
        EXPECT_NEAR(found.value.x, r.radiance, 1e-5 * r.radiance + 4.0 * double(found.error.x)) << r.reflections;
    }
}

// As in the runtime: the bent lamp, a second material of the portal's own mesh, is no portal.
TEST(Truth, OfAnObjectOfSeveralMaterialsWhatIsFlatIsAPortal)
{
    Scene scene;
    Material lamp = matte(vec3(0.0f));
    lamp.emission = vec3(1.0f);
    const uint door = addMaterial(scene, matte(vec3(0.5f))), bent = addMaterial(scene, lamp);
    Object& a = addQuad(scene, vec3(-3, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), door);
    a.name = "A", a.portal = "B";
    addQuad(scene, vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), bent);
    scene.vertices.back().position.z = -0.3f;
    scene.meshes[0].primitives.push_back(scene.meshes[1].primitives[0]);
    scene.objects.pop_back();
    Object& b = addQuad(scene, vec3(-3, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), door);
    b.name = "B", b.portal = "A", b.toWorld[3] = dvec4(50, 0, 0, 1);
    TruthOptions options;
    options.size = ivec2(8, 8);
    options.samples = 4;
    options.portalDepth = 1;
    options.camera = lookAt(vec3(0, 0, 4), vec3(0), 0.2f);
    Progress silent(ProgressStyle::none);
    EXPECT_EQ(truth(scene, options, silent).at(4, 4)[0], 1.0f);
}
}
