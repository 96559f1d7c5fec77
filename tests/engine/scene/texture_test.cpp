// Textures: colour spaces, samplers, transforms, and neutral texels for what cannot be read (H52).
#include "tests/engine/scene/builder.hpp"
#include <cmath>

namespace afterglow::test
{
class TextureTest : public LevelTest
{
protected:
    std::vector<std::uint8_t> png(int width, int height, std::vector<std::uint8_t> pixels)
    {
        return encodePng(Image8{width, height, 4, std::move(pixels)});
    }
    std::size_t embedded(const std::vector<std::uint8_t>& file)
    {
        return add("images", {{"bufferView", view(file.data(), file.size())}, {"mimeType", "image/png"}});
    }
    void baseColor(std::size_t image, json info = json::object())
    {
        info["index"] = add("textures", {{"source", image}});
        add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", std::move(info)}}}});
    }
};

TEST_F(TextureTest, ReadsImagesFromBuffersAndFiles)
{
    baseColor(embedded(png(2, 1, {255, 0, 0, 255, 0, 255, 0, 128})));
    write(folder / "wood grain.png", png(1, 1, {10, 20, 30, 255}));
    baseColor(add("images", {{"uri", "wood%20grain.png"}}));
    const Scene scene = load();
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.textures[0].image.width, 2);
    EXPECT_EQ(scene.textures[0].image.pixels[5], 255);
    EXPECT_EQ(scene.textures[1].image.pixels, (std::vector<std::uint8_t>{10, 20, 30, 255}));
    EXPECT_TRUE(scene.dropped.empty());
}

TEST_F(TextureTest, DecodesColoursButNotNumbers)
{
    const std::size_t image = embedded(png(1, 1, {188, 188, 188, 188}));
    const std::size_t texture = add("textures", {{"source", image}});
    add("materials",
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}, {"metallicRoughnessTexture", {{"index", texture}}}}}});
    const Scene scene = load();
    ASSERT_EQ(scene.textures.size(), 2u);
    const Material& m = scene.materials[0];
    EXPECT_NEAR(texel(scene.textures[m.baseColorTexture.texture], 0, 0).x, 0.5f, 0.005f); // ((188/255 + 0.055)/1.055)^2.4 = 0.5029
    EXPECT_FLOAT_EQ(texel(scene.textures[m.baseColorTexture.texture], 0, 0).w, 188 / 255.0f);
    EXPECT_FLOAT_EQ(texel(scene.textures[m.metallicRoughnessTexture.texture], 0, 0).y, 188 / 255.0f);
}

TEST_F(TextureTest, WrapsAsTheSamplerSays)
{
    const std::size_t image = embedded(png(2, 2, {1, 0, 0, 255, 2, 0, 0, 255, 3, 0, 0, 255, 4, 0, 0, 255}));
    add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
    add("materials", {{"occlusionTexture", {{"index", 0}}}, {"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}}}}}});
    add("textures", {{"source", image}, {"sampler", 0}});
    const Scene scene = load();
    const SceneTexture& texture = scene.textures.at(0);
    EXPECT_EQ(texture.wrapU, Wrap::clamp);
    EXPECT_EQ(texture.wrapV, Wrap::mirror);
    EXPECT_TRUE(texture.nearest);
    const auto code = [&](int x, int y) { return int(std::lround(texel(texture, x, y).x * 255)); };
    EXPECT_EQ(code(-5, 0), 1);
    EXPECT_EQ(code(9, 0), 2);
    EXPECT_EQ(code(0, -1), 1); // mirrored: rows .. 1 0 0 1 1 0 0 1 ..
    EXPECT_EQ(code(0, -2), 3);
    EXPECT_EQ(code(0, 2), 3);
    EXPECT_EQ(code(0, 3), 1);
    EXPECT_EQ(code(0, 4), 1);
    SceneTexture repeating = texture;
    repeating.wrapU = Wrap::repeat;
    EXPECT_EQ(int(std::lround(texel(repeating, -1, 0).x * 255)), 2);
    EXPECT_EQ(int(std::lround(texel(repeating, 2, 0).x * 255)), 1);
}

// The example of KHR_texture_transform: the lower left quadrant, turned.
TEST_F(TextureTest, AppliesTransforms)
{
    const double quarter = std::asin(1.0);
    baseColor(
        embedded(png(1, 1, {0, 0, 0, 255})),
        {{"texCoord", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0, 1}}, {"rotation", quarter}, {"scale", {0.5, 0.5}}}}}}});
    const Scene scene = load();
    const TextureRef& ref = scene.materials[0].baseColorTexture;
    const auto at = [&](float u, float v) {
        return mat2(ref.matrix.x, ref.matrix.y, ref.matrix.z, ref.matrix.w) * vec2(u, v) + ref.offset;
    };
    EXPECT_TRUE(near(vec3(at(0, 0), 0), {0, 1, 0}));
    EXPECT_TRUE(near(vec3(at(1, 0), 0), {0, 0.5f, 0}));
    EXPECT_TRUE(near(vec3(at(0, 1), 0), {0.5f, 1, 0}));
}

TEST_F(TextureTest, SharesWhatIsTheSame)
{
    const std::size_t image = embedded(png(1, 1, {0, 0, 0, 255}));
    for (int i = 0; i < 3; ++i) baseColor(image); // three textures of the file
    const Scene scene = load();
    EXPECT_EQ(scene.textures.size(), 1u);
}

