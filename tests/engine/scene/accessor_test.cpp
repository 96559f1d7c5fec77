// Numbers as glTF stores them: component types, normalization, strides, sparse, and ranges that reach too far.
#include "tests/engine/scene/builder.hpp"

namespace afterglow::test
{
using Accessor = LevelTest;

TEST_F(Accessor, ReadsEveryTypeOfIndex)
{
    for (int type : {5121, 5123, 5125}) {
        json one = triangle();
        one["indices"] = type == 5121   ? accessor(std::vector<std::uint8_t>{0, 1, 2}, type, "SCALAR")
                         : type == 5123 ? accessor(std::vector<std::uint16_t>{0, 1, 2}, type, "SCALAR")
                                        : accessor(std::vector<std::uint32_t>{0, 1, 2}, type, "SCALAR");
        place(one);
    }
    EXPECT_EQ(triangles(load()), 3u);
}

TEST_F(Accessor, RefusesIndicesThatAreNoUnsignedIntegers)
{
    json one = triangle();
    one["indices"] = accessor(std::vector<std::int16_t>{0, 1, 2, 0}, 5122, "SCALAR");
    place(one);
    EXPECT_NE(sentence().find("no unsigned integer"), std::string::npos);
}

TEST_F(Accessor, ScalesNormalizedIntegers)
{
    json one = triangle();
    one["attributes"]["TEXCOORD_0"] = accessor(std::vector<std::uint16_t>{0, 65535, 32768, 0, 0, 65535}, 5123, "VEC2", true);
    one["attributes"]["COLOR_0"] = accessor(std::vector<std::uint8_t>{255, 0, 51, 102, 255, 255, 255, 255, 0, 0, 0, 0}, 5121, "VEC4", true);
    // -128 and -127 are both -1
    one["attributes"]["NORMAL"] = accessor(std::vector<std::int8_t>{0, 0, -128, 0, 0, 0, -127, 0, 0, 0, -127, 0}, 5120, "VEC3", true);
    gltf["bufferViews"].back()["byteStride"] = 4;
    gltf["accessors"].back()["count"] = 3;
    place(one);
    const Scene scene = load();
    EXPECT_EQ(scene.vertices[0].uv0, vec2(0.0f, 1.0f));
    EXPECT_FLOAT_EQ(scene.vertices[1].uv0.x, 32768.0f / 65535.0f);
    EXPECT_EQ(scene.vertices[0].color, 0x663300FFu); // red in the lowest byte
    EXPECT_TRUE(near(scene.vertices[0].normal, {0, 0, -1}));
}

TEST_F(Accessor, FollowsStrides)
{
    // position and texture coordinate side by side
    const std::vector<float> mixed = {0, 0, 0, 0.25f, 0.5f, 1, 0, 0, 0.75f, 0.5f, 0, 1, 0, 0.25f, 1};
    const std::size_t both = view(mixed.data(), mixed.size() * 4);
    gltf["bufferViews"][both]["byteStride"] = 20;
    const std::size_t position = add("accessors", {{"bufferView", both}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    const std::size_t uv =
        add("accessors", {{"bufferView", both}, {"byteOffset", 12}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}});
    place({{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}}}});
    const Scene scene = load();
    EXPECT_TRUE(near(scene.vertices[2].position, {0, 1, 0}));
    EXPECT_EQ(scene.vertices[1].uv0, vec2(0.75f, 0.5f));
}

TEST_F(Accessor, ReplacesSparseElements)
{
    json one = triangle();
    const std::vector<float> moved = {0, 5, 0};
    const std::vector<std::uint16_t> which = {2};
    gltf["accessors"][0]["sparse"] = {{"count", 1},
                                      {"indices", {{"bufferView", view(which.data(), 2)}, {"componentType", 5123}}},
                                      {"values", {{"bufferView", view(moved.data(), 12)}}}};
    place(one);
    const Scene scene = load();
    EXPECT_TRUE(near(scene.vertices[1].position, {1, 0, 0}));
    EXPECT_TRUE(near(scene.vertices[2].position, {0, 5, 0}));
}

TEST_F(Accessor, TakesZerosWhereASparseOneHasNoBase)
{
    const std::vector<float> values = {1, 0, 0, 0, 1, 0};
    const std::vector<std::uint8_t> which = {1, 2};
    const std::size_t position = add("accessors", {{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    gltf["accessors"][position]["sparse"] = {{"count", 2},
                                             {"indices", {{"bufferView", view(which.data(), 2)}, {"componentType", 5121}}},
                                             {"values", {{"bufferView", view(values.data(), 24)}}}};
    place({{"attributes", {{"POSITION", position}}}});
    EXPECT_EQ(triangles(load()), 1u);
}

TEST_F(Accessor, RefusesRangesThatReachTooFar)
{
    const auto with = [&](const char* list, const char* field, json value) {
        const json before = gltf;
        const std::vector<std::uint8_t> bytes = buffer;
        place(triangle());
        gltf[list].back()[field] = std::move(value);
        const std::string found = sentence();
        gltf = before;
        buffer = bytes;
        return found;
    };
    EXPECT_NE(with("accessors", "count", 4).find("past the end"), std::string::npos);
    EXPECT_NE(with("accessors", "count", 1ull << 40).find("past the end"), std::string::npos);
    EXPECT_NE(with("accessors", "count", ~0ull).find("level.glb"), std::string::npos);
    EXPECT_NE(with("accessors", "byteOffset", 4).find("past the end"), std::string::npos);
    EXPECT_NE(with("accessors", "bufferView", 7).find("level.glb"), std::string::npos);
    EXPECT_NE(with("bufferViews", "byteLength", 1000).find("past the end of its buffer"), std::string::npos);
    EXPECT_NE(with("bufferViews", "byteOffset", ~0ull - 8).find("level.glb"), std::string::npos);
    EXPECT_NE(with("bufferViews", "buffer", 3).find("level.glb"), std::string::npos);
}

// Nothing in the file pays for these elements: refused before they are allocated.
TEST_F(Accessor, RefusesAClaimWithoutABuffer)
{
    const std::size_t position = add("accessors", {{"componentType", 5126}, {"count", 1ull << 33}, {"type", "VEC3"}});
    place({{"attributes", {{"POSITION", position}}}});
    EXPECT_NE(sentence().find("claims"), std::string::npos);
}
}
