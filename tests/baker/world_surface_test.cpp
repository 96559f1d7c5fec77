// What stands at a hit: the frame that an anisotropic lobe lies in.
#include "baker/world.hpp"
#include "tests/engine/scene/builder.hpp"
#include <cmath>

namespace afterglow::test
{
// A floor whose texture coordinates run along x and z, or along z and x.
class WorldSurfaceTest : public LevelTest
{
protected:
    Surface seen(double rotation, bool exchanged, vec3 from)
    {
        gltf = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", json::array()}}}}};
        buffer.clear();
        json floor = primitive({-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1});
        floor["indices"] = indices({0, 1, 2, 0, 2, 3});
        floor["attributes"]["TEXCOORD_0"] =
            floats(exchanged ? std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1} : std::vector<float>{0, 0, 0, 1, 1, 1, 1, 0}, "VEC2");
        floor["material"] = add(
            "materials", {{"extensions", {{"KHR_materials_anisotropy", {{"anisotropyStrength", 0.8}, {"anisotropyRotation", rotation}}}}}});
        place(floor);
        const Scene scene = load();
        const World world(scene, Content::everything);
        const Ray ray{from, normalize(-from), kRayFar};
        return world.surfaceAt(ray, world.closestHit(ray));
    }
};

TEST_F(WorldSurfaceTest, AQuarterTurnOfTheAnisotropyExchangesUAndV)
{
    for (const vec3 from : {vec3(0.3f, 1.0f, 0.2f), vec3(0.3f, -1.0f, 0.2f)}) { // the front, the back
        const Surface plain = seen(0.0, false, from), turned = seen(double(kHalfPi), false, from), exchanged = seen(0.0, true, from);
        EXPECT_NEAR(std::abs(dot(plain.frame.tangent, vec3(1, 0, 0))), 1.0f, 1e-6f);
        EXPECT_NEAR(std::abs(dot(exchanged.frame.tangent, vec3(0, 0, 1))), 1.0f, 1e-6f);
        EXPECT_NEAR(std::abs(dot(turned.frame.tangent, exchanged.frame.tangent)), 1.0f, 1e-6f);
        EXPECT_EQ(turned.bsdf.alpha, exchanged.bsdf.alpha);
    }
}

// Embree ends the program at a coordinate beyond 1.844e18 or a NaN; the world answers that nothing is there.
TEST_F(WorldSurfaceTest, MeetsNothingBeyondWhatEmbreeCanBeAsked)
{
    gltf = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", json::array()}}}}};
    buffer.clear();
    place(primitive({-1, 0, -1, -1, 0, 1, 1, 0, 1}));
    const Scene scene = load();
    const World world(scene, Content::everything);
    const float nan = std::nanf("");
    std::vector<Ray> rays;
    for (const float bad : {nan, 2e18f, 1e30f, -INFINITY}) {
        rays.push_back({vec3(0, bad, 0), vec3(0, -1, 0), kRayFar});
        rays.push_back({vec3(-0.5f, 1, 0), vec3(0, bad, 0), kRayFar});
    }
    rays.push_back({vec3(-0.5f, 1, 0), vec3(0, -1, 0), nan});
    std::vector<Hit> hits(rays.size());
    world.closestHits(rays.data(), hits.data(), int(rays.size()));
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(hits[i].distance, kRayFar) << i;
        EXPECT_EQ(world.closestHit(rays[i]).distance, kRayFar) << i;
        EXPECT_EQ(world.transmittance(rays[i]), vec3(1.0f)) << i;
    }
    const Ray good{vec3(-0.5f, 1, 0), vec3(0, -1, 0), kRayFar};
    EXPECT_EQ(world.closestHit(good).distance, 1.0f);
}

// A line in the surface is the same line whoever looks.
TEST_F(WorldSurfaceTest, BrushedLinesLieAlikeFromBothSides)
{
    const Surface front = seen(0.5, false, vec3(0.3f, 1.0f, 0.2f)), back = seen(0.5, false, vec3(0.3f, -1.0f, 0.2f));
    EXPECT_NEAR(std::abs(dot(front.frame.tangent, back.frame.tangent)), 1.0f, 1e-6f);
    EXPECT_NEAR(std::abs(front.frame.tangent.x), std::cos(0.5f), 1e-6f);
}
}
