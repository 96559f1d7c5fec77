// The plan: what is on, why, and what the command line may say about it.
#include "engine/core/error.hpp"
#include "engine/frame/frame.hpp"
#include "engine/frame/plan.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static Scene room()
{
    Scene scene;
    addRoom(scene, vec3(-2), vec3(2), addMaterial(scene, matte(vec3(0.5f))));
    return scene;
}

static Plan planOf(const Scene& scene, const Baked* baked = nullptr, const std::string& effects = "auto")
{
    return plan(needs(scene), evidenceOf(scene, baked), parseOverrides(effects));
}

static std::string reason(const Plan& plan, const std::string& effect)
{
    for (const PlannedEffect& planned : plan.effects)
        if (planned.effect == effect) return planned.reason;
    return "";
}

TEST(Plan, OfAPlainRoomHoldsNoMoreThanAPicture)
{
    const Plan planned = planOf(room());
    for (const char* effect : {"geometry", "lighting", "antialias", "display"}) EXPECT_TRUE(planned.on(effect)) << effect;
    for (const char* effect :
         {"masked", "shadow", "lightmaps", "probes", "reflections", "reflection", "clear", "fog", "upscale", "bloom", "toon", "outline"})
        EXPECT_FALSE(planned.on(effect)) << effect;
    for (const PlannedEffect& effect : planned.effects) EXPECT_FALSE(effect.reason.empty()) << effect.effect;
}

TEST(Plan, TurnsOnWhatTheLevelCallsFor)
{
    Scene scene = room();
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(1)));
    Material glass = matte(vec3(1)), leaf = matte(vec3(1));
    glass.transmission = 1.0f;
    leaf.flags |= kMaterialAlphaMask;
    addQuad(scene, vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), addMaterial(scene, glass));
    addQuad(scene, vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), addMaterial(scene, leaf));
    Medium fog{};
    fog.scattering = vec3(0.06f);
    fog.lower = vec3(-1), fog.upper = vec3(1);
    scene.media.push_back(fog);
    scene.display.bloom = 0.1f;
    scene.display.toon = true;
    scene.display.outlinePixels = 1.5f;
    const Plan planned = planOf(scene);
    for (const char* effect : {"shadow", "masked", "clear", "fog", "bloom", "toon", "outline"}) EXPECT_TRUE(planned.on(effect)) << effect;
}

TEST(Plan, CallsForCascadesWhereOneMapIsTooCoarseForTheSun)
{
    Scene scene = room();
    scene.lower = vec3(-2), scene.upper = vec3(2);
    EXPECT_FALSE(planOf(scene).on("shadow.cascades"));
    EXPECT_EQ(reason(planOf(scene), "shadow.cascades"), "no directional light is drawn here");
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(1)));
    EXPECT_FALSE(planOf(scene).on("shadow.cascades"));
    EXPECT_TRUE(planOf(scene, nullptr, "+shadow.cascades").on("shadow.cascades"));
    scene.lower = vec3(-200, 0, -200), scene.upper = vec3(200, 10, 200); // 566 m across: 276 mm of 2048
    EXPECT_TRUE(planOf(scene).on("shadow.cascades"));
    EXPECT_NE(reason(planOf(scene), "shadow.cascades").find("276 mm"), std::string::npos);
    EXPECT_FALSE(planOf(scene, nullptr, "-shadow.cascades").on("shadow.cascades"));
}

