// The peer is driven by its command line: what a stand-in for it is given, and what becomes of what it says.
#include "bench/cycles.hpp"
#include "engine/core/file.hpp"
#include "tests/baker/rooms.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace afterglow
{
using nlohmann::json;

// A folder of the test's own, the first place where programs are looked for.
struct Programs {
    std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("cycles_" + std::to_string(getpid()));
    std::string before = std::getenv("PATH");
    Programs()
    {
        std::filesystem::create_directories(folder);
        setenv("PATH", (folder.string() + ":" + before).c_str(), 1);
    }
    ~Programs()
    {
        setenv("PATH", before.c_str(), 1);
        std::filesystem::remove_all(folder);
    }
    void blender(const std::string& does) const
    {
        writeText(folder / "blender", "#!/bin/sh\n" + does + "\n");
        std::filesystem::permissions(folder / "blender", std::filesystem::perms::owner_all);
    }
};

// A floor of 2 x 2 m under a lamp of 0.5 m.
static Scene lampOverFloor()
{
    const Shape square{{vec3(-1, 0, 1), vec3(1, 0, 1), vec3(1, 0, -1), vec3(-1, 0, -1)}, {0, 1, 2, 0, 2, 3}};
    Shape lamp = flipped(square);
    for (vec3& p : lamp.positions) p = 0.25f * p + vec3(0.0f, 2.0f, 0.0f);
    Scene scene;
    addSurface(scene, square, shining(0.0f, 0.5f));
    addSurface(scene, lamp, shining(8.0f));
    scene.lower = vec3(-1.0f, 0.0f, -1.0f), scene.upper = vec3(1.0f, 2.0f, 1.0f);
    return scene;
}

TEST(Cycles, isToldOfTheRoomAndBelieved)
{
    const Programs programs;
    const std::string given = (programs.folder / "given").string();
    programs.blender("echo \"$@\" > '" + given + R"('
echo 'Fra:1 Mem:9.50M | AFTER all'
echo 'AFTERGLOW {"version": "3.4.1", "texels": 48076, "samples": 16, "seconds": 1.5, "cpu_seconds": 2.5, "error": 0.174}'
echo 'Blender quit')");
    BenchOptions options;
    options.quick = true;
    options.threads = 2;
    const json answer = benchCycles(lampOverFloor(), 16.0f, options, programs.folder);
    EXPECT_EQ(answer,
              json({{"version", "3.4.1"}, {"texels", 48076}, {"samples", 16}, {"seconds", 1.5}, {"cpu_seconds", 2.5}, {"error", 0.174}}));

    const std::string words = readText(given);
    EXPECT_EQ(words.rfind("-b --factory-startup -t 2 --python-exit-code 1 -P", 0), 0u) << words;
    EXPECT_NE(words.find(" 2 16 8\n"), std::string::npos) << "threads, samples, bounces: " << words;
    EXPECT_EQ(std::filesystem::file_size(programs.folder / "corners"), 6 * 5 * sizeof(float)) << "the floor; the lamp is a light there";
    EXPECT_EQ(std::filesystem::file_size(programs.folder / "paint"), 2 * sizeof(std::int32_t));
    const json room = json::parse(readText(programs.folder / "room.json"));
    EXPECT_EQ(room["colors"].size(), 2u);
    EXPECT_NEAR(room["edge"].get<double>(), 0.5, 1e-6);
    EXPECT_NEAR(room["watts"].get<double>(), 8.0 * 3.14159265 * 0.25, 1e-5) << "radiance * pi * area";
    EXPECT_EQ(room["lamp"], json({0.0, 0.0, 2.0})) << "z is up there";
}

TEST(Cycles, isMissedInASentence)
{
    const Programs programs;
    BenchOptions options;
    programs.blender("exit 1");
    EXPECT_TRUE(benchCycles(lampOverFloor(), 16.0f, options, programs.folder).contains("missing"));
    for (const char* words :
         {"echo 'Error: no Cycles here'", "echo 'AFTERGLOW {\"version\":'", "echo 'AFTERGLOW []'", "echo 'AFTERGLOW {}'"}) {
        programs.blender(words);
        const json answer = benchCycles(lampOverFloor(), 16.0f, options, programs.folder);
        ASSERT_TRUE(answer.contains("missing")) << words;
        EXPECT_EQ(answer["missing"].get<std::string>().rfind("blender did not bake: ", 0), 0u);
    }
}
}
