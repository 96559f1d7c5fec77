// Levels far from their own origin: what is imported lies near the world's, and nothing changes for a level that lies around it (H10).
#include "engine/scene/origin.hpp"
#include "tests/engine/scene/builder.hpp"

namespace afterglow::test
{
TEST(Origin, StaysWhereItIsForALevelAroundIt)
{
    EXPECT_EQ(originOf(Box{}), dvec3(0.0));
    EXPECT_EQ(originOf(Box{dvec3(-1), dvec3(3)}), dvec3(0.0));
    EXPECT_EQ(originOf(Box{dvec3(0), dvec3(1e6)}), dvec3(0.0)) << "large, but beside it";
    EXPECT_EQ(originOf(Box{dvec3(6, 0, 0), dvec3(9, 4, 0)}), dvec3(0.0)) << "middle at 7.8 m, two diagonals are 10 m";
}

TEST(Origin, MovesToTheMiddleInWholeMetres)
{
    EXPECT_EQ(originOf(Box{dvec3(16, 0, 0), dvec3(19.2, 4, 0)}), dvec3(18, 2, 0));
    EXPECT_EQ(originOf(Box{dvec3(1e6, -1e6 - 3, 5), dvec3(1e6 + 2.8, -1e6, 5)}), dvec3(1000001, -1000002, 5)) << "-1000001.5 rounds away";
    EXPECT_EQ(originOf(Box{dvec3(0.3), dvec3(0.31)}), dvec3(0.0)) << "not half a metre out";
}

class FarOriginTest : public LevelTest
{
protected:
    // A wall, a lamp, a camera, fog and a probe, under a parent at `at`.
    Scene loadAt(dvec3 at)
    {
        gltf = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", json::array()}}}}};
        buffer.clear();
        gltf["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
        add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}});
        const std::size_t wall = mesh(triangle()), cloud = mesh(primitive({0, 0, 0, 1, 0, 0, 0, 1, 1}));
        json children = {add("nodes", {{"mesh", wall}, {"translation", {0.1, 0.2, 0.3}}})};
        children.push_back(add("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"translation", {0.1, 0.2, 0.3}}}));
        children.push_back(add("nodes", {{"camera", 0}, {"translation", {0.1, 0.2, 0.3}}}));
        children.push_back(add("nodes", {{"mesh", cloud}, {"extras", {{"ag_fog_scattering", 1}}}, {"translation", {0.1, 0.2, 0.3}}}));
        children.push_back(add("nodes", {{"extras", {{"ag_reflection_probe", 1}}}, {"translation", {0.1, 0.2, 0.3}}}));
        node({{"translation", {at.x, at.y, at.z}}, {"children", children}});
        return load();
    }
};

TEST_F(FarOriginTest, LosesNoDigits)
{
    const Scene near_ = loadAt(dvec3(0.0)), far_ = loadAt(dvec3(1e6, -1e6, 1e6));
    EXPECT_EQ(near_.origin, dvec3(0.0));
    // The middle of the triangle (0.1, 0.2, 0.3) .. (1.1, 1.2, 0.3) is (0.6, 0.7, 0.3)
    ASSERT_EQ(far_.origin, dvec3(1000001, -999999, 1000000));
    const vec3 moved(-1, -1, 0); // of the origin within the level
    EXPECT_TRUE(near(vec3(far_.objects[0].toWorld[3]), vec3(near_.objects[0].toWorld[3]) + moved));
    EXPECT_TRUE(near(far_.lights[0].position, near_.lights[0].position + moved));
    EXPECT_TRUE(near(vec3(far_.cameras[0].toWorld[3]), vec3(near_.cameras[0].toWorld[3]) + moved));
    EXPECT_TRUE(near(far_.media[0].lower, near_.media[0].lower + moved));
    EXPECT_TRUE(near(far_.media[0].upper, near_.media[0].upper + moved));
    EXPECT_TRUE(near(far_.reflectionProbes[0].position, near_.reflectionProbes[0].position + moved));
    EXPECT_TRUE(near(far_.lower, near_.lower + moved));
    EXPECT_TRUE(near(far_.upper, near_.upper + moved));
}
}
