// The ag_ keys: each where design says, lenient about how Blender writes them, and told when they mean nothing.
#include "engine/scene/repair.hpp"
#include "tests/engine/scene/builder.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace afterglow::test
{
using ExtrasTest = LevelTest;

// Twelve triangles from (0, 0, 0) to (1, 1, 1).
static std::vector<float> unitCube()
{
    std::vector<float> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1})
            for (const std::array<int, 2> at : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
                vec3 corner;
                corner[axis] = float(side);
                corner[(axis + 1) % 3] = float(at[0]);
                corner[(axis + 2) % 3] = float(at[1]);
                corners.insert(corners.end(), {corner.x, corner.y, corner.z});
            }
    return corners;
}

TEST_F(ExtrasTest, SetTheSky)
{
    extras() = {{"ag_sky_radiance", {0.5, 1, 2}}, {"ag_sky_strength", 2}, {"ag_sky_rotation_deg", 90}};
    const Scene scene = load();
    EXPECT_EQ(scene.sky.radiance, vec3(1, 2, 4));
    EXPECT_FLOAT_EQ(scene.sky.rotation, radians(90.0f));
    EXPECT_TRUE(scene.sky.image.pixels.empty());
}

TEST_F(ExtrasTest, DefaultToABlackSky) { EXPECT_EQ(load().sky.radiance, vec3(0.0f)); }

// H49: bad texels are replaced, their neighbours are not touched.
TEST_F(ExtrasTest, ReadASkyImage)
{
    Image image(4, 2, 3);
    for (float& value : image.pixels) value = 0.25f;
    image.at(1, 0)[0] = -1.0f;
    image.at(2, 0)[0] = 3e38f; // as a number it may be 1e18
    writeExr(folder / "sky.exr", image);
    extras() = {{"ag_sky_image", "sky.exr"}, {"ag_sky_strength", 3}};
    const Scene scene = load();
    EXPECT_EQ(scene.sky.radiance, vec3(3.0f)); // a tint of the image
    ASSERT_EQ(scene.sky.image.width, 4);
    EXPECT_EQ(scene.sky.image.at(1, 0)[0], 0.0f);
    EXPECT_EQ(scene.sky.image.at(1, 0)[1], 0.25f);
    EXPECT_EQ(scene.sky.image.at(0, 0)[0], 0.25f);
    EXPECT_EQ(scene.sky.image.at(2, 0)[0], 1e18f);
    EXPECT_EQ(count(scene, "sky texels that are no radiance"), 2);
}

// H49: what our own writer of images never writes.
TEST(RepairRadiance, ReplacesWhatIsNoNumberAndNothingElse)
{
    Image image(4, 1, 3);
    for (float& value : image.pixels) value = 0.25f;
    image.at(1, 0)[0] = std::nanf("");
    image.at(1, 0)[1] = std::numeric_limits<float>::infinity();
    image.at(1, 0)[2] = -std::numeric_limits<float>::infinity();
    image.at(2, 0)[0] = -1.0f;
    Dropped dropped;
    repairRadiance(image, dropped);
    EXPECT_EQ(image.pixels, (std::vector<float>{0.25f, 0.25f, 0.25f, 0.0f, kHalfMax, 0.0f, 0.0f, 0.25f, 0.25f, 0.25f, 0.25f, 0.25f}));
    EXPECT_EQ(dropped["sky texels that are no radiance"], 4);
}

TEST_F(ExtrasTest, LeaveAUniformSkyWhereTheImageIsMissing)
{
    extras() = {{"ag_sky_image", "nowhere.exr"}, {"ag_sky_radiance", 2}};
    const Scene scene = load();
    EXPECT_TRUE(scene.sky.image.pixels.empty());
    EXPECT_EQ(scene.sky.radiance, vec3(2.0f));
    EXPECT_EQ(scene.warnings.size(), 1u);
    extras() = {{"ag_sky_image", "nowhere.exr"}};
    EXPECT_EQ(load().sky.radiance, vec3(0.0f));
}

TEST_F(ExtrasTest, ReadASkyImageFromTheLevelsFolderOnly)
{
    extras() = {{"ag_sky_image", "../sky.exr"}};
    EXPECT_NE(sentence().find("out of the level's own folder"), std::string::npos);
}