// H52: no power of two, one texel, and as wide as a GPU holds.
TEST_F(TextureTest, TakesOddSizes)
{
    const ivec2 sizes[] = {{3, 5}, {1, 1}, {16384, 1}};
    for (ivec2 size : sizes) baseColor(embedded(png(size.x, size.y, std::vector<std::uint8_t>(std::size_t(4 * size.x * size.y), 7))));
    const Scene scene = load();
    ASSERT_EQ(scene.textures.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(scene.textures[i].image.width, sizes[i].x);
        EXPECT_EQ(scene.textures[i].image.height, sizes[i].y);
        EXPECT_EQ(scene.textures[i].image.pixels.size(), std::size_t(4 * sizes[i].x * sizes[i].y));
    }
    EXPECT_TRUE(scene.warnings.empty());
}

// H52
TEST_F(TextureTest, StandsInForWhatCannotBeRead)
{
    baseColor(add("images", {{"uri", "nowhere.png"}}));
    baseColor(embedded(bytesOf("no picture at all")));
    std::vector<std::uint8_t> cut = png(64, 64, std::vector<std::uint8_t>(64 * 64 * 4, 3));
    cut.resize(40);
    baseColor(embedded(cut));
    add("textures", json::object());
    add("materials", {{"emissiveTexture", {{"index", 3}}}, {"emissiveFactor", {1, 1, 1}}});
    const Scene scene = load();
    ASSERT_EQ(scene.textures.size(), 4u);
    EXPECT_EQ(count(scene, "textures that cannot be read"), 4);
    EXPECT_EQ(scene.warnings.size(), 4u);
    EXPECT_NE((scene.warnings[0] + scene.warnings[1] + scene.warnings[2] + scene.warnings[3]).find("nowhere.png"), std::string::npos);
    for (int i = 0; i < 3; ++i) {
        const SceneTexture& texture = scene.textures[scene.materials[i].baseColorTexture.texture];
        EXPECT_EQ(texture.image.width, 1);
        EXPECT_NEAR(texel(texture, 0, 0).x, 0.5f, 0.005f); // grey: it makes no energy
    }
    EXPECT_EQ(texel(scene.textures[scene.materials[3].emissiveTexture.texture], 0, 0), vec4(0, 0, 0, 1)); // it emits nothing
}

// A PNG header that claims 20000 x 20000: refused before 1.6 GB are allocated.
TEST_F(TextureTest, RefusesAPictureLargerThanAGpuHolds)
{
    std::vector<std::uint8_t> huge = png(1, 1, {0, 0, 0, 255});
    huge[16 + 2] = huge[20 + 2] = 0x4E; // width and height, big endian, are 0x4E01 = 19969
    baseColor(embedded(huge));
    const Scene scene = load();
    EXPECT_EQ(count(scene, "textures that cannot be read"), 1);
    EXPECT_EQ(scene.textures[0].image.width, 1);
}

TEST_F(TextureTest, ReadsImagesFromItsOwnFolderOnly)
{
    write(folder.parent_path() / "secret.png", png(1, 1, {0, 0, 0, 255}));
    baseColor(add("images", {{"uri", "../secret.png"}}));
    EXPECT_NE(sentence().find("out of the level's own folder"), std::string::npos);
}

TEST_F(TextureTest, RefusesAnImagePastTheEndOfItsBuffer)
{
    baseColor(embedded(png(1, 1, {0, 0, 0, 255})));
    gltf["bufferViews"][0]["byteOffset"] = 100000;
    EXPECT_NE(sentence().find("image 0 reaches past the end"), std::string::npos);
}

// The baker's atlas takes uv1, so textures that read TEXCOORD_1 find it in uv0.
TEST_F(TextureTest, MovesTheSecondCoordinatesToTheFirst)
{
    baseColor(embedded(png(1, 1, {0, 0, 0, 255})), {{"texCoord", 1}});
    json one = triangle();
    one["material"] = 0;
    one["attributes"]["TEXCOORD_0"] = floats({0, 0, 0, 0, 0, 0}, "VEC2");
    one["attributes"]["TEXCOORD_1"] = floats({0.25f, 0.5f, 1, 0, 0, 1}, "VEC2");
    place(one);
    const Scene scene = load();
    EXPECT_EQ(scene.materials[0].baseColorTexture.uvSet, 0u);
    EXPECT_EQ(scene.vertices[0].uv0, vec2(0.25f, 0.5f));
    EXPECT_EQ(scene.vertices[0].uv1, vec2(0.25f, 0.5f));
}

TEST_F(TextureTest, TellsOfAMaterialThatReadsBothCoordinates)
{
    const std::size_t texture = add("textures", {{"source", embedded(png(1, 1, {0, 0, 0, 255}))}});
    add("materials", {{"emissiveTexture", {{"index", texture}, {"texCoord", 1}}}, {"normalTexture", {{"index", texture}}}});
    const Scene scene = load();
    EXPECT_EQ(scene.materials[0].emissiveTexture.uvSet, 1u);
    EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST_F(TextureTest, FallsBackToTheFirstCoordinates)
{
    baseColor(embedded(png(1, 1, {0, 0, 0, 255})), {{"texCoord", 3}});
    const Scene scene = load();
    EXPECT_EQ(scene.materials[0].baseColorTexture.uvSet, 0u);
    EXPECT_EQ(scene.warnings.size(), 1u);
}
}