TEST(Plan, CallsForOcclusionWhereNoLightmapHoldsTheContact)
{
    Scene scene = room();
    EXPECT_FALSE(planOf(scene).on("occlusion"));
    EXPECT_EQ(reason(planOf(scene), "occlusion"), "no light from everywhere to dim");
    scene.sky.radiance = vec3(1);
    EXPECT_TRUE(planOf(scene).on("occlusion"));
    EXPECT_EQ(reason(planOf(scene), "occlusion"), "the level is not baked, so no lightmap holds the contact");
    Baked baked = bakedEvenly(scene, vec3(1));
    EXPECT_FALSE(planOf(scene, &baked).on("occlusion"));
    baked.scene.objects[0].isStatic = scene.objects[0].isStatic = false;
    baked.places[0].page = -1;
    EXPECT_TRUE(planOf(scene, &baked).on("occlusion"));
    EXPECT_EQ(reason(planOf(scene, &baked), "occlusion").rfind("1 object is not static", 0), 0u);
}

// Lightmaps hold the contact only while they are drawn, and backs alone call for none; what is in steps shows none.
TEST(Plan, CallsForOcclusionWithoutLightmapsAndNotForBacksOrSurfacesInSteps)
{
    Scene scene = room();
    scene.sky.radiance = vec3(1);
    Baked baked = bakedEvenly(scene, vec3(1));
    EXPECT_TRUE(planOf(scene, &baked, "-lightmaps").on("occlusion"));
    EXPECT_EQ(reason(planOf(scene, &baked, "-lightmaps"), "occlusion"), "no lightmap is drawn that holds the contact");
    baked.scene.materials[0].flags |= kMaterialDoubleSided;
    EXPECT_FALSE(planOf(baked.scene, &baked).on("occlusion"));
    scene.display.toon = true;
    EXPECT_FALSE(planOf(scene).on("occlusion"));
    EXPECT_EQ(reason(planOf(scene), "occlusion"), "surfaces in steps show no contact");
    EXPECT_TRUE(planOf(scene, nullptr, "-toon").on("occlusion"));
    scene.toonRamps[0] = {}; // the material stays out of the style
    EXPECT_TRUE(planOf(scene).on("occlusion"));
}

// Of what is drawn in the end, whatever the level calls for.
TEST(Plan, SaysWhatKeepsShadowMapsBesideRays)
{
    Scene scene = room();
    addLight(scene, pointLight(vec3(0), vec3(1)));
    Evidence evidence = evidenceOf(scene, nullptr);
    evidence.tracedShadows = true;
    const auto how = [&](const std::string& effects) {
        const std::string all = reason(plan(needs(scene), evidence, parseOverrides(effects)), "shadow");
        return all.substr(all.find(", by ") + 2);
    };
    EXPECT_EQ(how("auto"), "by ray query");
    EXPECT_EQ(how("+fog"), "by ray query; by maps in the air");
    EXPECT_EQ(how("+clear,+planar,+portal"), "by ray query; by maps on clear surfaces, in mirrors, beyond portals");
    Medium air{};
    air.scattering = vec3(0.1f);
    scene.media.push_back(air);
    EXPECT_EQ(how("auto"), "by ray query; by maps in the air");
    EXPECT_EQ(how("-fog"), "by ray query");
}

// A filter where few rays scatter: to lights that have a size, and over the hemisphere.
TEST(Plan, CallsForAFilterWhereRaysScatter)
{
    Scene scene = room();
    scene.sky.radiance = vec3(1);
    addLight(scene, pointLight(vec3(0), vec3(1)));
    Settings settings;
    const auto planned = [&](const std::string& effects = "") {
        return plan(needs(scene), evidenceOf(scene, nullptr, settings), parseOverrides(effects));
    };
    EXPECT_EQ(reason(planned(), "shadow.denoise"), "no shadow is traced");
    EXPECT_EQ(reason(planned(), "occlusion.denoise"), "no contact is traced");
    settings.shadowMethod = ShadowMethod::ray;
    settings.occlusionMethod = OcclusionMethod::ray;
    EXPECT_FALSE(planned().on("shadow.denoise"));
    EXPECT_EQ(reason(planned(), "shadow.denoise"), "every light is a point");
    EXPECT_TRUE(planned().on("occlusion.denoise"));
    scene.lights[0].radius = 0.1f;
    EXPECT_TRUE(planned().on("shadow.denoise"));
    EXPECT_EQ(reason(planned(), "shadow.denoise"), "few rays to 1 light of a size scatter");
    EXPECT_FALSE(planned("-shadow").on("shadow.denoise"));
    EXPECT_FALSE(planned("-occlusion").on("occlusion.denoise"));
}

