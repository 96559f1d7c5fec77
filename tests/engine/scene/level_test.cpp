// A level as a whole: what an empty one is, its bounds, its instances, and what was dropped from it.
#include "engine/scene/repair.hpp"
#include "tests/engine/scene/builder.hpp"
#include <limits>

namespace afterglow::test
{
using Level = LevelTest;

// H17
TEST_F(Level, MayBeEmpty)
{
    const Scene scene = load();
    EXPECT_EQ(scene.lower, vec3(0.0f));
    EXPECT_EQ(scene.upper, vec3(0.0f));
    EXPECT_TRUE(instances(scene).empty());
}

TEST_F(Level, IsBoundedByWhatStandsStill)
{
    place(triangle());
    place(triangle(), {{"translation", {50, 0, 0}}, {"extras", {{"ag_static", false}}}});
    EXPECT_EQ(load().upper, vec3(1, 1, 0));
}

TEST_F(Level, IsBoundedByWhatMovesWhenNothingStands)
{
    place(triangle(), {{"translation", {2, 0, 0}}, {"extras", {{"ag_static", false}}}});
    EXPECT_EQ(load().lower, vec3(2, 0, 0));
}

TEST_F(Level, HasAnInstanceForEachPrimitiveInOrder)
{
    json lower = triangle(), upper = primitive({0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0, 0, 2, 0, 2, 0, 0});
    lower["material"] = add("materials", {{"name", "a"}});
    upper["material"] = add("materials", {{"name", "b"}});
    node({{"mesh", add("meshes", {{"primitives", {lower, upper}}})}});
    place(lower);
    const Scene scene = load();
    const std::vector<Instance> all = instances(scene);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].object, 0u);
    EXPECT_EQ(all[1].object, 0u);
    EXPECT_EQ(all[2].object, 1u);
    EXPECT_EQ(all[1].material, 1u);
    EXPECT_EQ(all[1].indexCount, 6u);
    EXPECT_EQ(all[1].firstIndex, 3u);
    EXPECT_EQ(all[1].firstVertex, 3u);
    for (const Instance& instance : all) EXPECT_EQ(instance.lightmap, -1);
}

TEST_F(Level, IsNoDifferentForWhatWasDropped)
{
    place(triangle());
    const Scene clean = load();
    gltf["meshes"][0]["primitives"][0] = primitive({7, 7, 7, 7, 7, 7, 8, 8, 8, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    const Scene repaired = load();
    ASSERT_EQ(repaired.vertices.size(), clean.vertices.size());
    for (std::size_t i = 0; i < clean.vertices.size(); ++i)
        EXPECT_EQ(std::memcmp(&clean.vertices[i], &repaired.vertices[i], sizeof(Vertex)), 0);
    EXPECT_EQ(clean.indices, repaired.indices);
}

TEST(Repair, ReplacesTexelsThatAreNoRadiance)
{
    Image image(3, 1, 3);
    const float inf = std::numeric_limits<float>::infinity();
    image.pixels = {NAN, 1, 2, -1, inf, -inf, 1e-40f, 3, 1e30f};
    Dropped dropped;
    repairRadiance(image, dropped);
    EXPECT_EQ(image.pixels, (std::vector<float>{0, 1, 2, 0, 65504, 0, 0, 3, 1e18f}));
    EXPECT_EQ(dropped.at("sky texels that are no radiance"), 5);
}

TEST(Repair, ClampsToTheNearestBound)
{
    Dropped dropped;
    EXPECT_EQ(clamped(0.5, 0, 1, dropped, "x"), 0.5f);
    EXPECT_EQ(clamped(1e-42, 0, 1, dropped, "x"), 0.0f);
    EXPECT_TRUE(dropped.empty());
    EXPECT_EQ(clamped(NAN, 0, 1, dropped, "x"), 0.0f);
    EXPECT_EQ(clamped(7, 0, 1, dropped, "x"), 1.0f);
    EXPECT_EQ(clamped(dvec3(-1, 0, 9), 0, 1, dropped, "x"), vec3(0, 0, 1));
    EXPECT_EQ(dropped.at("x"), 3);
}
}
