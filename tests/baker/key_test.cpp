// What a bake is known by: its level, with the files that it names, and the options that change a bit of it.
#include "baker/key.hpp"
#include "bits.hpp"
#include "engine/core/file.hpp"

namespace afterglow
{
// All that makes another result makes another key, and nothing else does.
TEST(BakeKey, isOfTheResult)
{
    const std::filesystem::path level = "content/truth/furnace.glb";
    const std::string key = bakeKey(level, {});
    EXPECT_EQ(key.size(), 64u);
    const auto keyOf = [&](auto change) {
        BakeOptions options;
        change(options);
        return bakeKey(level, options);
    };
    EXPECT_EQ(keyOf([](BakeOptions& o) { o.threads = 3; }), key);
    EXPECT_EQ(keyOf([](BakeOptions& o) { o.resume = true; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.seed = 2; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.samples = 8; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.targetError = 0.1f; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.lods = false; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.exr = true; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.lightLayers = true; }), key);
    EXPECT_NE(keyOf([](BakeOptions& o) { o.incremental = true; }), key);

    // A file beside the level, there or not, and its bytes
    const Ground ground("beside");
    const std::filesystem::path named = ground.folder / "level.gltf";
    writeText(named, R"({"asset":{"version":"2.0"},"images":[{"uri":"a%20b.png"}],"scenes":[{"extras":{"ag_sky_image":"sky.hdr"}}]})");
    std::vector<std::string> keys = {bakeKey(named, {})};
    for (const auto& [name, text] : {std::pair("a b.png", "1"), {"a b.png", "2"}, {"sky.hdr", "1"}}) {
        writeText(ground.folder / name, text);
        keys.push_back(bakeKey(named, {}));
        EXPECT_NE(keys.back(), keys[keys.size() - 2]) << name;
    }
}
}
