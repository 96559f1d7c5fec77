#include "engine/baked/baked.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "tests/engine/baked/level.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static Baked bakedLevel(const std::filesystem::path& folder)
{
    Baked baked;
    baked.scene = loadLevel(LevelFile().write(folder));
    baked.places.resize(baked.scene.objects.size());
    baked.places[0].page = 0;
    Lightmap page;
    page.width = 16, page.height = 8;
    for (int i = 0; i < 128; ++i) {
        page.texels.push_back(vec3(float(i % 16), float(i % 8), 1.0f));
        page.valid.push_back(std::uint8_t(i % 3));
    }
    baked.lightmaps.push_back(page);
    baked.probes.probes.assign(12, {shZero(), vec3(0.0f), vec3(0.0f)});
    baked.probes.probes[7].irradiance.c[4] = vec3(0.5f, -0.25f, 2.0f);
    baked.probes.positions.assign(12, vec3(0.0f));
    baked.probes.cells.assign(1, ProbeCell{});
    baked.probes.nodes = {{vec3(0.0f), 0.0f, ~0, ~0}};
    ReflectionProbe probe;
    probe.size = 4;
    for (int m = 0; m < 3; ++m) probe.mips.push_back(std::vector<vec3>(std::size_t(6 * (4 >> m) * (4 >> m)), vec3(float(m), 1.0f, 2.0f)));
    baked.reflections.push_back(probe);
    baked.voxels = {vec3(-1, 0, 2), 0.25f, ivec3(3, 4, 5), std::vector<u8vec4>(60, u8vec4(7, 8, 9, 255))};
    baked.voxels.closed[17].y = 255;
    baked.directAll = true;
    return baked;
}

static std::vector<std::string> names(const std::filesystem::path& folder)
{
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
}

TEST(Baked, folder_comes_back_as_it_was)
{
    const std::filesystem::path folder = emptyFolder("folder");
    const Baked in = bakedLevel(folder);
    writeBaked(folder / "out", in, {{"seconds", 1.5}}, /* exrMasters= */ true);
    EXPECT_EQ(names(folder / "out"),
              (std::vector<std::string>{"bake.json", "irradiance.ktx2", "irradiance_tree.ktx2", "lightmap_0.exr", "lightmap_0.ktx2",
                                        "lightmap_0_coverage.ktx2", "reflection_0.ktx2", "scene.glb", "sky.hdr", "voxels.ktx2"}));
    EXPECT_TRUE(isBaked(folder / "out"));
    const Baked out = readBaked(folder / "out");
    EXPECT_EQ(out.scene.path, "level.gltf");
    EXPECT_EQ(out.scene.objects.size(), in.scene.objects.size());
    EXPECT_EQ(out.lightmaps[0].texels, in.lightmaps[0].texels); // small integers: exact in nine bits
    EXPECT_EQ(out.lightmaps[0].valid, in.lightmaps[0].valid);
    EXPECT_EQ(out.probes.probes[7].irradiance.c[4], in.probes.probes[7].irradiance.c[4]);
    EXPECT_EQ(out.reflections[0].mips, in.reflections[0].mips);
    EXPECT_EQ(out.voxels.lower, in.voxels.lower);
    EXPECT_EQ(out.voxels.edge, in.voxels.edge);
    EXPECT_EQ(out.voxels.count, in.voxels.count);
    EXPECT_EQ(out.voxels.closed, in.voxels.closed);
    EXPECT_TRUE(out.directAll);
    EXPECT_EQ(out.places[0].page, 0);
    EXPECT_EQ(out.places[1].page, -1);
    EXPECT_EQ(readImage(folder / "out" / "lightmap_0.exr").at(5, 3)[0], in.lightmaps[0].texels[3 * 16 + 5].r);
}

