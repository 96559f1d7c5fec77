// `afterglow study` from its words to its three files; needs a device.
#include "engine/app/cli.hpp"
#include "engine/core/file.hpp"
#include "engine/core/scaffold.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

struct Said {
    int code;
    std::string out, err;
};

class StudyVerb : public testing::Test
{
protected:
    StudyVerb() { std::filesystem::create_directories(folder); }
    ~StudyVerb() override { std::filesystem::remove_all(folder); }

    Said study(std::vector<std::string> words)
    {
        std::vector<const char*> all = {"afterglow", "study"};
        for (const std::string& word : words) all.push_back(word.c_str());
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = runCommandLine(int(all.size()), all.data());
        return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
    }

    std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "study_verb";
};

const json& curveOf(const json& data, const std::string& effect, const std::string& knob)
{
    for (const json& subject : data["subjects"])
        for (const json& curve : subject["curves"])
            if (subject["effect"] == effect && curve["knob"] == knob) return curve;
    throw std::runtime_error("no " + effect + ", " + knob);
}

void demandFinite(const json& value)
{
    if (value.is_number()) {
        EXPECT_TRUE(std::isfinite(value.get<double>()));
        EXPECT_GE(value.get<double>(), -10.0); // slopes are the only negative numbers
    }
    for (const json& inner : value)
        if (value.is_structured()) demandFinite(inner);
}
}

// Points that take turns on the device, each with its own past: half the size is off by more than all of it.
TEST_F(StudyVerb, gathers_no_picture_of_another_point)
{
    const std::filesystem::path out = folder / "scales";
    const Said said =
        study({"content/still_life/still_life.glb", "--quick", "--effects", "upscale", "--size", "96x64", "-o", out.string()});
    ASSERT_EQ(said.code, 0) << said.err;
    const json data = json::parse(readText(out / "study.json"));
    const json& points = curveOf(data, "upscale", "render scale")["points"];
    ASSERT_GE(points.size(), 3u);
    EXPECT_GT(points.front()["error"].get<double>(), 2.0 * points.back()["error"].get<double>()) << points.dump();
}

TEST_F(StudyVerb, writes_what_accuracy_costs)
{
    const std::filesystem::path out = folder / "out";
    const Said said = study({"content/truth/furnace_clutter.glb", "-o", out.string(), "--quick", "--size", "32x24", "--samples", "64",
                             "--effects", "antialias,truth", "--progress", "none"});
    ASSERT_EQ(said.code, 0) << said.err;
    EXPECT_EQ(said.out.rfind(placeOf(out).string() + "/study.html\n", 0), 0u) << said.out;
    for (const char* name : {"study.csv", "study.json", "study.html"}) EXPECT_GT(std::filesystem::file_size(out / name), 200u) << name;
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), {}), 3);

    const json data = json::parse(readText(out / "study.json"));
    demandFinite(data);
    EXPECT_FALSE(data["device"].get<std::string>().empty());
    EXPECT_EQ(data["size"], (json{32, 24}));

    // Paths drawn by lot: the error falls as their number to the power of -1/2, and the time grows with it
    const json& paths = curveOf(data, "truth", "paths");
    EXPECT_NEAR(paths["measured_slope"].get<double>(), -0.5, 0.15);
    const json &few = paths["points"].front(), &many = paths["points"].back();
    EXPECT_LT(many["error"].get<double>(), 0.3 * few["error"].get<double>());
    EXPECT_GT(many["ms"].get<double>(), 8.0 * few["ms"].get<double>());
    int standard = 0;
    for (const json& point : paths["points"]) standard += point["default"].get<bool>() ? 1 : 0;
    EXPECT_EQ(standard, 1);

    // Frames gathered: more of them are nearer to the mean of many
    const json& frames = curveOf(data, "antialias", "frames");
    EXPECT_LT(frames["points"][4]["error"].get<double>(), 0.5 * frames["points"][0]["error"].get<double>());

    // A study gives way to a study
    EXPECT_EQ(study({"content/truth/nothing.glb", "-o", out.string(), "--quick", "--size", "8x8", "--samples", "1", "--effects", "truth",
                     "--progress", "none"})
                  .code,
              0);
}