// What no light passes and is smoother than 0.35: of clear surfaces only the probes are mirrored.
TEST(Plan, CallsForReflectionWhereAnOpaqueSurfaceIsGlossy)
{
    Scene scene = room();
    Material glass = matte(vec3(1)), varnish = matte(vec3(0.5f)), chalk = matte(vec3(0.5f));
    glass.flags = varnish.flags = chalk.flags = 0u;
    glass.roughness = 0.0f, glass.transmission = 1.0f;
    chalk.roughness = 0.1f, chalk.specular = 0.0f;
    varnish.roughness = 0.35f;
    for (const Material& m : {glass, varnish, chalk}) addQuad(scene, vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), addMaterial(scene, m));
    EXPECT_FALSE(planOf(scene).on("reflection"));
    EXPECT_EQ(reason(planOf(scene), "reflection"), "no material below roughness 0.35");
    EXPECT_TRUE(planOf(scene, nullptr, "+reflection").on("reflection"));
    scene.materials[2].roughness = 0.34f;
    EXPECT_TRUE(planOf(scene).on("reflection"));
    EXPECT_EQ(reason(planOf(scene), "reflection"), "material \"material 3\" has roughness 0.34");
    EXPECT_FALSE(planOf(scene, nullptr, "-reflection").on("reflection"));
}

TEST(Plan, TellsNormalsApartWhereAMapBendsThem)
{
    Scene scene = room();
    Baked baked = bakedEvenly(scene, vec3(1));
    EXPECT_EQ(reason(planOf(scene), "directional"), "no lightmap is drawn");
    EXPECT_EQ(reason(planOf(scene, &baked), "directional"), "nothing that has a lightmap has a normal map");
    scene.materials[0].normalTexture.texture = 0;
    EXPECT_EQ(reason(planOf(scene, &baked), "directional"), "the bake holds no directions");
    EXPECT_FALSE(planOf(scene, &baked).on("directional"));
    baked.lightmaps[0].direction.assign(baked.lightmaps[0].texels.size(), vec4(0, 0, 0, 1));
    EXPECT_TRUE(planOf(scene, &baked).on("directional"));
    EXPECT_FALSE(planOf(scene, &baked, "-lightmaps").on("directional"));
}

TEST(Plan, ReadsTheBake)
{
    Scene scene = room();
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(1)));
    Baked baked = bakedEvenly(scene, vec3(1));
    baked.probes = evenProbes(vec3(-2), vec3(2), vec3(1));
    EXPECT_TRUE(planOf(scene, &baked).on("lightmaps"));
    EXPECT_FALSE(planOf(scene, &baked).on("probes")) << "everything has a lightmap, and there is no fog";
    EXPECT_EQ(reason(planOf(scene, &baked, "-lightmaps"), "probes"), "no lightmap is drawn");
    EXPECT_TRUE(planOf(scene, &baked).on("shadow"));
    baked.directAll = true;
    EXPECT_FALSE(planOf(scene, &baked).on("shadow")) << "the bake holds the sun's direct part";
    baked.places[0].page = -1;
    EXPECT_TRUE(planOf(scene, &baked).on("probes"));
    baked.places[0].page = 0;
    scene.materials[0].flags |= kMaterialDoubleSided;
    baked.scene = scene;
    EXPECT_TRUE(planOf(scene, &baked).on("probes")) << "a back has no lightmap";
}

