#include "engine/app/inspect.hpp"
#include "engine/baked/baked.hpp"
#include "engine/core/error.hpp"
#include "tests/engine/baked/level.hpp"

namespace afterglow
{
static std::filesystem::path bake(const std::string& name)
{
    const std::filesystem::path folder = emptyFolder(name);
    Baked baked;
    baked.scene = loadLevel(LevelFile().write(folder));
    Lightmap page;
    page.width = page.height = 8;
    page.texels.assign(64, vec3(0.5f));
    page.valid.assign(64, 1);
    std::fill(page.valid.begin(), page.valid.begin() + 16, std::uint8_t(2));
    std::fill(page.valid.begin() + 16, page.valid.begin() + 32, std::uint8_t(0));
    baked.lightmaps.push_back(page);
    baked.probes.probes.assign(4, {shZero(), vec3(0.0f), vec3(0.0f)});
    baked.probes.positions.assign(4, vec3(0.0f));
    baked.probes.cells.assign(2, ProbeCell{});
    baked.probes.nodes = {{vec3(1, 0, 0), 0.0f, ~0, ~1}};
    writeBaked(folder / "out", baked, {{"seconds", 2.0}, {"warnings", {"the lamp is dim"}}}, /* exrMasters= */ false);
    return folder / "out";
}

static std::string said(const InspectOptions& options)
{
    testing::internal::CaptureStdout();
    inspect(options);
    return testing::internal::GetCapturedStdout();
}

TEST(Inspect, says_what_is_in_the_folder)
{
    const std::string text = said({.directory = bake("inspect_text")});
    for (const char* part : {"level.gltf, baked in 2.0 s", "6 objects", "1 pages (8 x 8), 50.0 % baked, 25.0 % dilated",
                             "4 probes in 2 cells", "warning: the lamp is dim"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " is missing from\n" << text;
}

TEST(Inspect, says_it_to_machines_too)
{
    const nlohmann::json result = nlohmann::json::parse(said({.directory = bake("inspect_json"), .json = true}));
    EXPECT_EQ(result["schema"], 1);
    EXPECT_EQ(result["products"]["lightmaps"]["baked_share"], 0.5);
    EXPECT_EQ(result["products"]["lightmaps"]["dilated_share"], 0.25);
    EXPECT_EQ(result["products"]["probes"]["count"], 4);
    EXPECT_EQ(result["products"]["probes"]["cells"], 2);
    EXPECT_EQ(result["products"]["scene"]["objects"], 6);
}

TEST(Inspect, refuses_what_is_no_bake_or_not_whole)
{
    EXPECT_THROW(inspect({.directory = testing::TempDir()}), Error);
    const std::filesystem::path folder = bake("inspect_damaged");
    std::filesystem::resize_file(folder / "lightmap_0.ktx2", 100);
    EXPECT_THROW(inspect({.directory = folder}), Error);
}
}
