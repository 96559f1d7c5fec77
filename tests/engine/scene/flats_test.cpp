// Which surfaces are mirrors and portals, and which only say so.
#include "engine/scene/flats.hpp"
#include "tests/engine/scene/builder.hpp"
#include <cmath>

namespace afterglow::test
{
class FlatsTest : public LevelTest
{
protected:
    const json kWater = {{"name", "water"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0}, {"metallicFactor", 0}}}};
    const json kSteel = {{"name", "steel"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0}, {"metallicFactor", 1}}}};
    void plate(json material, json source = json::object())
    {
        json one = triangle();
        one["material"] = add("materials", std::move(material));
        place(one, std::move(source));
    }
    Flats find() { return findFlats(load()); }
};

TEST_F(FlatsTest, AMirrorIsWhatSaysSoOrAMetalOfRoughnessZero)
{
    plate(kWater);
    EXPECT_TRUE(find().mirrors.empty());
    plate(kSteel, {{"translation", {0, 0, 1}}});
    ASSERT_EQ(find().mirrors.size(), 1u);
    EXPECT_NEAR(std::abs(find().mirrors[0].offset), 1.0, 1e-6);
    plate(kWater, {{"translation", {0, 0, 2}}, {"extras", {{"ag_mirror", true}}}});
    EXPECT_EQ(find().mirrors.size(), 2u);
    plate(kWater, {{"translation", {7, 3, 2}}, {"extras", {{"ag_mirror", true}}}}); // in one plane with the one before
    const Flats flats = find();
    ASSERT_EQ(flats.mirrors.size(), 2u);
    EXPECT_EQ(flats.mirrors[1].surfaces.size(), 2u);
    for (const dvec3& corner : flats.mirrors[1].corners) EXPECT_NEAR(dot(flats.mirrors[1].normal, corner), flats.mirrors[1].offset, 1e-6);
}

TEST_F(FlatsTest, WhatReflectsNothingOrBlursIsNone)
{
    const json asked = {{"extras", {{"ag_mirror", true}}}};
    plate({{"extras", {{"ag_lambert", true}}}}, asked);
    plate({{"pbrMetallicRoughness", {{"roughnessFactor", 0.5}}}}, asked);
    plate({{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0}}}}, asked);
    const Flats flats = find();
    EXPECT_TRUE(flats.mirrors.empty());
    EXPECT_EQ(flats.refused.size(), 3u);
}
}
