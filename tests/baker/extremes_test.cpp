// Lights and paths at the ends of what a level may hold: lights that touch what they light, that are a million times as bright as the rest
// or nothing at all, rooms that swallow nothing, mirrors that face each other.
#include "baker/baker.hpp"
#include "baker/sky.hpp"
#include "baker/tracer.hpp"
#include "rooms.hpp"
#include "tests/shaders/statistics.hpp"
#include <nlohmann/json.hpp>

namespace afterglow::test
{
namespace
{
PointIrradiance irradianceAt(const Scene& scene, vec3 position, vec3 normal = vec3(0, 1, 0), int samples = 16384)
{
    ProbePoint point;
    point.position = position;
    point.normal = normal;
    Progress silent(ProgressStyle::none);
    return probeTruth(scene, {point}, samples, 5, 0, silent)[0];
}

// Mean of a picture of 16 x 16 pixels from the origin upwards, leaning towards +x by `slope`, and its standard error.
dvec2 lookingUp(const Scene& scene, TruthOptions options, float slope = 0.0f)
{
    const vec3 back = -normalize(vec3(slope, 1.0f, 0.0f)), right(0.0f, 0.0f, 1.0f);
    options.camera.toWorld = mat4(vec4(right, 0.0f), vec4(cross(back, right), 0.0f), vec4(back, 0.0f), vec4(0, 0, 0, 1));
    options.camera.fovY = 2e-4f;
    options.size = ivec2(16, 16);
    Progress silent(ProgressStyle::none);
    const Image image = truth(scene, options, silent);
    Mean mean;
    for (std::size_t i = 0; i < 256; i++) mean.add(double(image.pixels[3 * i]));
    return {mean.value(), mean.error()};
}

Light pointLight(vec3 position, float radius)
{
    Light light{};
    light.type = kLightPoint;
    light.position = position;
    light.intensity = vec3(1.0f);
    light.radius = radius;
    return light;
}

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

// H29. A lamp in a closed block lights nothing outside; one that lies on the floor is finite there.
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

// H35. A closed room that swallows nothing and shines with 1: each surface that a path may turn at adds one, and two are there without.
TEST(Extremes, ARoomThatSwallowsNothing)
{
    Scene scene;
    addSurface(scene, flipped(box(vec3(2.0f))), shining(1.0f, /* albedo= */ 1.0f));
    for (const int bounces : {0, 3, 20}) {
        TruthOptions options;
        options.bounces = bounces;
        const dvec2 found = lookingUp(scene, options);
        EXPECT_NEAR(found.x, bounces + 2.0, 4.0 * found.y + 1e-4) << "standard error " << found.y;
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
            const dvec2 found = lookingUp(scene, options, float(slope));
            EXPECT_NEAR(found.x, n > 64 ? 0.0 : std::pow(double(reflectance), n), 1e-4) << n;
        }
    }
    Scene scene;
    add(scene, plate(vec3(0.0f, 2.0f, 0.0f), 1.0f, /* up= */ false), mirror(1.0f));
    addSurface(scene, plate(vec3(0.0f, -1.0f, 0.0f), 5.0f), shining(3.0f));
    EXPECT_NEAR(lookingUp(scene, {}).x, 3.0, 1e-5);
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

// H93. Paths that may end by chance at once bring, on average, what those bring that never do.
TEST(Extremes, ChanceEndsNoLight)
{
    Scene scene = halfLitRoom();
    for (Material& m : scene.materials) m.baseColor = vec4(0.8f, 0.3f, 0.1f, 1.0f);
    TruthOptions never, atOnce;
    never.samples = atOnce.samples = 32;
    never.rouletteFrom = 64, atOnce.rouletteFrom = 0;
    const dvec2 a = lookingUp(scene, never), b = lookingUp(scene, atOnce);
    EXPECT_NEAR(a.x, b.x, 4.0 * std::sqrt(a.y * a.y + b.y * b.y));
}

// H95. Under a slab of glass a point of light leaves nothing, by no path that is sampled (the shadow ray meets the glass). A sphere of a
// little size is met by chance: about I (1 - F) / (1 + F) / d^2 with F = 0.04 of a slab at right angles, which lifts the floor by
// t (1 - 1 / n); at 9 degrees off, where this one ends, that is right to 1 %.
TEST(Extremes, ALampBehindAPaneOfGlass)
{
    for (const float radius : {0.0f, 0.3f}) {
        Scene scene;
        add(scene, plate(vec3(0.0f), 5.0f), matte(0.0f));
        Material glass = matte(1.0f);
        glass.flags = 0;
        glass.transmission = 1.0f;
        glass.roughness = 0.0f;
        glass.specular = 1.0f;
        glass.specularColor = vec3(1.0f);
        glass.thickness = 1.0f; // it is a body
        glass.attenuationColor = vec3(1.0f);
        glass.attenuationDistance = 1.0f;
        add(scene, moved(box(vec3(8.0f, 0.3f, 8.0f)), vec3(0.0f, 0.5f, 0.0f)), glass);
        scene.lights = {pointLight(vec3(0.0f, 2.0f, 0.0f), radius)};
        const PointIrradiance found = irradianceAt(scene, vec3(0.0f), vec3(0, 1, 0), 1 << 17);
        const double height = 2.0 - 0.3 * (1.0 - 1.0 / 1.5), truth = radius > 0.0f ? 0.96 / 1.04 / (height * height) : 0.0;
        EXPECT_NEAR(double(found.value[0].x), truth, 4.0 * double(found.error[0].x) + 0.01 * truth) << radius;
    }
}

// H27. A wall of 20 cm or 1 cm across a floor, sun from one side at 45 degrees. A lookup at its foot reads full sun before it and none behind.
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