TEST(Plan, ObeysTheCommandLineAndSaysSo)
{
    const Plan planned = planOf(room(), nullptr, "+fog");
    EXPECT_TRUE(planned.on("fog"));
    EXPECT_EQ(reason(planned, "fog").rfind("asked for on the command line", 0), 0u);
    EXPECT_TRUE(planOf(room(), nullptr, "all,-fog").on("shadow"));
    EXPECT_FALSE(planOf(room(), nullptr, "all,-fog").on("fog"));
    EXPECT_TRUE(planOf(room(), nullptr, "none").on("geometry")) << "without it there is no picture";
}

// Rays and lines know the surfaces at their finest, whoever asks for them.
TEST(Plan, DrawsLevelsOfDetailWhereTheBakeHoldsThemAndNothingMeetsTheFinest)
{
    EXPECT_FALSE(planOf(room()).on("lods"));
    Baked baked;
    baked.scene = room();
    baked.places.resize(baked.scene.objects.size());
    baked.lods = {{{{LodLevel{{0, 1, 2}, 0.01f}}}}};
    EXPECT_TRUE(planOf(baked.scene, &baked).on("lods"));
    EXPECT_FALSE(planOf(baked.scene, &baked, "+outline").on("lods"));
    Settings settings;
    settings.shadowMethod = ShadowMethod::ray;
    const auto drawn = [&] { return plan(needs(baked.scene), evidenceOf(baked.scene, &baked, settings), {}).on("lods"); };
    EXPECT_TRUE(drawn()) << "no light, no ray";
    addLight(baked.scene, pointLight(vec3(0), vec3(1)));
    EXPECT_FALSE(drawn());
}

TEST(Plan, CallsForAntialiasingWhereThereAreEdgesAndForUpscalingWhereAsked)
{
    EXPECT_FALSE(planOf(Scene{}).on("antialias"));
    Settings half;
    half.renderScale = 0.5f;
    EXPECT_TRUE(plan(needs(room()), evidenceOf(room(), nullptr, half), {}).on("upscale"));
    EXPECT_FALSE(plan(needs(room()), evidenceOf(room(), nullptr, half), parseOverrides("-upscale")).on("upscale"));
}

TEST(Plan, SaysWhatTheCommandLineCannotHave)
{
    const Plan planned = planOf(room(), nullptr, "+outline,-geometry");
    EXPECT_EQ(planned.notes, (std::vector<std::string>{"--effects: geometry cannot be off"}));
    EXPECT_TRUE(planned.on("geometry"));
    EXPECT_EQ(reason(planned, "geometry").rfind("geometry cannot be off, although the command line asks", 0), 0u);
    for (const char* effects : {"auto", "all", "none", "-outline", "+geometry"})
        EXPECT_TRUE(planOf(room(), nullptr, effects).notes.empty()) << effects;
}

TEST(Plan, RefusesAnEffectThatDoesNotExist)
{
    try {
        parseOverrides("+fgo");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.exit, Exit::usage);
        EXPECT_NE(std::string(error.what()).find("fgo"), std::string::npos);
    }
}

// Probes 0.1 m apart have met what stands farther apart: occlusion that counts it again darkens a small room by a third.
TEST(Settings, OcclusionReachesNoFartherThanTheProbesOfTheBake)
{
    ProbeTree probes;
    EXPECT_EQ(occlusionRange({}, nullptr), 1.0f) << "none light the frame";
    ProbeCell small{vec3(0.0f), vec3(10.0f, 2.0f, 1.0f), {}}, flat{vec3(0.0f), vec3(1.0f, 0.0f, 1.0f), {}};
    probes.cells = {small, flat};
    EXPECT_NEAR(occlusionRange({}, &probes), 0.1f, 1e-6f);
    EXPECT_EQ(occlusionRange({.occlusionRange = 0.7f}, &probes), 0.7f);
    ProbeCell wide{vec3(0.0f), vec3(0.25f), {}};
    probes.cells = {wide};
    EXPECT_EQ(occlusionRange({}, &probes), 1.0f) << "nor than a metre";
}
}
