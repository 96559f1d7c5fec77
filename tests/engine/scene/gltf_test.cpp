// What a file may be, and where it may read from: containers, URIs, required extensions, links out of the folder.
#include "tests/engine/scene/builder.hpp"

namespace afterglow::test
{
using Gltf = LevelTest;

std::string base64(const std::vector<std::uint8_t>& bytes)
{
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
    }
    return text;
}

TEST_F(Gltf, ReadsAGlb)
{
    place(triangle(), {{"name", "Wall in the hall"}});
    const Scene scene = load();
    ASSERT_EQ(triangles(scene), 1u);
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].name, "Wall in the hall");
    EXPECT_EQ(scene.meshes[0].name, "Wall");
    EXPECT_TRUE(scene.dropped.empty());
    EXPECT_EQ(scene.path.filename(), "level.glb");
}

TEST_F(Gltf, ReadsAGltfWithItsBufferBesideIt)
{
    place(triangle());
    gltf["buffers"] = {{{"byteLength", buffer.size()}, {"uri", "the%20buffer.bin"}}};
    write(folder / "the buffer.bin", buffer);
    EXPECT_EQ(triangles(loadLevel(written(bytesOf(gltf.dump()), "level.gltf"))), 1u);
}

TEST_F(Gltf, ReadsABufferInADataUri)
{
    place(triangle());
    gltf["buffers"] = {{{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
    const Scene scene = loadLevel(written(bytesOf(gltf.dump()), "level.gltf"));
    ASSERT_EQ(triangles(scene), 1u);
    EXPECT_TRUE(near(scene.vertices[1].position, {1, 0, 0}));
}

TEST_F(Gltf, NamesTheFileThatIsMissing) { EXPECT_NE(sentence(folder / "nothing.glb").find("nothing.glb"), std::string::npos); }

TEST_F(Gltf, RefusesWhatIsNotGltf)
{
    EXPECT_NE(sentence(written(bytesOf("# a README"), "README.md")).find("not glTF"), std::string::npos);
    EXPECT_NE(sentence(written({}, "empty.glb")).find("not glTF"), std::string::npos);
    EXPECT_NE(sentence(written(bytesOf("{}"), "object.gltf")).find("not glTF"), std::string::npos);
    EXPECT_NE(sentence(written(bytesOf(R"({"asset":{"version":"1.0"}})"), "old.gltf")).find("not glTF 2.0"), std::string::npos);
}

TEST_F(Gltf, SaysThatAGlbIsTruncated)
{
    place(triangle());
    std::vector<std::uint8_t> file = glb();
    const std::size_t whole = file.size();
    file.resize(whole - 10);
    EXPECT_NE(sentence(written(file)).find("truncated: " + std::to_string(whole - 10) + " of " + std::to_string(whole)), std::string::npos);
}

TEST_F(Gltf, RefusesAChunkLongerThanTheFile)
{
    place(triangle());
    std::vector<std::uint8_t> file = glb();
    file[14] = 0xFF; // of the length of the JSON chunk
    EXPECT_NE(sentence(written(file)).find("chunk"), std::string::npos);
}

TEST_F(Gltf, SaysWhichRequiredExtensionIsNotRead)
{
    place(triangle());
    gltf["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    EXPECT_NE(sentence().find("KHR_draco_mesh_compression"), std::string::npos);
    EXPECT_NE(sentence().find("without mesh compression"), std::string::npos);
    gltf["extensionsRequired"] = {"KHR_lights_punctual", "KHR_texture_transform"};
    EXPECT_EQ(sentence(), "");
    gltf["extensionsUsed"] = {"KHR_materials_sheen"};
    EXPECT_NE(load().warnings.at(0).find("KHR_materials_sheen"), std::string::npos);
}

TEST_F(Gltf, ReadsBuffersFromItsOwnFolderOnly)
{
    place(triangle());
    write(folder.parent_path() / "secret.bin", buffer);
    std::filesystem::create_symlink(folder.parent_path() / "secret.bin", folder / "link.bin");
    std::filesystem::create_directories(folder / "below");
    write(folder / "below" / "own.bin", buffer);
    const auto from = [&](const std::string& uri) {
        gltf["buffers"] = {{{"byteLength", buffer.size()}, {"uri", uri}}};
        return sentence(written(bytesOf(gltf.dump()), "level.gltf"));
    };
    EXPECT_EQ(from("below/own.bin"), "");
    EXPECT_NE(from("../secret.bin").find("out of the level's own folder"), std::string::npos);
    EXPECT_NE(from("%2e%2e/secret.bin").find("out of the level's own folder"), std::string::npos);
    EXPECT_NE(from("below/../../secret.bin").find("out of the level's own folder"), std::string::npos);
    EXPECT_NE(from((folder.parent_path() / "secret.bin").string()).find("out of the level's own folder"), std::string::npos);
    EXPECT_NE(from("link.bin").find("out of the level's own folder"), std::string::npos);
    EXPECT_NE(from("none.bin").find("missing"), std::string::npos);
    EXPECT_NE(from("below").find("missing"), std::string::npos); // a folder is no file
}

TEST_F(Gltf, RefusesJsonNestedWithoutEnd)
{
    std::string deep = R"({"asset":{"version":"2.0"},"extras":)";
    for (int i = 0; i < 100000; ++i) deep += '[';
    for (int i = 0; i < 100000; ++i) deep += ']';
    EXPECT_NE(sentence(written(bytesOf(deep + "}"), "deep.gltf")).find("nested too deeply"), std::string::npos);
}

// Whatever is cut off or changed: a level or one sentence, never a crash.
TEST_F(Gltf, SurvivesEveryTruncationAndFlippedBytes)
{
    json one = triangle();
    one["indices"] = indices({0, 1, 2});
    one["material"] = add("materials", {{"name", "m"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    add("textures", {{"source", 0}});
    const Image8 image{2, 2, 4, std::vector<std::uint8_t>(16, 200)};
    const std::vector<std::uint8_t> png = encodePng(image);
    add("images", {{"bufferView", view(png.data(), png.size())}, {"mimeType", "image/png"}});
    const std::size_t where = floats({1, 2, 3, 4, 5, 6}, "VEC3");
    place(one, {{"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", where}}}}}}}});
    add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
    node({{"camera", 0}});
    const std::vector<std::uint8_t> whole = glb();
    ASSERT_EQ(sentence(written(whole)), "");

    for (std::size_t size = 0; size < whole.size(); size += 16)
        EXPECT_NE(sentence(written({whole.begin(), whole.begin() + std::ptrdiff_t(size)})), "") << size << " bytes";

    std::uint32_t state = 1; // a congruential generator: the same bytes each time
    const auto next = [&] { return (state = state * 1664525u + 1013904223u) >> 8; };
    for (int round = 0; round < 2000; ++round) {
        std::vector<std::uint8_t> file = whole;
        for (int flips = 0; flips < 1 + round % 3; ++flips) file[next() % file.size()] = std::uint8_t(next());
        sentence(written(file)); // must return
    }
    // Digits turned into other digits: sizes, offsets, counts and indices that still parse.
    for (std::size_t i = 20; i < whole.size(); ++i) {
        if (!std::isdigit(whole[i])) continue;
        std::vector<std::uint8_t> file = whole;
        file[i] = whole[i] == '9' ? '8' : '9';
        sentence(written(file));
    }
}
}