TEST(Baked, manifest_lists_files_bytes_and_counts_beside_what_the_baker_said)
{
    const std::filesystem::path folder = emptyFolder("manifest");
    writeBaked(folder / "out", bakedLevel(folder), {{"seconds", 1.5}, {"products", {{"lightmaps", {{"rays", 77}}}}}},
               /* exrMasters= */ false);
    const nlohmann::json manifest = nlohmann::json::parse(readText(folder / "out" / "bake.json"));
    EXPECT_EQ(manifest["schema"], 1);
    EXPECT_EQ(manifest["seconds"], 1.5);
    const nlohmann::json& lightmaps = manifest["products"]["lightmaps"];
    EXPECT_EQ(lightmaps["rays"], 77);
    EXPECT_EQ(lightmaps["files"], nlohmann::json({"lightmap_0.ktx2", "lightmap_0_coverage.ktx2"}));
    EXPECT_EQ(lightmaps["bytes"], std::filesystem::file_size(folder / "out" / "lightmap_0.ktx2") +
                                      std::filesystem::file_size(folder / "out" / "lightmap_0_coverage.ktx2"));
    EXPECT_EQ(lightmaps["texels"], 128);
    EXPECT_EQ(lightmaps["valid_texels"], 43); // i % 3 == 1 below 128
    EXPECT_EQ(manifest["products"]["probes"]["count"], 12);
    EXPECT_EQ(manifest["products"]["probes"]["cells"], 1);
    EXPECT_EQ(manifest["products"]["voxels"]["count"], nlohmann::json({3, 4, 5}));
    EXPECT_EQ(manifest["products"].count("lods"), 0u);
}

TEST(Baked, folder_appears_whole_or_not_at_all)
{
    const std::filesystem::path folder = emptyFolder("atomic");
    Baked baked = bakedLevel(folder);
    std::filesystem::create_directories(folder / "out.writing"); // somebody's
    const std::vector<std::string> before = {"level.bin", "level.gltf", "out", "out.writing", "pictures"};
    std::filesystem::create_directories(folder / "out"); // empty: free
    writeBaked(folder / "out", baked, {}, /* exrMasters= */ false);
    EXPECT_EQ(names(folder), before);

    // A second bake that fails leaves the first.
    baked.scene.path = folder / "gone.gltf";
    EXPECT_THROW(writeBaked(folder / "out", baked, {}, /* exrMasters= */ false), Error);
    EXPECT_EQ(names(folder), before);
    EXPECT_EQ(readBaked(folder / "out").probes.probes.size(), 12u);

    // One that succeeds replaces it, with or without a final slash.
    baked.scene.path = folder / "level.gltf";
    baked.probes = {};
    writeBaked(folder / "out/", baked, {}, /* exrMasters= */ false);
    EXPECT_EQ(names(folder), before);
    EXPECT_TRUE(readBaked(folder / "out").probes.empty());
}

TEST(Baked, is_never_written_over_something_else)
{
    const std::filesystem::path folder = emptyFolder("foreign");
    const Baked baked = bakedLevel(folder);
    std::filesystem::create_directories(folder / "holidays");
    writeText(folder / "holidays" / "photo", "x");
    EXPECT_THROW(writeBaked(folder / "holidays", baked, {}, /* exrMasters= */ false), Error);
    EXPECT_THROW(writeBaked(folder / "level.gltf", baked, {}, /* exrMasters= */ false), Error);
    EXPECT_THROW(writeBaked("/proc/nowhere/out", baked, {}, /* exrMasters= */ false), Error);
    // A file of that name makes no bake of a folder
    for (const char* text : {"", "{}", R"({"schema":1,"products":{}})", R"({"schema":1,"products":{},"generator":"oven 2"})"}) {
        writeText(folder / "holidays" / "bake.json", text);
        EXPECT_THROW(writeBaked(folder / "holidays", baked, {}, /* exrMasters= */ false), Error) << text;
    }
    EXPECT_EQ(names(folder / "holidays"), (std::vector<std::string>{"bake.json", "photo"}));

    // Nor is a stranger's file in a bake of ours lost
    writeBaked(folder / "out", baked, {}, /* exrMasters= */ true);
    writeBaked(folder / "out", baked, {}, /* exrMasters= */ true);
    writeText(folder / "out" / "photo", "x");
    EXPECT_THROW(writeBaked(folder / "out", baked, {}, /* exrMasters= */ false), Error);
    EXPECT_EQ(readText(folder / "out" / "photo"), "x");
}

