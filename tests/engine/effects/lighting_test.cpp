// Light on single surfaces, against what paper says.
#include "shaders/bsdf.h"
#include "shaders/light.h"
#include "shaders/lightmap.h"
#include "shaders/random.h"
#include "shaders/surface.h"
#include "tests/engine/effects/before_wall.hpp"
#include "tests/engine/upload/solids.hpp"

namespace afterglow
{
class Lighting : public BeforeWall
{
};

TEST_F(Lighting, APointLightFallsWithDistanceAndCosine)
{
    // At the wall's middle: E = I cos / r^2 with the light 3 m aside and 4 m before it: r = 5, cos = 4/5. L = albedo / pi E.
    wall(matte(vec3(0.64f)));
    size = {63, 63}; // a pixel whose centre is the axis
    addLight(scene, pointLight(vec3(3, 0, 2), vec3(100.0f)));
    expectNear(middle(radiance(camera)), vec3(0.64f * kInvPi * 100.0f * 0.8f / 25.0f), kHalfError);
}

TEST_F(Lighting, ADirectionalLightIsItsIrradianceTimesTheCosine)
{
    wall(matte(vec3(0.64f)));
    addLight(scene, sunLight(vec3(1, 0, -1), vec3(5.0f))); // 45 degrees
    expectNear(middle(radiance(camera)), vec3(0.64f * kInvPi * 5.0f * std::sqrt(0.5f)), kHalfError);
}

TEST_F(Lighting, LightFromBehindTheSurfaceGivesNothing)
{
    wall(matte(vec3(0.64f)));
    addLight(scene, sunLight(vec3(0, 0, 1), vec3(5.0f)));
    EXPECT_EQ(middle(radiance(camera)), vec3(0.0f));
}

TEST_F(Lighting, GlossyDirectLightIsTheLawOfTheSurface)
{
    Material shiny = matte(vec3(0.64f, 0.16f, 0.04f));
    shiny.flags = 0u;
    shiny.roughness = 0.4f;
    wall(shiny);
    size = {63, 63};
    addLight(scene, sunLight(vec3(0.3f, 0.2f, -1), vec3(2.0f)));
    Bsdf b;
    b = makeBsdf(shiny, shiny.baseColor, vec2(0.4f, 0.0f), 0.0f, true);
    const vec3 wi = normalize(vec3(-0.3f, -0.2f, 1));                                              // the wall's frame is the world's
    expectNear(middle(radiance(camera)), bsdfEvaluate(b, vec3(0, 0, 1), wi) * 2.0f * wi.z, 5e-3f); // roughness is kept in 8 bits
}

TEST_F(Lighting, ALightmapTexelIsMultipliedByTheAlbedo)
{
    wall(matte(vec3(0.64f)));
    baked = bakedEvenly(scene, vec3(0.5f, 1.0f, 2.0f));
    expectNear(middle(radiance(camera)), 0.64f * vec3(0.5f, 1.0f, 2.0f), 5e-3f); // shared exponent, 2^-9
}

// What has a normal map is lit about the normal that it bends, by the law of shaders/lightmap.h; what has none, as by a flat lightmap.
TEST_F(Lighting, ALightmapKnowsTheNormalsOfANormalMap)
{
    Material bent = matte(vec3(0.5f));
    bent.normalTexture.texture = 0;
    bent.normalScale = 1.0f;
    SceneTexture map;
    map.image = {1, 1, 4, {204, 128, 230, 255}};
    scene.textures.push_back(map);
    wall(bent);
    const vec4 direction(1.5f, 0.0f, 0.5f, 0.5f);
    baked = bakedEvenly(scene, vec3(1.0f));
    baked.lightmaps[0].direction.assign(baked.lightmaps[0].texels.size(), direction);
    const vec3 n = normalize(vec3(204, 128, 230) / 127.5f - 1.0f); // the wall's frame is the world's
    expectNear(middle(radiance(camera)), vec3(0.5f * directionShare(direction, n)), 5e-3f);
    baked.lightmaps[0].direction.assign(baked.lightmaps[0].texels.size(), vec4(-3.0f, 0.0f, 0.0f, 1.0f));
    expectNear(middle(radiance(camera)), vec3(0.0f), 5e-3f); // never less than nothing
    scene.materials[0].normalTexture.texture = -1;
    const vec3 even = middle(radiance(camera));
    baked.lightmaps[0].direction.clear();
    EXPECT_EQ(even, middle(radiance(camera)));
}

TEST_F(Lighting, LightmapsLieAsTheTextureCoordinatesSay)
{
    // v grows downwards in the page, upwards on this wall: the page's upper half lights the wall's lower half.
    addQuad(scene, vec3(-1, -1, -2), vec3(2, 0, 0), vec3(0, 2, 0), addMaterial(scene, matte(vec3(1.0f))));
    baked = bakedEvenly(scene, vec3(0.0f));
    for (int i = 0; i < 4 * 8; ++i) baked.lightmaps[0].texels[std::size_t(i)] = vec3(1.0f);
    const Image picture = radiance(camera);
    EXPECT_NEAR(picture.at(8, 2)[0], 0.0f, 1e-3f);
    EXPECT_NEAR(picture.at(8, 13)[0], 1.0f, 1e-2f);
}

// A room of radiance 1 everywhere: no surface may send back more than it receives; a mirror sends back exactly that (H88).
TEST_F(Lighting, AWhiteRoomShowsNoSurfaceBrighterThanItself)
{
    Material metal = matte(vec3(1.0f));
    metal.flags = 0u;
    metal.metallic = 1.0f;
    for (const float brushed : {0.0f, 0.7f})
        for (const float roughness : {0.0f, 0.3f, 0.6f, 1.0f}) { // what one facet loses the next ones send back (H45)
            scene = Scene{};
            metal.anisotropy = brushed;
            metal.roughness = roughness;
            wall(metal);
            baked = bakedEvenly(scene, vec3(1.0f));
            baked.reflections.push_back(evenReflection(vec3(-9, -9, -2), vec3(9, 9, 9), vec3(1.0f)));
            const float seen = middle(radiance(camera)).x;
            EXPECT_NEAR(seen, 1.0f, roughness == 0.0f ? 5e-3f : 0.01f) << roughness << ", brushed " << brushed;
            EXPECT_LE(seen, 1.0f + 2.0f * kHalfError) << roughness << ", brushed " << brushed;
        }
}

// What the law of the surface sends back of light of radiance 1 from everywhere.
static float whiteAlbedo(const Bsdf& b, float mu)
{
    constexpr uint kDirections = 1u << 14;
    const BsdfView view = viewBsdf(b, vec3(std::sqrt(1.0f - mu * mu), 0.0f, mu));
    double sum = 0.0;
    for (uint i = 0; i < kDirections; ++i) {
        shared::Sampler random = makeSampler(7u, i);
        const float lobe = next1(random);
        sum += double(sampleBsdf(b, view, lobe, next2(random)).weight.x);
    }
    return float(sum / kDirections);
}

// A rough white metal sends back what its law does, no more and no less, at every roughness and angle: the split sum's table, what is read
// between its entries, and what several facets add, agree with the path tracer, and with what it receives (H45).
TEST_F(Lighting, AWhiteRoomShowsMetalsAsTheirLawHasThem)
{
    Material metal = matte(vec3(1.0f));
    metal.flags = 0u;
    metal.metallic = 1.0f;
    for (const float roughness : {0.1f, 0.25f, 0.5f, 0.75f, 1.0f})
        for (const float mu : {0.17f, 0.5f, 0.87f}) { // 80, 60, 30 degrees
            scene = Scene{};
            metal.roughness = roughness;
            wall(metal);
            baked = bakedEvenly(scene, vec3(1.0f));
            baked.reflections.push_back(evenReflection(vec3(-9, -9, -2), vec3(9, 9, 9), vec3(1.0f)));
            const vec3 at(0, 0, -2), toEye(std::sqrt(1.0f - mu * mu), 0.0f, mu);
            const float seen = middle(radiance(lookAt(at + 2.0f * toEye, at, 0.001f))).x;
            const Bsdf law = makeBsdf(metal, metal.baseColor, vec2(roughness, 1.0f), 0.0f, true);
            EXPECT_NEAR(seen, whiteAlbedo(law, mu), 0.01f) << roughness << " at " << mu;
            EXPECT_NEAR(seen, 1.0f, 0.01f) << roughness << " at " << mu;
        }
}

// A ball of eight pixels is as white: its normals turn within a pixel, which widens what it mirrors (geometry) and loses no light.
TEST_F(Lighting, AWhiteRoomShowsAMetalBallAsWhite)
{
    Material metal = matte(vec3(1.0f));
    metal.flags = 0u;
    metal.metallic = 1.0f;
    for (const float roughness : {0.0f, 0.1f, 0.5f, 1.0f}) {
        scene = Scene{};
        scene.sky.radiance = vec3(1.0f);
        metal.roughness = roughness;
        addSphere(scene, addMaterial(scene, metal), 96);
        baked = bakedEvenly(scene, vec3(1.0f));
        baked.reflections.push_back(evenReflection(vec3(-9), vec3(9), vec3(1.0f)));
        Camera from = lookAt(vec3(0, 0, 5), vec3(0));
        from.fovY = 0.0f;
        from.orthoHeight = 4.0f;
        const Image image = radiance(from);
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) EXPECT_NEAR(image.pixels[i], 1.0f, 0.01f) << roughness << " at " << i / 4;
    }
}

