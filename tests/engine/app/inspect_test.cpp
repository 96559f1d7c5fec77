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
    ProbeVolume volume;
    volume.count = ivec3(2, 2, 1);
    volume.irradiance.assign(4, Sh9{});
    volume.validity = {1.0f, 1.0f, 0.0f, 0.5f};
    baked.probes.push_back(volume);
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
                             "4 probes (2 x 2 x 1), 75.0 % valid", "warning: the lamp is dim"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " is missing from\n" << text;
}

TEST(Inspect, says_it_to_machines_too)
{
    const nlohmann::json result = nlohmann::json::parse(said({.directory = bake("inspect_json"), .json = true}));
    EXPECT_EQ(result["schema"], 1);
    EXPECT_EQ(result["products"]["lightmaps"]["baked_share"], 0.5);
    EXPECT_EQ(result["products"]["lightmaps"]["dilated_share"], 0.25);
    EXPECT_EQ(result["products"]["probes"]["valid_share"], 0.75);
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
