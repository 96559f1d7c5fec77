// What a level calls for, in words, and nothing that it does not.
#include "engine/scene/needs.hpp"
#include "tests/engine/scene/builder.hpp"

namespace afterglow::test
{
class NeedsTest : public LevelTest
{
protected:
    // "on, because" or "off, because"
    std::string say(const char* effect)
    {
        const std::vector<Need> all = needs(load());
        const Need& one = need(all, effect);
        return (one.on ? "on, " : "off, ") + one.reason;
    }
    void plate(json material, json source = json::object())
    {
        json one = triangle();
        one["material"] = add("materials", std::move(material));
        place(one, std::move(source));
    }
    void light(const char* type, json extras = json::object())
    {
        json& all = gltf["extensions"]["KHR_lights_punctual"]["lights"];
        node({{"extensions", {{"KHR_lights_punctual", {{"light", all.size()}}}}}, {"extras", std::move(extras)}});
        all.push_back({{"type", type}, {"spot", json::object()}});
    }
    const json kDiffuse = {{"extras", {{"ag_lambert", true}}}};
};

TEST_F(NeedsTest, ABakeOfAllDirectLightCountsLightsThatItWouldIgnore)
{
    plate(kDiffuse);
    light("point", {{"ag_bake", "none"}});
    EXPECT_EQ(say("lightmaps"), "off, nothing in the level gives light");
    EXPECT_EQ(say("probes"), "off, nothing in the level gives light");
    const std::vector<Need> all = needs(load(), /* directAll= */ true);
    EXPECT_EQ(need(all, "lightmaps").reason, "1 static object, and 1 light to bake");
    EXPECT_TRUE(need(all, "lightmaps").on);
    EXPECT_TRUE(need(all, "probes").on);
}

TEST_F(NeedsTest, AreFewForAnEmptyLevel)
{
    for (const Need& need : needs(load())) {
        EXPECT_EQ(need.on, need.effect == "display") << need.effect;
        EXPECT_FALSE(need.reason.empty());
    }
}

TEST_F(NeedsTest, AreAlwaysTheSameQuestions)
{
    std::vector<std::string> asked;
    for (const Need& need : needs(load())) asked.push_back(need.effect);
    EXPECT_EQ(asked, (std::vector<std::string>{"lightmaps", "directional", "probes", "reflections", "lods", "voxels", "geometry", "shadow",
                                               "lighting", "reflection", "fog", "occlusion", "planar", "portal", "toon", "outline", "bloom",
                                               "display"}));
}

TEST_F(NeedsTest, LightmapsWantLightAndSomethingThatStandsStill)
{
    EXPECT_EQ(say("lightmaps"), "off, no static object");
    plate(kDiffuse);
    EXPECT_EQ(say("lightmaps"), "off, nothing in the level gives light");
    extras() = {{"ag_sky_radiance", 1}};
    EXPECT_EQ(say("lightmaps"), "on, 1 static object, and the sky shines");
    light("point");
    EXPECT_EQ(say("lightmaps"), "on, 1 static object, and 1 light to bake");
    plate({{"name", "lamp"}, {"emissiveFactor", {1, 1, 1}}});
    EXPECT_EQ(say("lightmaps"), "on, 2 static objects, and material \"lamp\" emits");
}

TEST_F(NeedsTest, AMaterialThatNothingShowsCallsForNothing)
{
    add("materials", {{"name", "lamp"}, {"emissiveFactor", {1, 1, 1}}, {"pbrMetallicRoughness", {{"roughnessFactor", 0}}}});
    plate(kDiffuse);
    EXPECT_EQ(say("lightmaps"), "off, nothing in the level gives light");
    EXPECT_EQ(say("reflections"), "off, no metal, and nothing else down to roughness 0.5");
    EXPECT_EQ(say("planar"), "off, no ag_mirror and no metal of roughness 0");
}

TEST_F(NeedsTest, ShadowWantsASunOrASpot)
{
    plate(kDiffuse);
    light("point");
    EXPECT_EQ(say("shadow"), "off, no directional or spot light");
    light("directional");
    light("spot");
    EXPECT_EQ(say("shadow"), "on, 1 directional light and 1 spot light");
}

TEST_F(NeedsTest, ReflectionsWantAMetalOrASmoothSurface)
{
    plate(kDiffuse);
    EXPECT_EQ(say("reflections"), "off, no metal, and nothing else down to roughness 0.5");
    plate({{"name", "plaster"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0.6}, {"metallicFactor", 0.0}}}});
    EXPECT_EQ(say("reflections"), "off, no metal, and nothing else down to roughness 0.5");
    plate({{"name", "paint"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0.6}}}});
    EXPECT_EQ(say("reflections"), "on, material \"paint\" reflects at roughness 0.6");
    plate({{"name", "steel"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0.25}}}});
    EXPECT_EQ(say("reflections"), "on, material \"steel\" reflects at roughness 0.25");
}

