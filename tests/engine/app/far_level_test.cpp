// A level moved by 1e6 m along each axis, from file to picture: truth, bake, render and probe answer as at the origin (H10).
#include "baker/baker.hpp"
#include "engine/app/runtime_verbs.hpp"
#include "engine/app/verbs.hpp"
#include "engine/core/file.hpp"
#include <cstring>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace afterglow
{
using nlohmann::json;

static constexpr double kFar = 1e6; // m

// The level with all its roots moved. JSON keeps doubles; the binary chunk stays what it was.
static void writeMoved(const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::vector<std::uint8_t> bytes = readFile(from);
    std::uint32_t length = 0;
    std::memcpy(&length, &bytes[12], 4);
    json level = json::parse(bytes.begin() + 20, bytes.begin() + 20 + length);
    const std::vector<std::uint8_t> rest(bytes.begin() + 20 + length, bytes.end());
    for (const json& root : level["scenes"][0]["nodes"]) {
        json& node = level["nodes"][root.get<std::size_t>()];
        if (!node.contains("translation")) node["translation"] = {0.0, 0.0, 0.0};
        for (json& coordinate : node["translation"]) coordinate = coordinate.get<double>() + kFar;
    }
    std::string text = level.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    bytes.resize(20);
    bytes.insert(bytes.end(), text.begin(), text.end());
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    const auto put = [&](std::size_t at, std::size_t value) {
        const std::uint32_t word = std::uint32_t(value);
        std::memcpy(&bytes[at], &word, 4);
    };
    put(8, bytes.size());
    put(12, text.size());
    writeFile(to, bytes.data(), bytes.size());
}

class FarLevelTest : public testing::Test
{
protected:
    FarLevelTest()
    {
        std::filesystem::create_directories(folder);
        writeMoved(near_, far_);
    }
    ~FarLevelTest() override { std::filesystem::remove_all(folder); }

    std::filesystem::path bake(const std::filesystem::path& level)
    {
        Progress silent(ProgressStyle::none);
        BakeOptions options;
        options.quality = Quality::draft;
        const std::filesystem::path baked = folder / (level.stem().string() + ".baked");
        bakeLevel(level, baked, options, silent);
        return baked;
    }

    const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("afterglow_far_level_" + std::to_string(getpid()));
    const std::filesystem::path near_ = "content/cornell/cornell.glb", far_ = folder / "far.glb";
};

// Share of the pixels that differ by less than one step of 8 bits, as radiance and so a fortiori as displayed.
static double alike(const Image& a, const Image& b)
{
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    std::size_t same = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
        bool close = true;
        for (std::size_t c = 0; c < 3; c++) close = close && std::abs(a.pixels[i + c] - b.pixels[i + c]) < 1.0f / 255.0f;
        same += close ? 1 : 0;
    }
    return 3.0 * double(same) / double(a.pixels.size());
}

TEST_F(FarLevelTest, hasTheSameTruth)
{
    Progress silent(ProgressStyle::none);
    const auto picture = [&](const std::filesystem::path& level) {
        const Scene scene = loadLevel(level);
        TruthOptions options;
        options.camera = scene.cameras.at(0);
        options.size = ivec2(64, 64);
        options.samples = 64;
        return truth(scene, options, silent);
    };
    EXPECT_GE(alike(picture(near_), picture(far_)), 0.999);
}

TEST_F(FarLevelTest, hasTheSameBakeAndRender)
{
    const std::filesystem::path here = bake(near_), there = bake(far_);
    const Baked a = readBaked(here), b = readBaked(there);
    ASSERT_NE(b.scene.origin, dvec3(0.0));
    ASSERT_EQ(a.lightmaps.size(), b.lightmaps.size());
    for (std::size_t i = 0; i < a.lightmaps.size(); i++) {
        std::size_t valid = 0, same = 0;
        for (std::size_t t = 0; t < a.lightmaps[i].texels.size(); t++) {
            if (a.lightmaps[i].valid[t] != 1) continue;
            const vec3 apart = abs(a.lightmaps[i].texels[t] - b.lightmaps[i].texels[t]);
            valid++;
            same += max(max(apart.x, apart.y), apart.z) < 1.0f / 255.0f ? 1 : 0;
        }
        EXPECT_GE(double(same), 0.999 * double(valid));
    }

    RenderCommand command;
    command.settings.size = uvec2(64, 64);
    const auto picture = [&](const std::filesystem::path& baked) {
        command.target = baked;
        command.output = folder / "picture.exr";
        renderVerb(command);
        return readImage(command.output);
    };
    EXPECT_GE(alike(picture(here), picture(there)), 0.999);
}

TEST_F(FarLevelTest, speaksItsOwnCoordinates)
{
    const std::filesystem::path here = bake(near_), there = bake(far_);
    const auto probed = [&](const std::filesystem::path& baked, double by, bool truth) {
        ProbeCommand command;
        command.target = baked;
        command.points = folder / "in.json";
        command.output = folder / "out.json";
        command.truth = truth;
        command.progress = ProgressStyle::none;
        writeText(command.points, json{{"points", {{{"position", {by + 0.1, by + 0.3, by + 0.2}}}}}}.dump());
        probeVerb(command);
        return json::parse(readText(command.output));
    };
    for (const bool truth : {false, true}) {
        const json a = probed(here, 0.0, truth), b = probed(there, kFar, truth);
        EXPECT_EQ(b["points"][0]["position"][0].get<double>(), kFar + 0.1);
        for (std::size_t side = 0; side < 6; side++)
            for (std::size_t c = 0; c < 3; c++) {
                const double value = a["points"][0]["E"][side][c];
                EXPECT_NEAR(b["points"][0]["E"][side][c].get<double>(), value, 0.01 * value + 1e-4) << truth << side;
            }
    }

    // bake.json, and scene.glb for whoever reads it without us
    const json manifest = json::parse(readText(there / "bake.json")), near = json::parse(readText(here / "bake.json"));
    for (const char* corner : {"lower", "upper"})
        for (std::size_t axis = 0; axis < 3; axis++)
            EXPECT_NEAR(manifest["products"]["probes"][corner][axis].get<double>(),
                        kFar + near["products"]["probes"][corner][axis].get<double>(), 1e-6);
    const Scene again = loadLevel(there / "scene.glb"), level = loadLevel(far_);
    EXPECT_EQ(again.origin, level.origin);
    ASSERT_EQ(again.objects.size(), level.objects.size());
    for (std::size_t i = 0; i < level.objects.size(); i++) EXPECT_EQ(again.objects[i].toWorld, level.objects[i].toWorld) << i;
}
}
