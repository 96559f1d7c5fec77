// Punctual lights: placed and aimed by their node, in the level's own units.
#include "shaders/constants.h"
#include "shaders/spectrum.h"
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

// Its own colour times a black body's, at the luminance that it has without; what Rec.709 lacks of embers is made up by grey.
TEST_F(LightTest, HasTheColourOfItsTemperature)
{
    const auto lamp = [&](vec3 color, double kelvin) {
        light({{"type", "point"}, {"color", {color.x, color.y, color.z}}, {"intensity", 8}}, {{"extras", {{"ag_kelvin", kelvin}}}});
    };
    lamp(vec3(1), 2856), lamp(vec3(1, 0.5f, 0.25f), 6500), lamp(vec3(1), 1500);
    const Scene scene = load();
    ASSERT_EQ(scene.lights.size(), 3u);
    const vec2 bulb = chromaticity(rec709ToXyz(scene.lights[0].intensity));
    EXPECT_NEAR(bulb.x, 0.446229994f, 2e-5f);
    EXPECT_NEAR(bulb.y, 0.4086558608f, 2e-5f);
    const vec3 tint = scene.lights[1].intensity / blackbodyColor(6500.0f);
    EXPECT_NEAR(tint.y / tint.x, 0.5f, 1e-6f);
    EXPECT_NEAR(tint.z / tint.x, 0.25f, 1e-6f);
    EXPECT_EQ(scene.lights[2].intensity.z, 0.0f);
    for (uint i : {0u, 2u}) EXPECT_NEAR(luminance(scene.lights[i].intensity), 8.0f, 1e-5f);
    EXPECT_NEAR(luminance(scene.lights[1].intensity), 8.0f * luminance(vec3(1, 0.5f, 0.25f)), 1e-5f);
    ASSERT_EQ(scene.hotLights.size(), 3u);
    EXPECT_EQ(scene.hotLights.at(0).temperature, 2856.0f);
    EXPECT_TRUE(near(scene.hotLights.at(0).tint * blackbodyXyz(2856.0f).y, vec3(8), 1e-5f));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LightTest, IsToldWhereNothingGlowsLikeThat)
{
    for (const json& kelvin : {json(300), json(1e6), json("warm")})
        light({{"type", "point"}, {"intensity", 8}}, {{"name", "Lamp"}, {"extras", {{"ag_kelvin", kelvin}}}});
    light({{"type", "point"}, {"color", {0, 0, 1}}, {"intensity", 8}}, {{"extras", {{"ag_kelvin", 1200}}}}); // embers have no blue
    const Scene scene = load();
    ASSERT_EQ(scene.warnings.size(), 4u);
    EXPECT_EQ(scene.warnings[0], "node \"Lamp\": ag_kelvin 300 lies outside 1000 to 40000 K, so it is ignored");
    EXPECT_TRUE(scene.hotLights.empty());
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(scene.lights[i].intensity, i < 3 ? vec3(8) : vec3(0, 0, 8));
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