// A rough one under a sun sends what the law has it send: what one facet reflects, and what several do.
TEST_F(Lighting, DirectLightOnARoughMetalIsTheLawOfTheSurface)
{
    Material metal = matte(vec3(0.64f, 0.16f, 0.04f));
    metal.flags = 0u;
    metal.metallic = 1.0f;
    metal.roughness = 0.8f; // 204 / 255
    wall(metal);
    size = {63, 63};
    addLight(scene, sunLight(vec3(1.5f, 0.2f, -1), vec3(2.0f)));
    const Bsdf law = makeBsdf(metal, metal.baseColor, vec2(metal.roughness, 1.0f), 0.0f, true);
    const vec3 wi = normalize(vec3(-1.5f, -0.2f, 1)), wo(0, 0, 1); // the wall's frame is the world's
    expectNear(middle(radiance(camera)), bsdfEvaluate(law, wo, wi) * 2.0f * wi.z, kHalfError);
    EXPECT_GT(againValue(law, viewBsdf(law, wo), wi).x, 0.2f * bsdfEvaluate(law, wo, wi).x); // several facets have a say in it
}

// A white matte body under a rough clear layer, upright to grazing: what the layer does not send back its base receives, no more, whether
// probes say what the layer mirrors or nobody does. The law itself loses a little between the facets, and the layer's table is a bound.
TEST_F(Lighting, AWhiteRoomShowsNoPlasticBrighterThanItself)
{
    Material plastic = matte(vec3(1.0f));
    plastic.flags = 0u;
    for (const bool probed : {false, true})
        for (const float roughness : {0.2f, 0.4f, 0.6f, 1.0f})
            for (const float mu : {0.03f, 0.1f, 0.3f, 1.0f}) {
                scene = Scene{};
                plastic.roughness = roughness;
                wall(plastic);
                baked = bakedEvenly(scene, vec3(1.0f));
                if (probed) baked.reflections.push_back(evenReflection(vec3(-9, -9, -2), vec3(9, 9, 9), vec3(1.0f)));
                const vec3 at(0, 0, -2), toEye(std::sqrt(1.0f - mu * mu), 0.0f, mu);
                const float seen = middle(radiance(lookAt(at + 2.0f * toEye, at, 0.001f))).x;
                const Bsdf law = makeBsdf(plastic, plastic.baseColor, vec2(roughness, 0.0f), 0.0f, true);
                EXPECT_LE(seen, 1.0f + 2.0f * kHalfError) << roughness << " at " << mu;
                EXPECT_NEAR(seen, whiteAlbedo(law, mu), 0.05f) << roughness << " at " << mu << (probed ? " by probes" : "");
            }
}