TEST(Baked, folder_that_is_no_bake_is_refused_with_a_sentence)
{
    const std::filesystem::path folder = emptyFolder("refused");
    EXPECT_FALSE(isBaked(folder));
    EXPECT_FALSE(isBaked(folder / "nowhere"));
    for (const char* text :
         {"", "{", "[]", "{}", R"({"schema":2,"products":{}})", R"({"schema":"1","products":{}})",
          R"({"schema":1,"products":{"scene":{"files":["../secret"]}}})", R"({"schema":1,"products":{"lightmaps":{"files":7}}})"}) {
        writeText(folder / "bake.json", text);
        EXPECT_THROW(readBaked(folder), Error) << text;
    }
    std::filesystem::remove(folder / "bake.json");
    try {
        readBaked(folder);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("is not a bake"), std::string::npos);
        EXPECT_EQ(error.exit, Exit::badInput);
    }
}

// To read it and to write over it: one advice.
TEST(Baked, with_a_damaged_manifest_is_to_be_removed)
{
    const std::filesystem::path folder = emptyFolder("unlisted"), out = folder / "out";
    const Baked baked = bakedLevel(folder);
    writeBaked(out, baked, {}, /* exrMasters= */ false);
    const auto advised = [&](auto&& act) {
        try {
            act();
        } catch (const Error& error) {
            return std::string(error.what()).find("; remove " + out.string() + " and bake the level again") != std::string::npos;
        }
        return false;
    };
    writeText(out / "bake.json", "{");
    EXPECT_TRUE(advised([&] { readBaked(out); }));
    EXPECT_TRUE(advised([&] { writeBaked(out, baked, {}, /* exrMasters= */ false); }));
    std::filesystem::remove_all(out);
    EXPECT_NO_THROW(writeBaked(out, baked, {}, /* exrMasters= */ false));
}

// H90: whatever happens to a file, reading ends in Error, not in a crash or a wrong picture.
TEST(Baked, with_a_file_cut_flipped_or_missing_is_refused)
{
    const std::filesystem::path folder = emptyFolder("damaged");
    const std::filesystem::path out = folder / "out";
    writeBaked(out, bakedLevel(folder), {}, /* exrMasters= */ false);
    for (const std::string& name : names(out)) {
        if (name == "bake.json") continue;
        const std::vector<std::uint8_t> whole = readFile(out / name);
        std::filesystem::remove(out / name);
        try {
            readBaked(out);
            ADD_FAILURE() << name << " is not missed";
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()),
                      "cannot read " + (out / name).string() + ": it is missing from the bake; bake the level again");
        }
        for (std::size_t size = 0; size < whole.size(); size += 64) {
            writeFile(out / name, whole.data(), size);
            EXPECT_THROW(readBaked(out), Error) << name << " cut at " << size;
        }
        for (std::size_t byte = 0; byte < whole.size(); byte += 101) {
            std::vector<std::uint8_t> flipped = whole;
            flipped[byte] ^= std::uint8_t(1u << (byte % 8));
            writeFile(out / name, flipped.data(), flipped.size());
            EXPECT_THROW(readBaked(out), Error) << name << " flipped at " << byte;
        }
        writeFile(out / name, whole.data(), whole.size());
    }
    EXPECT_NO_THROW(readBaked(out));
}

// Without the checksums: the readers themselves stand.
TEST(Baked, with_damage_and_no_checksum_never_crashes)
{
    const std::filesystem::path folder = emptyFolder("unchecked");
    const std::filesystem::path out = folder / "out";
    writeBaked(out, bakedLevel(folder), {}, /* exrMasters= */ false);
    nlohmann::json manifest = nlohmann::json::parse(readText(out / "bake.json"));
    manifest.erase("sha256");
    writeText(out / "bake.json", manifest.dump());
    for (const char* name : {"scene.glb", "lightmap_0.ktx2", "irradiance.ktx2", "irradiance_tree.ktx2", "reflection_0.ktx2"}) {
        const std::vector<std::uint8_t> whole = readFile(out / name);
        for (std::size_t byte = 0; byte < whole.size(); byte += 53) {
            std::vector<std::uint8_t> flipped = whole;
            flipped[byte] ^= std::uint8_t(1u << (byte % 8));
            writeFile(out / name, flipped.data(), flipped.size());
            try {
                readBaked(out);
            } catch (const Error&) {
            }
        }
        writeFile(out / name, whole.data(), whole.size());
    }
}
}
