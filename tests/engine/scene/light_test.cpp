// Punctual lights: placed and aimed by their node, in the level's own units.
#include "shaders/constants.h"
#include "tests/engine/scene/builder.hpp"
#include <cmath>

namespace afterglow::test
{
class LightTest : public LevelTest
{
protected:
    void light(json source, json placed = json::object())
    {
        json& all = gltf["extensions"]["KHR_lights_punctual"]["lights"];
        placed["extensions"] = {{"KHR_lights_punctual", {{"light", all.size()}}}};
        all.push_back(std::move(source));
        node(std::move(placed));
    }
};

TEST_F(LightTest, IsPlacedByItsNode)
{
    light({{"type", "point"}, {"color", {1, 0.5, 0.25}}, {"intensity", 8}, {"range", 12}},
          {{"name", "Lamp"}, {"translation", {1, 2, 3}}, {"scale", {5, 5, 5}}, {"extras", {{"ag_radius_m", 0.1}, {"ag_bake", "all"}}}});
    const Scene scene = load();
    ASSERT_EQ(scene.lights.size(), 1u);
    const Light& lamp = scene.lights[0];
    EXPECT_EQ(scene.lightNames[0], "Lamp");
    EXPECT_EQ(lamp.type, kLightPoint);
    EXPECT_EQ(lamp.position, vec3(1, 2, 3));
    EXPECT_EQ(lamp.intensity, vec3(8, 4, 2));
    EXPECT_EQ(lamp.range, 12.0f);
    EXPECT_EQ(lamp.radius, 0.1f);
    EXPECT_EQ(lamp.bake, kBakeAll);
}

TEST_F(LightTest, ShinesAlongMinusZ)
{
    const double half = std::sqrt(0.5);
    light({{"type", "directional"}, {"intensity", 3}}, {{"rotation", {-half, 0, 0, half}}, {"extras", {{"ag_sun_angle_deg", 0.526}}}});
    const Scene scene = load();
    EXPECT_EQ(scene.lights[0].type, kLightDirectional);
    EXPECT_TRUE(near(scene.lights[0].direction, {0, -1, 0}));
    EXPECT_NEAR(scene.lights[0].sinAngle, std::sin(0.263 / 180.0 * double(kPi)), 1e-9); // of half the disc's angle
    EXPECT_EQ(scene.lights[0].bake, kBakeIndirect);
    EXPECT_EQ(scene.lights[0].range, 0.0f);
}

TEST_F(LightTest, HasACone)
{
    light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.5}}}});
    light({{"type", "spot"}, {"spot", json::object()}});
    const Scene scene = load();
    EXPECT_FLOAT_EQ(scene.lights[0].cosInner, std::cos(0.2f));
    EXPECT_FLOAT_EQ(scene.lights[0].cosOuter, std::cos(0.5f));
    EXPECT_FLOAT_EQ(scene.lights[1].cosInner, 1.0f);
    EXPECT_FLOAT_EQ(scene.lights[1].cosOuter, std::sqrt(0.5f)); // 45 degrees
}

TEST_F(LightTest, WithoutPowerIsLeftOut)
{
    light({{"type", "point"}, {"intensity", 0}});
    light({{"type", "point"}, {"color", {-1, 0, 0}}});
    light({{"type", "spot"}, {"spot", json::object()}}, {{"scale", {0, 0, 0}}}); // aims nowhere
    const Scene scene = load();
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_EQ(count(scene, "lights without power or direction"), 3);
    EXPECT_EQ(count(scene, "light values outside their range"), 1);
}

TEST_F(LightTest, OfAnUnknownKindIsRefused)
{
    light({{"type", "area"}});
    EXPECT_NE(sentence().find("area"), std::string::npos);
}
}