TEST_F(Lighting, AMirrorShowsTheProbeWhereTheRayMeetsItsBox)
{
    // The wall mirrors straight back: face +z of the cube is red, the others black.
    Material metal = matte(vec3(1.0f));
    metal.flags = 0u;
    metal.metallic = 1.0f;
    metal.roughness = 0.0f;
    wall(metal);
    baked = bakedEvenly(scene, vec3(0.0f));
    ReflectionProbe probe = evenReflection(vec3(-2), vec3(2), vec3(0.0f));
    for (auto& mip : probe.mips)
        for (std::size_t i = mip.size() * 4 / 6; i < mip.size() * 5 / 6; ++i) mip[i] = vec3(1, 0, 0);
    baked.reflections.push_back(probe);
    expectNear(middle(radiance(camera)), vec3(1, 0, 0), 2e-2f);
}

TEST_F(Lighting, EmissionLeavesTheFrontOnlyUnlessTheMaterialIsDoubleSided)
{
    Material lamp = matte(vec3(0.0f));
    lamp.emission = vec3(3.0f, 2.0f, 1.0f);
    wall(lamp);
    expectNear(middle(radiance(camera)), lamp.emission, kHalfError);
    const Camera behind = lookAt(vec3(0, 0, -4), vec3(0, 0, -2));
    EXPECT_EQ(middle(radiance(behind)), vec3(0.0f));
    scene.materials[0].flags |= kMaterialDoubleSided;
    expectNear(middle(radiance(behind)), lamp.emission, kHalfError);
}

