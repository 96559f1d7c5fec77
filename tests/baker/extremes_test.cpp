// Lights and paths at the ends of what a level may hold: lights that touch what they light, that are a million times as bright as the rest
// or nothing at all, rooms that swallow nothing, mirrors that face each other.
#include "again.hpp"
#include "asked.hpp"
#include "baker/sky.hpp"
#include "baker/tracer.hpp"
#include <nlohmann/json.hpp>

namespace afterglow::test
{
namespace
{
Material mirror(float reflectance)
{
    Material m = matte(reflectance);
    m.flags = 0;
    m.metallic = 1.0f;
    m.roughness = 0.0f;
    return m;
}
}

// H28. A wall that shines stands on the floor: 2 m wide, 1 m high. At a distance d before its middle
// E / L = atan(1 / d) - d / sqrt(d^2 + 1) atan(1 / sqrt(d^2 + 1)), up to the very contact; behind it, and on the wall's own plane, nothing.
TEST(Extremes, ALightThatTouchesItsFloor)
{
    Scene scene;
    addSurface(scene, {{{0, 0, 1}, {0, 0, -1}, {0, 1, -1}, {0, 1, 1}}, {0, 1, 2, 0, 2, 3}}, shining(1.0f));
    for (const double d : {1e-3, 0.1, 1.0}) {
        for (const float side : {1.0f, -1.0f}) {
            const bool isFront = (vec3(side, 0, 0) * World(scene, Content::everything).front(0)).x > 0.0f;
            const PointIrradiance found = irradianceAt(scene, vec3(side * float(d), 0.0f, 0.0f));
            const double away = std::sqrt(d * d + 1.0), form = std::atan(1.0 / d) - d / away * std::atan(1.0 / away);
            EXPECT_NEAR(double(found.value[0].x), isFront ? form : 0.0, 4.0 * double(found.error[0].x) + 1e-4) << d;
        }
    }
    EXPECT_EQ(irradianceAt(scene, vec3(0.0f, 2.0f, 0.0f), vec3(1, 0, 0)).value[0].x, 0.0f);
    EXPECT_EQ(irradianceAt(scene, vec3(0.0f, 0.5f, 0.0f), vec3(1, 0, 0)).value[0].x, 0.0f);
}

// H29. A lamp in a closed block lights nothing outside; one that lies on the floor is finite there (at a distance of at least
// kMinLightDistance, where it has no size), and an eye within it or before it sees the block above by it.
TEST(Extremes, ALampInsideABlockOrOnTheFloor)
{
    for (const float radius : {0.0f, 0.1f}) {
        Scene scene;
        add(scene, plate(vec3(0.0f), 5.0f), matte(0.5f));
        add(scene, moved(box(vec3(1.0f)), vec3(0.0f, 1.0f, 0.0f)), matte(0.5f));
        scene.lights = {pointLight(vec3(0.1f, 1.1f, 0.2f), radius)};
        for (const vec3 at : {vec3(0.0f), vec3(0.7f, 0.0f, 0.7f), vec3(3.0f, 0.0f, 0.0f)})
            EXPECT_EQ(irradianceAt(scene, at).value[0], vec3(0.0f));
        scene.lights[0].position = vec3(0.0f);
        EXPECT_TRUE(isFinite(irradianceAt(scene, vec3(0.0f)).value[0]));
        scene.lights[0].position = vec3(0.0f, 0.1f, 0.0f);
        TruthOptions direct;
        direct.directOnly = true;
        scene.objects.erase(scene.objects.begin()); // the floor
        const Mean seen = redOf(lookingUp(scene, direct, 0.0f, 2e-4f));
        EXPECT_NEAR(seen.value(), 0.5 / M_PI / 0.16, 4.0 * seen.error() + 1e-4) << radius;
    }
}

// H33. Lights without area, without power, or none at all: black, and beside a lamp as if they were not there.
TEST(Extremes, LightsThatAreNone)
{
    Scene lit, dark;
    for (Scene* scene : {&lit, &dark}) {
        add(*scene, plate(vec3(0.0f), 5.0f), matte(0.5f));
        if (scene == &lit) addSurface(*scene, plate(vec3(0.0f, 2.0f, 0.0f), 0.5f, /* up= */ false), shining(1.0f));
    }
    const PointIrradiance alone = irradianceAt(lit, vec3(0.0f));
    EXPECT_GT(alone.value[0].x, 0.0f);
    for (Scene* scene : {&lit, &dark}) {
        add(*scene, plate(vec3(1.0f, 1.0f, 0.0f), 0.0f), shining(1e6f)); // without area
        addSurface(*scene, plate(vec3(9.0f, 9.0f, 0.0f), 0.5f), shining(0.0f));
        scene->lights = {pointLight(vec3(0.0f, 1.0f, 0.0f), 0.0f), pointLight(vec3(0.0f, 1.0f, 0.0f), 0.1f)};
        for (Light& light : scene->lights) light.intensity = vec3(0.0f);
    }
    const PointIrradiance among = irradianceAt(lit, vec3(0.0f));
    EXPECT_NEAR(among.value[0].x, alone.value[0].x, 4.0f * length(vec2(among.error[0].x, alone.error[0].x)));
    EXPECT_LT(among.error[0].x, 1.1f * alone.error[0].x); // no path is spent on them
    EXPECT_EQ(irradianceAt(dark, vec3(0.0f)).value[0], vec3(0.0f));
}

// H34. A room whose walls shine with 1e-3 beside one whose walls shine with 1e8: each is right at the same number of paths.
TEST(Extremes, AFaintRoomBesideAGlaringOne)
{
    Scene scene;
    addSurface(scene, flipped(box(vec3(2.0f))), shining(1e-3f));
    addSurface(scene, moved(flipped(box(vec3(2.0f))), vec3(3.0f, 0.0f, 0.0f)), shining(1e8f));
    EXPECT_NEAR(irradianceAt(scene, vec3(0.0f, -1.0f, 0.0f)).value[0].x, 1e-3f * kPi, 1e-5f * kPi);
    EXPECT_NEAR(irradianceAt(scene, vec3(3.0f, -1.0f, 0.0f)).value[0].x, 1e8f * kPi, 1e6f * kPi);
}

// H35. A closed room that swallows nothing and shines with 1: each surface that a path may turn at adds one, and two are there without. How
// many paths the cap has cut is told. Of black walls none could have gone on.
TEST(Extremes, ARoomThatSwallowsNothing)
{
    for (const float albedo : {1.0f, 0.0f}) {
        Scene scene;
        addSurface(scene, flipped(box(vec3(2.0f))), shining(1.0f, albedo));
        for (const int bounces : {0, 3, 20}) {
            TruthOptions options;
            options.bounces = bounces;
            testing::internal::CaptureStderr();
            const Mean found = redOf(lookingUp(scene, options));
            const bool told = testing::internal::GetCapturedStderr().find("of the paths are cut at surface") != std::string::npos;
            EXPECT_NEAR(found.value(), albedo > 0.0f ? bounces + 2.0 : 1.0, 4.0 * found.error() + 1e-4);
            EXPECT_EQ(told, albedo > 0.0f) << bounces;
        }
        BakeOptions options;
        options.bounces = 3;
        options.samples = 16;
        options.texelsPerMetre = 2.0f;
        options.probes = options.reflections = options.lods = options.voxels = false;
        scene.lower = vec3(-1.0f), scene.upper = vec3(1.0f);
        EXPECT_EQ(make(scene, options).told["products"]["lightmaps"]["paths_cut"].get<double>() > 0.0, albedo > 0.0f);
    }
}

// H38 and H39. A ray goes up and down between mirrors at 2 m and -1 m until it has drifted beyond their edge, 9 m away, and is in the sky:
// L r^n. It turns 64 times and no more. A lamp seen in a mirror is all that it is: chance alone meets it, no light sample shares in it.
TEST(Extremes, MirrorsThatFaceEachOther)
{
    for (const float reflectance : {1.0f, 0.98f}) {
        Scene scene;
        add(scene, plate(vec3(0.0f, 2.0f, 0.0f), 9.0f, /* up= */ false), mirror(reflectance));
        add(scene, plate(vec3(0.0f, -1.0f, 0.0f), 9.0f), mirror(reflectance));
        scene.sky.radiance = vec3(1.0f);
        for (const double slope : {0.2, 0.05, 0.02}) { // meets them at x = slope (2 + 3 k)
            const int n = int(std::floor((9.0 / slope - 2.0) / 3.0)) + 1;
            TruthOptions options;
            options.rouletteFrom = 64;
            options.samples = 4;
            const double found = redOf(lookingUp(scene, options, float(slope))).value();
            EXPECT_NEAR(found, n > 64 ? 0.0 : std::pow(double(reflectance), n), 1e-4) << n;
        }
    }
    Scene scene;
    add(scene, plate(vec3(0.0f, 2.0f, 0.0f), 1.0f, /* up= */ false), mirror(1.0f));
    addSurface(scene, plate(vec3(0.0f, -1.0f, 0.0f), 5.0f), shining(3.0f));
    EXPECT_NEAR(redOf(lookingUp(scene, {})).value(), 3.0, 1e-5);
}

// H42. A path that carries nothing, or no number, ends; one that carries too much goes on as any other.
TEST(Extremes, APathThatCarriesNoNumber)
{
    for (uint i = 0; i < 256; i++) {
        Sampler random = makeSampler(7, i);
        for (const float nothing : {0.0f, std::nanf("")}) {
            vec3 throughput(nothing);
            EXPECT_FALSE(goesOn(throughput, kRouletteCeiling, random));
        }
        vec3 much(1e30f);
        if (goesOn(much, kRouletteCeiling, random)) {
            EXPECT_NEAR(much.x, 1e30f / kRouletteCeiling, 1e24f);
        }
    }
}

// H42. Where a path brings no finite number it is counted and dropped: a lamp too bright for a float's square beside a sky of 1.
TEST(Extremes, APathThatBringsNoNumber)
{
    Scene scene;
    add(scene, plate(vec3(0.0f), 1.0f), matte(0.0f));
    addSurface(scene, plate(vec3(0.0f, 1.0f, 0.0f), 0.01f, /* up= */ false), shining(1e30f));
    scene.sky.radiance = vec3(1.0f);
    scene.lower = vec3(-1.0f, 0.0f, -1.0f), scene.upper = vec3(1.0f);
    BakeOptions options;
    options.texelsPerMetre = 4.0f;
    options.samples = 16;
    options.probes = options.reflections = options.lods = options.voxels = false;
    const Made made = make(scene, options);
    EXPECT_GT(made.told["products"]["lightmaps"]["paths_not_finite"], 0);
    for (const Lightmap& page : made.baked.lightmaps)
        for (const vec3& texel : page.texels) EXPECT_TRUE(isFinite(texel)) << texel.x;
}

// H22. Normals that lean by 60 degrees, so that eyes are below many of them, make no light: a furnace of 1 shows no more than 1.
TEST(Extremes, NormalsThatLeanMakeNoLight)
{
    for (const bool isGlossy : {false, true}) {
        Scene scene = furnace(0.8f);
        for (Vertex& v : scene.vertices) v.normal = normalize(v.normal + 1.7320508f * vec3(v.normal.y, v.normal.z, v.normal.x));
        for (Material& m : scene.materials)
            if (isGlossy) m.flags = 0, m.metallic = 1.0f, m.roughness = 0.3f;
        TruthOptions options;
        options.samples = 256;
        const Mean found = redOf(lookingUp(scene, options, 0.0f, 2.5f));
        EXPECT_LE(found.value(), 1.0 + 4.0 * found.error());
        EXPECT_GT(found.value(), 0.2); // the walls themselves shine with that
    }
}

// H50. A sky with one texel a million times as bright as the rest, in the middle or at a pole; and one that is black.
TEST(Extremes, ASkyWithOneTexel)
{
    for (const ivec2 bright : {ivec2(5, 7), ivec2(3, 0), ivec2(9, 15)}) {
        Sky sky;
        sky.radiance = vec3(1.0f);
        sky.image = Image(32, 16, 3);
        for (int c = 0; c < 3; c++) sky.image.at(bright.x, bright.y)[c] = 1e6f;
        const SkyLight light(sky);
        const double truth = overSphere([&](vec3 d) { return double(light.radiance(vec3(d.x, d.z, d.y)).x); }, -1.0, 1.0, 4000, 256);
        Random random;
        Mean mean;
        for (int i = 0; i < 20000; i++) {
            const LightSample s = light.sample(random.next2());
            mean.add(s.pdf > 0.0f ? double(s.radiance.x / s.pdf) : 0.0);
        }
        EXPECT_GT(truth, 0.0);
        EXPECT_NEAR(mean.value() / truth, 1.0, 4.0 * mean.error() / truth + 1e-3) << bright.y;
    }
    Scene scene;
    add(scene, plate(vec3(0.0f), 5.0f), matte(0.5f));
    scene.sky.radiance = vec3(1.0f);
    scene.sky.image = Image(32, 16, 3);
    EXPECT_EQ(irradianceAt(scene, vec3(0.0f)).value[0], vec3(0.0f));
}

// H93. Paths that may end by chance at once bring, on average, what those bring that never do: in a room of colours, and from Veach's
// plates, from rough to smooth, under lamps from small to large.
TEST(Extremes, ChanceEndsNoLight)
{
    Scene room = halfLitRoom();
    for (Material& m : room.materials) m.baseColor = vec4(0.8f, 0.3f, 0.1f, 1.0f);
    Scene plates;
    for (int i = 0; i < 4; i++) {
        const float x = float(i) - 1.5f, half = 0.02f * float(1 << i);
        Material plate_ = mirror(0.9f);
        plate_.roughness = 0.1f + 0.15f * float(i);
        add(plates, moved(box(vec3(0.9f, 0.1f, 4.0f)), vec3(x, 2.0f, 0.0f)), plate_);
        addSurface(plates, plate(vec3(x, -0.5f, 0.0f), half), shining(0.01f / (half * half)));
    }
    for (const Scene* scene : {&room, &plates}) {
        TruthOptions never, atOnce;
        never.samples = atOnce.samples = 64;
        never.rouletteFrom = 64, atOnce.rouletteFrom = 0;
        const float fovY = scene == &room ? 2e-4f : 1.4f;
        const Image a = lookingUp(*scene, never, 0.0f, fovY), b = lookingUp(*scene, atOnce, 0.0f, fovY);
        Mean difference; // pixel by pixel: that of the plates' lit and unlit parts is no noise
        for (std::size_t i = 0; i < a.pixels.size(); i += 3) difference.add(double(b.pixels[i]) - double(a.pixels[i]));
        EXPECT_NEAR(difference.value(), 0.0, 4.0 * difference.error());
        EXPECT_LT(difference.error(), 0.02 * redOf(a).value()); // or it says nothing
    }
}

// H27. A wall of 20 cm or 1 cm across a floor, sun from one side at 45 degrees. A lookup at its foot reads full sun before it and none
// behind.
TEST(Extremes, TheFootOfAWallInTheSun)
{
    for (const float thickness : {0.2f, 0.01f}) {
        Scene scene;
        add(scene, plate(vec3(0.0f), 2.0f), matte(0.0f));
        add(scene, moved(box(vec3(thickness, 1.5f, 5.0f)), vec3(0.013f, 0.75f, 0.0f)), matte(0.0f));
        scene.lower = vec3(-2.0f, 0.0f, -2.5f), scene.upper = vec3(2.0f, 1.5f, 2.5f);
        Light sun{};
        sun.type = kLightDirectional;
        sun.direction = normalize(vec3(1.0f, -1.0f, 0.0f));
        sun.intensity = vec3(1.0f);
        scene.lights = {sun};
        BakeOptions options;
        options.texelsPerMetre = 8.0f;
        options.samples = 16;
        options.directAll = true;
        options.probes = options.reflections = options.lods = options.voxels = false;
        Progress silent(ProgressStyle::none);
        nlohmann::json told;
        const Baked baked = bakeScene(scene, options, silent, told);
        for (const float side : {-1.0f, 1.0f}) {
            double sum = 0.0;
            for (int i = 0; i < 32; i++) {
                ProbePoint point;
                point.position = vec3(0.013f + side * (0.5f * thickness + 0.13f), 0.0f, 0.1f * float(i - 16));
                point.normal = vec3(0, 1, 0);
                const PointIrradiance found = probeBaked(baked, {point})[0];
                sum += double(found.value[0].x / found.open) / 32.0;
            }
            EXPECT_NEAR(sum, side < 0.0f ? std::sqrt(0.5) : 0.0, 0.01 * std::sqrt(0.5)) << thickness;
        }
    }
}
}
