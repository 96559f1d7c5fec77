// Closed rooms without light in a bright world stay dark: not one texel that a lookup on their surfaces may touch holds more than 1e-4 of
// the light outside, traced or filtered or dilated. H22: nor where shading normals tilt through the walls. H80: and black is data there.
#include "baker/baker.hpp"
#include "dark_rooms.hpp"
#include "lookups.hpp"
#include "rooms.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
static constexpr float kLeak = 1e-4f;       // of the sky's radiance
static constexpr float kAbove = 1e-3f;      // m: where the air over a surface is asked for
static constexpr float kFineLookup = 0.25f; // texels between the lookups

static Baked bakedRoom(const Scene& scene, float texelsPerMetre, int samples, Denoiser denoiser)
{
    Progress silent(ProgressStyle::none);
    BakeOptions options;
    options.texelsPerMetre = texelsPerMetre;
    options.samples = samples;
    options.denoiser = denoiser;
    options.probes = options.reflections = options.lods = options.voxels = false;
    nlohmann::json told;
    return bakeScene(scene, options, silent, told);
}

static float largestTouched(const LookedAt& look)
{
    float largest = 0.0f;
    for (const Touched& touched : touchedBy(look.page, look.texel))
        if (touched.weight >= kTouched) largest = max(largest, largestOf(look.page.texels[touched.texel]));
    return largest;
}

TEST(Leaks, NoneInClosedRooms)
{
    int rooms = 0;
    for (const DarkRoom& room : darkRooms()) {
        rooms++;
        for (float texelsPerMetre : {4.0f, 11.0f})
            for (Denoiser denoiser : {Denoiser::none, Denoiser::builtin}) {
                const Baked baked = bakedRoom(room.scene, texelsPerMetre, 8, denoiser);
                const World world(baked.scene, Content::staticOnly);
                int dark = 0, leaks = 0, blanks = 0;
                float worst = 0.0f, brightest = 0.0f;
                vec3 where(0.0f);
                lookAround(world, baked, kFineLookup, [&](const LookedAt& look) {
                    const float value = largestTouched(look);
                    brightest = max(brightest, value);
                    if (!room.dark(look.position + kAbove * look.front)) return;
                    dark++;
                    leaks += value > kLeak ? 1 : 0;
                    for (const Touched& touched : touchedBy(look.page, look.texel)) // black is data
                        blanks += touched.weight >= kTouched && look.page.valid[touched.texel] == 0 ? 1 : 0;
                    if (value > worst) worst = value, where = look.position;
                });
                EXPECT_GT(dark, 100) << room.name;
                EXPECT_EQ(blanks, 0) << room.name;
                EXPECT_GT(brightest, 0.5f) << room.name;
                EXPECT_EQ(leaks, 0) << room.name << " at " << texelsPerMetre << " texels per metre, "
                                    << (denoiser == Denoiser::none ? "traced" : "denoised") << ": of " << dark << ", " << worst << " at "
                                    << where.x << ' ' << where.y << ' ' << where.z;
            }
    }
    EXPECT_GE(rooms, 24);
}

// A room whose every surface shines with radiance 1: irradiance / pi is 1 wherever a lookup goes, under the edges of what stands or lies in
// it too. About a normal tilted by an angle a, of the corners' round ones, a part of the hemisphere is behind the wall: (1 + cos a) / 2.
TEST(Edges, AreNotDark)
{
    struct Body {
        vec3 lower, upper;
    };
    const Body bodies[] = {{vec3(-0.6f, -0.9f, -0.5f), vec3(0.4f, -0.895f, 0.3f)}, // a rug, furniture sunk into walls and floor, a pillar
                           {vec3(-1.08f, -0.95f, -0.9f), vec3(-0.6f, 0.3f, -0.2f)},
                           {vec3(0.5f, -0.93f, 0.4f), vec3(1.05f, -0.2f, 0.98f)},
                           {vec3(0.6f, -0.95f, -0.7f), vec3(0.73f, 1.15f, -0.57f)}};
    double deviation = 0.0; // of a texel's noise
    for (const bool isRound : {false, true}) {
        DarkRoom room = darkRoom("furnace");
        addSurface(room.scene, shell(0.1f), shining(1.0f));
        room.scene.lower = kRoomLower, room.scene.upper = kRoomUpper;
        if (isRound) makeRound(room.scene, 0);
        for (const Body& body : bodies)
            if (!isRound) addSurface(room.scene, brick(body.lower, body.upper), shining(1.0f));
        const Baked baked = bakedRoom(room.scene, 6.0f, 64, Denoiser::none);
        const World world(baked.scene, Content::staticOnly);
        int looks = 0;
        float darkest = 1.0f;
        vec3 where(0.0f);
        double squares = 0.0;
        lookAround(world, baked, kFineLookup, [&](const LookedAt& look) {
            const vec3 air = look.position + kAbove * look.front;
            if (!room.dark(air)) return;
            for (const Body& body : bodies)
                if (!isRound && within(air, body.lower, body.upper)) return;
            for (const Touched& touched : touchedBy(look.page, look.texel)) {
                if (touched.weight < kTouched) continue;
                const float value = look.page.texels[touched.texel].y;
                looks++;
                squares += double((value - 1.0f) * (value - 1.0f));
                if (value < darkest) darkest = value, where = look.position;
            }
        });
        const float least = isRound ? 0.5f + 0.5f / std::sqrt(3.0f) : 1.0f;
        if (!isRound) deviation = std::sqrt(squares / looks);
        EXPECT_GT(looks, 10000);
        EXPECT_LT(deviation, 0.06); // or a black edge would pass for noise
        EXPECT_GE(darkest, least - 6.0f * float(deviation)) << where.x << ' ' << where.y << ' ' << where.z;
    }
}

// H79: slivers, specks, triangles without area, and a second uv of the level's own that lies on itself, outside the page, or on its last
// edge.
TEST(Texels, EveryTriangleHasLightWhateverTheLevelsUv)
{
    const Shape odd{{{0, 1, 0}, {0.001f, 1, 0}, {0, 1, -0.001f}, {1, 1, 0}, {2, 1, 0}, {1.5f, 1, -1e-5f}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}},
                    {0, 1, 2, 3, 4, 5, 6, 7, 8}};
    std::vector<Baked> bakes;
    for (const vec2 uv : {vec2(0.0f), vec2(1.0f), vec2(-7.5f, 3e9f), vec2(std::nanf(""))}) {
        Scene scene;
        add(scene, plate(vec3(0.0f), 1.0f), matte(0.0f));
        add(scene, odd, matte(0.0f));
        for (Vertex& v : scene.vertices) v.uv1 = uv;
        scene.sky.radiance = vec3(1.0f);
        scene.lower = vec3(-1.0f, 0.0f, -1.0f), scene.upper = vec3(2.0f, 2.0f, 1.0f);
        const Baked& baked = bakes.emplace_back(bakedRoom(scene, 4.0f, 8, Denoiser::none));
        const World world(baked.scene, Content::staticOnly);
        lookAround(world, baked, kFineLookup, [&](const LookedAt& look) {
            for (const Touched& touched : touchedBy(look.page, look.texel))
                EXPECT_TRUE(touched.weight < kTouched || look.page.valid[touched.texel] != 0) << look.triangle;
        });
        EXPECT_EQ(baked.lightmaps[0].texels, bakes[0].lightmaps[0].texels);
    }
}
}