TEST_F(Lighting, UnlitIsTheColourItself)
{
    Material unlit = matte(vec3(0.25f, 0.5f, 1.0f));
    unlit.flags |= kMaterialUnlit;
    wall(unlit);
    addLight(scene, sunLight(vec3(0, 0, -1), vec3(50.0f)));
    expectNear(middle(radiance(camera)), vec3(0.25f, 0.5f, 1.0f), kHalfError);
}

TEST_F(Lighting, BlendingMixesByAlpha)
{
    // A white lamp behind a red unlit pane of alpha 1/4: 3/4 white + 1/4 red.
    Material lamp = matte(vec3(0.0f)), pane = matte(vec3(1, 0, 0));
    lamp.emission = vec3(1.0f);
    pane.flags |= kMaterialUnlit | kMaterialAlphaBlend;
    pane.baseColor.w = 0.25f;
    wall(lamp);
    addQuad(scene, vec3(-9, -9, -1), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, pane));
    expectNear(middle(radiance(camera)), vec3(1.0f, 0.75f, 0.75f), 5e-3f);
}

TEST_F(Lighting, ClearWaterShowsWhatLiesBelow)
{
    // Seen straight on, an interface of index 1.333 reflects 2 %: the lamp behind it is dimmed by no more than that twice.
    Material lamp = matte(vec3(0.0f)), water = matte(vec3(1.0f));
    lamp.emission = vec3(1.0f);
    water.flags = 0u;
    water.transmission = 1.0f;
    water.roughness = 0.0f;
    water.ior = 1.333f;
    wall(lamp);
    addQuad(scene, vec3(-9, -9, -1), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, water));
    const float seen = middle(radiance(camera)).x;
    EXPECT_LT(seen, 1.0f);
    EXPECT_GT(seen, 0.95f);
}

TEST_F(Lighting, TheSkysImageTurnsAsTheLawSays)
{
    // Eight columns, the one that holds +x is green: u = 1/2 looks along +x.
    scene.sky.radiance = vec3(1.0f);
    scene.sky.image = Image(8, 4, 3);
    for (int y = 0; y < 4; ++y)
        for (int x = 3; x < 5; ++x) scene.sky.image.at(x, y)[1] = 1.0f;
    expectNear(middle(radiance(lookAt(vec3(0), vec3(1, 0, 0), 0.1f))), vec3(0, 1, 0), 1e-2f);
    EXPECT_LT(middle(radiance(lookAt(vec3(0), vec3(-1, 0, 0), 0.1f))).y, 1e-3f);
}

TEST(MeanSky, OfAnImageWeighsRowsByTheirSolidAngle)
{
    // The upper half is 1: half of the sphere, whatever the number of rows.
    Sky sky;
    sky.radiance = vec3(2.0f);
    sky.image = Image(6, 10, 3);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 6; ++x) sky.image.at(x, y)[0] = 1.0f;
    EXPECT_NEAR(meanSky(sky).x, 1.0f, 1e-5f);
    EXPECT_EQ(meanSky(sky).y, 0.0f);
}
}