TEST_F(ExtrasTest, FillTheLevelWithFog)
{
    extras() = {{"ag_fog_scattering", {0.1, 0.2, 0.3}}, {"ag_fog_absorption", 0.05}, {"ag_fog_g", 0.6}};
    place(primitive({3, 0, 0, 6, 0, 0, 3, 4, 0}), {{"extras", {{"ag_static", false}}}}); // its diagonal is 5 m, the margin 0.5 m
    place(primitive({0, 0, 0, 9, 9, 9, 0, 9, 0}), {{"extras", {{"ag_fog_absorption", 1}}}});
    const Scene scene = load();
    ASSERT_EQ(scene.media.size(), 2u);
    EXPECT_EQ(scene.media[0].scattering, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(scene.media[0].absorption, vec3(0.05f));
    EXPECT_EQ(scene.media[0].g, 0.6f);
    EXPECT_EQ(scene.media[0].wholeLevel, 1u);
    EXPECT_TRUE(near(scene.media[0].lower, vec3(2.5f, -0.5f, -0.5f)));
    EXPECT_TRUE(near(scene.media[0].upper, vec3(6.5f, 4.5f, 0.5f)));
    EXPECT_EQ(scene.media[1].wholeLevel, 0u);      // the mist's own
    extras() = {{"ag_fog_scattering", {0, 0, 0}}}; // no medium at all (H53)
    EXPECT_EQ(load().media.size(), 1u);
}

// Whose light would take hours; no less dense one, nor one that swallows it, is spoken of.
TEST_F(ExtrasTest, TellOfFogThatNoPathLeaves)
{
    place(primitive({3, 0, 0, 6, 0, 0, 3, 4, 0}));
    const auto told = [&](double scattering, double absorption) {
        extras() = {{"ag_fog_scattering", scattering}, {"ag_fog_absorption", absorption}};
        const std::vector<std::string> all = load().warnings;
        return std::any_of(all.begin(), all.end(), [](const std::string& line) { return line.find("its fog scatters") != line.npos; });
    };
    EXPECT_TRUE(told(100, 0)); // 6 m
    EXPECT_FALSE(told(1, 0));
    EXPECT_FALSE(told(100, 1));
}

TEST_F(ExtrasTest, FillNothingWithFogWhereNothingIsDrawn)
{
    extras() = {{"ag_fog_scattering", 0.1}};
    const Scene scene = load();
    EXPECT_TRUE(scene.media.empty());
    EXPECT_EQ(scene.warnings, std::vector<std::string>{"the scene: its fog fills the level, and the level draws nothing"});
}

TEST_F(ExtrasTest, TurnAMeshIntoAMedium)
{
    place(primitive(unitCube()),
          {{"translation", {1, 2, 3}}, {"scale", {2, 4, 6}}, {"extras", {{"ag_fog_scattering", 0.5}, {"ag_static", false}}}});
    const Scene scene = load();
    EXPECT_TRUE(scene.objects.empty()); // it is not drawn
    EXPECT_TRUE(scene.vertices.empty());
    ASSERT_EQ(scene.media.size(), 1u);
    EXPECT_EQ(scene.media[0].lower, vec3(1, 2, 3));
    EXPECT_EQ(scene.media[0].upper, vec3(3, 6, 9));
    EXPECT_EQ(scene.media[0].planeCount, 0u); // the box is the mesh
    EXPECT_TRUE(scene.warnings.empty());
}

// A turned mesh is no box along the axes: its own sides bound the medium, wherever the level's origin lies.
TEST_F(ExtrasTest, TurnATurnedMeshIntoABodyOfItsSides)
{
    const double half = std::sin(0.125 * 3.14159265358979); // of 45 degrees about z
    place(primitive(unitCube()), {{"translation", {1e6, 0, 0}},
                                  {"rotation", {0, 0, half, std::cos(0.125 * 3.14159265358979)}},
                                  {"extras", {{"ag_fog_scattering", 0.5}}}});
    place(primitive({0, 0, 0, 1, 0, 0, 0, 1, 0}), {{"translation", {1e6, 0, 0}}}); // what is drawn says where the origin is
    const Scene scene = load();
    ASSERT_EQ(scene.media.size(), 1u);
    ASSERT_EQ(scene.media[0].planeCount, 6u);
    const vec3 middle = vec3(dvec3(1e6, std::sqrt(0.5), 0.5) - scene.origin);
    for (const vec4& plane : scene.mediumPlanes) EXPECT_NEAR(plane.w - dot(vec3(plane), middle), 0.5f, 1e-5f);
}

TEST_F(ExtrasTest, SayWhenAMeshIsNoBodyThatFogCanFill)
{
    place(primitive({0, 0, 0, 1, 0, 0, 0, 1, 1}), {{"extras", {{"ag_fog_scattering", 0.5}}}});
    const Scene scene = load();
    ASSERT_EQ(scene.media.size(), 1u);
    EXPECT_EQ(scene.media[0].planeCount, 0u);
    EXPECT_EQ(scene.media[0].upper, vec3(1));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("fills the box around it"), std::string::npos);
}

