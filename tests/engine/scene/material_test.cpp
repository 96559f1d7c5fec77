// Materials: defaults of glTF, extensions, flags, and values that are clamped.
#include "tests/engine/scene/builder.hpp"

namespace afterglow::test
{
class MaterialTest : public LevelTest
{
protected:
    Scene scene;

    const Material& material(json source)
    {
        add("materials", std::move(source));
        scene = load();
        return scene.materials.back();
    }
};

TEST_F(MaterialTest, HasTheDefaultsOfGltf)
{
    const Material& m = material(json::object());
    EXPECT_EQ(m.baseColor, vec4(1.0f));
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_EQ(m.roughness, 1.0f);
    EXPECT_EQ(m.ior, 1.5f);
    EXPECT_EQ(m.emission, vec3(0.0f));
    EXPECT_EQ(m.specular, 1.0f);
    EXPECT_EQ(m.specularColor, vec3(1.0f));
    EXPECT_EQ(m.transmission, 0.0f);
    EXPECT_EQ(m.thickness, 0.0f);
    EXPECT_TRUE(std::isinf(m.attenuationDistance));
    EXPECT_EQ(m.alphaCutoff, 0.5f);
    EXPECT_EQ(m.flags, 0u);
    EXPECT_EQ(m.baseColorTexture.texture, -1);
}

TEST_F(MaterialTest, ReadsFactorsAndExtensions)
{
    const Material& m = material(
        {{"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.75}}},
         {"emissiveFactor", {1, 0.5, 0}},
         {"doubleSided", true},
         {"alphaMode", "MASK"},
         {"alphaCutoff", 0.3},
         {"extensions",
          {{"KHR_materials_emissive_strength", {{"emissiveStrength", 20}}},
           {"KHR_materials_specular", {{"specularFactor", 0.6}, {"specularColorFactor", {1, 0.9, 0.8}}}},
           {"KHR_materials_ior", {{"ior", 1.33}}},
           {"KHR_materials_transmission", {{"transmissionFactor", 0.9}}},
           {"KHR_materials_volume", {{"thicknessFactor", 0.02}, {"attenuationDistance", 3}, {"attenuationColor", {0.5, 0.6, 0.7}}}},
           {"KHR_materials_anisotropy", {{"anisotropyStrength", 0.7}, {"anisotropyRotation", 1.5}}}}}});
    EXPECT_EQ(m.baseColor, vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(m.metallic, 0.25f);
    EXPECT_EQ(m.roughness, 0.75f);
    EXPECT_EQ(m.emission, vec3(20, 10, 0));
    EXPECT_EQ(m.specular, 0.6f);
    EXPECT_EQ(m.specularColor, vec3(1, 0.9f, 0.8f));
    EXPECT_EQ(m.ior, 1.33f);
    EXPECT_EQ(m.transmission, 0.9f);
    EXPECT_EQ(m.thickness, 0.02f);
    EXPECT_EQ(m.attenuationDistance, 3.0f);
    EXPECT_EQ(m.attenuationColor, vec3(0.5f, 0.6f, 0.7f));
    EXPECT_EQ(m.anisotropy, 0.7f);
    EXPECT_FLOAT_EQ(m.anisotropyRotation, 1.5f);
    EXPECT_EQ(m.flags, kMaterialDoubleSided | kMaterialAlphaMask);
    EXPECT_EQ(m.alphaCutoff, 0.3f);
    EXPECT_TRUE(scene.dropped.empty());
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(MaterialTest, IsLambertWithoutASpecularLayer)
{
    const json none = {{"KHR_materials_specular", {{"specularFactor", 0}}}};
    EXPECT_EQ(material({{"extensions", none}, {"pbrMetallicRoughness", {{"metallicFactor", 0}}}}).flags, kMaterialLambert);
    EXPECT_EQ(material({{"extensions", none}, {"pbrMetallicRoughness", {{"metallicFactor", 1}}}}).flags, 0u); // a metal reflects
    EXPECT_EQ(material({{"extras", {{"ag_lambert", true}}}}).flags, kMaterialLambert);
    EXPECT_EQ(material({{"extras", {{"ag_lambert", 0}}}}).flags, 0u);
}

TEST_F(MaterialTest, IsAMirrorAsASmoothMetal)
{
    EXPECT_EQ(material({{"pbrMetallicRoughness", {{"roughnessFactor", 0}}}}).flags, kMaterialMirror);
    EXPECT_EQ(material({{"pbrMetallicRoughness", {{"roughnessFactor", 0}, {"metallicFactor", 0}}}}).flags, 0u);
}

TEST_F(MaterialTest, KnowsUnlitBlendAndOpaque)
{
    EXPECT_EQ(material({{"extensions", {{"KHR_materials_unlit", json::object()}}}}).flags, kMaterialUnlit);
    const json faint = {{"baseColorFactor", {1, 1, 1, 0.5}}};
    EXPECT_EQ(material({{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", faint}}).baseColor.w, 0.5f);
    EXPECT_EQ(scene.materials.back().flags, kMaterialAlphaBlend);
    EXPECT_EQ(material({{"pbrMetallicRoughness", faint}}).baseColor.w, 1.0f); // opaque: alpha means nothing
}

// H36
TEST_F(MaterialTest, ClampsAlbedoThatWouldMakeEnergy)
{
    EXPECT_EQ(material({{"pbrMetallicRoughness", {{"baseColorFactor", {1.5, 0.5, -0.25, 1}}}}}).baseColor, vec4(1, 0.5f, 0, 1));
    EXPECT_EQ(count(scene, "albedos outside 0 to 1"), 1);
}

TEST_F(MaterialTest, ClampsNegativeAndEndlessEmission)
{
    EXPECT_EQ(material({{"emissiveFactor", {-1, 2, 0}}}).emission, vec3(0, 2, 0));
    EXPECT_EQ(count(scene, "emissions below 0 or beyond 1e18"), 1);
    EXPECT_EQ(material({{"emissiveFactor", {1e30, 0, 1e-40}}}).emission, vec3(1e18f, 0, 0));
}

TEST_F(MaterialTest, ReadsTheRoughnessOfDiffuseSurfaces)
{
    EXPECT_FLOAT_EQ(material({{"extras", {{"ag_sigma_deg", 30}}}}).sigma, radians(30.0f));
}

TEST_F(MaterialTest, IsGreyPlasterWhereAPrimitiveNamesNone)
{
    place(triangle());
    scene = load();
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].metallic, 0.0f);
    EXPECT_EQ(scene.materials[0].baseColor, vec4(0.8f, 0.8f, 0.8f, 1));
    EXPECT_EQ(scene.materialNames[0], "plaster");
    EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST_F(MaterialTest, SaysWhichFieldIsWrong)
{
    add("materials", {{"alphaCutoff", "half"}});
    EXPECT_NE(sentence().find("level.glb"), std::string::npos);
}
}