// Three channels are off by more after each bounce, and off narrower bands; three wavelengths are unbiased, and noise is not called an
// error.
TEST_F(StudyVerb, tells_what_three_channels_lose_of_a_spectrum)
{
    const std::filesystem::path out = folder / "out";
    const Said said = study({"content/truth/furnace_clutter.glb", "-o", out.string(), "--quick", "--size", "16x12", "--samples", "4",
                             "--effects", "spectrum", "--progress", "none"});
    ASSERT_EQ(said.code, 0) << said.err;
    const json data = json::parse(readText(out / "study.json"));
    const json &bounces = curveOf(data, "spectrum", "channels by bounces")["points"],
               &widths = curveOf(data, "spectrum", "channels by width")["points"];
    ASSERT_EQ(bounces.size(), 8u);
    ASSERT_EQ(widths.size(), 5u);
    for (std::size_t i = 1; i < bounces.size(); ++i)
        EXPECT_GT(bounces[i]["error"].get<double>(), bounces[i - 1]["error"].get<double>()) << i;
    for (std::size_t i = 1; i < widths.size(); ++i) EXPECT_LT(widths[i]["error"].get<double>(), widths[i - 1]["error"].get<double>()) << i;
    const json& paths = curveOf(data, "spectrum", "paths")["points"];
    EXPECT_LE(paths[1]["error"].get<double>(), paths[1]["noise"].get<double>()) << paths[1]["name"];
}

// Probes are held against the light of free space in any level: those that keep to walls leak nothing where grids do.
TEST_F(StudyVerb, tells_what_probes_are_off_by_in_free_space)
{
    const std::filesystem::path out = folder / "out";
    const Said said = study({"content/two_rooms/two_rooms_closed.glb", "-o", out.string(), "--quick", "--size", "16x12", "--samples", "4",
                             "--effects", "probes", "--progress", "none"});
    ASSERT_EQ(said.code, 0) << said.err;
    EXPECT_NE(said.out.find("| 95 of 100 below |"), std::string::npos) << said.out;
    const json data = json::parse(readText(out / "study.json"));
    demandFinite(data);
    const json &asked = curveOf(data, "probes", "asked error")["points"], &grids = curveOf(data, "probes", "grid spacing")["points"],
               &harmonics = curveOf(data, "probes", "harmonics")["points"];
    EXPECT_LT(asked.back()["error"], asked.front()["error"]);
    EXPECT_GT(asked.back()["bytes"], asked.front()["bytes"]);
    for (const json& point : asked) EXPECT_LE(point["leak"], 1e-4);
    for (const json& point : grids) EXPECT_GT(point["leak"], 1.0);
    EXPECT_LT(harmonics[1]["error"], harmonics[0]["error"]);
    EXPECT_LT(harmonics[0]["bytes"], harmonics[1]["bytes"]);
    EXPECT_NE(curveOf(data, "probes", "grid spacing")["verdict"].get<std::string>().find("a grid of as many bytes"), std::string::npos);
}

TEST_F(StudyVerb, refuses_in_one_sentence_before_any_work)
{
    const Said unknown = study({"content/truth/furnace.glb", "-o", (folder / "x").string(), "--effects", "fog,mist"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_EQ(unknown.err.rfind("afterglow: --effects mist: there is nothing of that name to study; there are masked, ", 0), 0u)
        << unknown.err;
    EXPECT_EQ(study({"content/truth/furnace.glb"}).code, 2) << "-o is required";
    EXPECT_EQ(study({"no.glb", "-o", (folder / "x").string()}).code, 3);
    EXPECT_EQ(study({"content/truth/furnace.glb", "-o", (folder / "x").string(), "--samples", "0"}).code, 2);
    EXPECT_EQ(study({"content/truth/furnace.glb", "-o", (folder / "x").string(), "--size", "0x8"}).code, 2);

    writeText(folder / "mine" / "letter.txt", "dear");
    const Said mine = study({"content/truth/furnace.glb", "-o", (folder / "mine").string()});
    EXPECT_EQ(mine.code, 3);
    EXPECT_NE(mine.err.find("letter.txt"), std::string::npos) << mine.err;
    EXPECT_EQ(readText(folder / "mine" / "letter.txt"), "dear");
    EXPECT_FALSE(std::filesystem::exists(folder / "x"));
}

// Before the bake, whose progress would be told.
TEST_F(StudyVerb, says_why_there_is_nothing_to_study_before_it_bakes)
{
    const auto asked = [&](const char* level, const char* effects) {
        const Said said = study({std::string("content/truth/") + level, "-o", (folder / "x").string(), "--quick", "--size", "8x8",
                                 "--samples", "1", "--effects", effects, "--progress", "json"});
        EXPECT_EQ(said.code, 2) << effects;
        EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "x"));
        return said.err;
    };
    EXPECT_EQ(asked("furnace.glb", "fog").rfind("afterglow: there is nothing to study: fog: off, no ag_fog_scattering", 0), 0u);
    EXPECT_EQ(asked("furnace.glb", "lods"), "afterglow: there is nothing to study: lods: off, no mesh above 512 triangles\n");
    EXPECT_EQ(asked("furnace.glb", "occlusion,fog"),
              "afterglow: there is nothing to study: occlusion: off, lightmaps hold the contact of everything opaque\n");
    EXPECT_EQ(asked("nothing.glb", "lightmaps,denoise,bounces"),
              "afterglow: there is nothing to study: lightmaps: off, no static object\n");
}
}