TEST_F(ExtrasTest, LetAMediumGlow)
{
    place(primitive(unitCube()), {{"extras", {{"ag_fog_emission", {1, 2, 3}}}}});
    const Scene scene = load();
    ASSERT_EQ(scene.media.size(), 1u);
    EXPECT_EQ(scene.media[0].emission, vec3(1, 2, 3));
    EXPECT_EQ(scene.media[0].scattering, vec3(0.0f));
}

TEST_F(ExtrasTest, ChooseTheDisplay)
{
    extras() = {{"ag_exposure_ev", -2.5}, {"ag_tone_curve", "reinhard"}, {"ag_bloom", 0.1},
                {"ag_style", "toon"},     {"ag_toon_steps", 4},          {"ag_outline_px", 1.5}};
    const Display display = load().display;
    EXPECT_EQ(display.exposureEv, -2.5f);
    EXPECT_EQ(display.curve, ToneCurve::reinhard);
    EXPECT_EQ(display.bloom, 0.1f);
    EXPECT_TRUE(display.toon);
    EXPECT_EQ(display.toonSteps, 4);
    EXPECT_EQ(display.outlinePixels, 1.5f);
    EXPECT_TRUE(display.toonRamp.empty());
    EXPECT_FALSE(display.outlineCrease.has_value());
    extras() = json::object();
    EXPECT_FALSE(load().display.exposureEv.has_value());
    EXPECT_EQ(load().display.curve, ToneCurve::aces);
}

TEST_F(ExtrasTest, SpeakOfMeshNodes)
{
    place(triangle(), {{"extras", {{"ag_static", 0}, {"ag_texels_per_metre", 32}, {"ag_mirror", 1}, {"ag_portal", "Room"}}}});
    place(triangle());
    const Scene scene = load();
    EXPECT_FALSE(scene.objects[0].isStatic);
    EXPECT_EQ(scene.objects[0].texelsPerMetre, 32.0f);
    EXPECT_TRUE(scene.objects[0].mirror);
    EXPECT_EQ(scene.objects[0].portal, "Room");
    EXPECT_TRUE(scene.objects[1].isStatic);
    EXPECT_EQ(instances(scene)[0].flags, kInstanceMirror);
    EXPECT_EQ(instances(scene)[1].flags, kInstanceStatic);
}

// Blender has a panel for custom properties on the object and one on its mesh or lamp: both are heard, the object's goes first.
TEST_F(ExtrasTest, AreReadFromTheDataOfANodeToo)
{
    const std::size_t shared = mesh(triangle());
    gltf["meshes"][shared]["extras"] = {{"ag_static", 0}, {"ag_texels_per_metre", 8}};
    node({{"mesh", shared}, {"extras", {{"ag_texels_per_metre", 32}}}});
    const Scene scene = load();
    EXPECT_FALSE(scene.objects[0].isStatic);
    EXPECT_EQ(scene.objects[0].texelsPerMetre, 32.0f);
}