// A texture makes a surface smoother than its factor.
TEST_F(NeedsTest, ReflectionsSeeRoughnessInTextures)
{
    const std::vector<std::uint8_t> png = encodePng(Image8{2, 1, 4, {0, 255, 0, 255, 0, 51, 0, 255}});
    add("images", {{"bufferView", view(png.data(), png.size())}, {"mimeType", "image/png"}});
    add("textures", {{"source", 0}});
    plate({{"name", "floor"}, {"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}}}}}});
    EXPECT_EQ(say("reflections"), "on, material \"floor\" reflects at roughness 0.2");
}

TEST_F(NeedsTest, FogIsQuotedFromTheExtras)
{
    EXPECT_EQ(say("fog"), "off, no ag_fog_scattering, ag_fog_absorption or ag_fog_emission");
    plate(kDiffuse);
    extras() = {{"ag_fog_scattering", {0.06, 0.06, 0.06}}};
    EXPECT_EQ(say("fog"), "on, scene extras say ag_fog_scattering 0.06");
    extras() = {{"ag_fog_absorption", {0.1, 0.2, 0.3}}};
    EXPECT_EQ(say("fog"), "on, scene extras say ag_fog_absorption 0.1 0.2 0.3");
    extras() = {{"ag_fog_emission", 0.5}};
    EXPECT_EQ(say("fog"), "on, scene extras say ag_fog_emission 0.5");
}

TEST_F(NeedsTest, OcclusionWantsWhatNoLightmapCovers)
{
    plate(kDiffuse);
    EXPECT_EQ(say("occlusion"), "off, every object is static: lightmaps hold it");
    plate(kDiffuse, {{"extras", {{"ag_static", false}}}});
    EXPECT_EQ(say("occlusion"), "on, 1 object is not static, so no lightmap holds the contact");
}

TEST_F(NeedsTest, MirrorsCallForAPlane)
{
    const json asked = {{"ag_mirror", true}};
    plate(kDiffuse, {{"name", "Wall"}, {"extras", asked}});
    EXPECT_EQ(say("planar"), "off, node \"Wall\": its material reflects nothing");
    const json still = {{"pbrMetallicRoughness", {{"roughnessFactor", 0}}}};
    plate(still, {{"name", "Pond"}, {"extras", asked}});
    EXPECT_EQ(say("planar"), "on, 1 plane: \"Pond\"");
    plate(still, {{"name", "Lake"}, {"translation", {0, 0, 5}}, {"extras", asked}});
    EXPECT_EQ(say("planar"), "on, 2 planes: \"Pond\", \"Lake\"");
}

TEST_F(NeedsTest, PortalsWantATwin)
{
    EXPECT_EQ(say("portal"), "off, no ag_portal");
    plate(kDiffuse, {{"name", "Door"}, {"extras", {{"ag_portal", "Gate"}}}});
    EXPECT_EQ(say("portal"), "off, node \"Door\": no mesh node is called \"Gate\"");
    plate(kDiffuse, {{"name", "Gate"}});
    EXPECT_EQ(say("portal"), "on, 1 portal: \"Door\"");
}

TEST_F(NeedsTest, StylesAreAskedFor)
{
    extras() = {{"ag_style", "toon"}, {"ag_outline_px", 2}, {"ag_bloom", 0.25}};
    EXPECT_EQ(say("toon"), "on, scene extras say ag_style toon");
    EXPECT_EQ(say("outline"), "on, scene extras say ag_outline_px 2");
    EXPECT_EQ(say("bloom"), "on, scene extras say ag_bloom 0.25");
}
}