TEST_F(ExtrasTest, PlaceProbes)
{
    node({{"name", "Grid"}, {"scale", {4, 3, 5}}, {"translation", {1, 1, 1}}, {"extras", {{"ag_probe_volume", {{"spacing_m", 0.5}}}}}});
    node({{"name", "Flat"}, {"extras", {{"ag_probe_volume", 2}}}});
    node({{"name", "Ball"}, {"translation", {0, 2, 0}}, {"extras", {{"ag_reflection_probe", {{"half_extents_m", {2, 1, 3}}}}}}});
    const Scene scene = load();
    ASSERT_EQ(scene.probeVolumes.size(), 2u);
    EXPECT_EQ(scene.probeVolumes[0].name, "Grid");
    EXPECT_EQ(scene.probeVolumes[0].spacing, 0.5f);
    EXPECT_EQ(vec3(scene.probeVolumes[0].toWorld * vec4(0.5f, 0.5f, 0.5f, 1)), vec3(3, 2.5f, 3.5f));
    EXPECT_EQ(scene.probeVolumes[1].spacing, 2.0f);
    ASSERT_EQ(scene.reflectionProbes.size(), 1u);
    EXPECT_EQ(scene.reflectionProbes[0].position, vec3(0, 2, 0));
    EXPECT_EQ(scene.reflectionProbes[0].halfExtents, vec3(2, 1, 3));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(ExtrasTest, SpellARampOut)
{
    extras() = {{"ag_toon_ramp", {0.1, {0.2, 0.3, 0.4}, 1}}, {"ag_outline_color", {0.5, 0, 0}}, {"ag_outline_crease_deg", 90}};
    const Display even = load().display;
    ASSERT_EQ(even.toonRamp.size(), 3u);
    EXPECT_EQ(even.toonRamp[0].tone, vec3(0.1f));
    EXPECT_EQ(even.toonRamp[1].tone, vec3(0.2f, 0.3f, 0.4f));
    EXPECT_EQ(even.toonRamp[2].edge, 2.0f / 3.0f);
    EXPECT_EQ(even.outlineColor, vec3(0.5f, 0, 0));
    EXPECT_EQ(even.outlineCrease, radians(90.0f));
    extras() = {{"ag_toon_ramp", {0, 1, 2}}, {"ag_toon_edges", {0.5, 0.25}}}; // edges rise
    EXPECT_EQ(load().display.toonRamp[1].edge, 0.5f);
    EXPECT_EQ(load().display.toonRamp[2].edge, 0.5f);
    extras() = {{"ag_toon_ramp", {0, 1, 2}}, {"ag_toon_edges", {0.5}}};
    EXPECT_EQ(load().display.toonRamp[2].edge, 2.0f / 3.0f);
    EXPECT_EQ(load().warnings.size(), 1u);
    extras() = {{"ag_toon_ramp", json::array()}};
    EXPECT_TRUE(load().display.toonRamp.empty());
}

TEST_F(ExtrasTest, GiveAMaterialItsOwnRamp)
{
    add("materials", {{"name", "Skin"}, {"extras", {{"ag_toon_ramp", {0.5, 1}}}}});
    add("materials", {{"name", "Stone"}, {"extras", {{"ag_toon", false}}}});
    const Scene scene = load();
    ASSERT_EQ(scene.toonRamps.size(), 2u);
    EXPECT_EQ(scene.toonRamps.at(0).size(), 2u);
    EXPECT_TRUE(scene.toonRamps.at(1).empty());
}

TEST_F(ExtrasTest, AreToldWhenTheyMeanNothing)
{
    extras() = {{"ag_fog_scatering", 0.1}, {"author", "somebody"}, {"ag_bloom", "much"}, {"ag_style", "cubist"}};
    place(triangle(), {{"name", "Wall"}, {"extras", {{"ag_radius_m", 1}}}}); // of lights
    const Scene scene = load();
    const auto told = [&](const std::string& part) {
        return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                           [&](const std::string& w) { return w.find(part) != std::string::npos; });
    };
    EXPECT_TRUE(told("the scene: ag_fog_scatering means nothing here"));
    EXPECT_TRUE(told("ag_bloom is not a number"));
    EXPECT_TRUE(told("cubist"));
    EXPECT_TRUE(told("node \"Wall\": ag_radius_m means nothing here"));
    EXPECT_FALSE(told("author"));
    EXPECT_EQ(scene.display.bloom, 0.0f);
}

TEST_F(ExtrasTest, AreClamped)
{
    extras() = {{"ag_fog_scattering", {-1, 0.5, 1e30}}, {"ag_fog_g", 3}, {"ag_toon_steps", -4}};
    place(triangle());
    const Scene scene = load();
    EXPECT_EQ(scene.media[0].scattering, vec3(0, 0.5f, 1e18f));
    EXPECT_EQ(scene.media[0].g, 1.0f);
    EXPECT_EQ(scene.display.toonSteps, 1);
    EXPECT_EQ(count(scene, "ag_ extras outside their range"), 3);
}
}
