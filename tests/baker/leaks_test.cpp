// Closed rooms without light in a bright world stay dark: not one texel that a lookup on their surfaces may touch holds more than 1e-4 of
// the light outside, traced or filtered or dilated or stitched.
#include "baker/baker.hpp"
#include "dark_rooms.hpp"
#include "lookups.hpp"
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
        if (room.shares) continue;
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

// One flat piece of a mesh lies in the room and in the open, and a texel in both: it has one value for the two. Until meshes are cut where
// walls stand on them, its light is seen in the dark, but from no further than a lookup reaches: 1 to its middle and 1/2 from there.
TEST(Leaks, OfATexelInBothReachNoFurtherThanItsLookups)
{
    for (const DarkRoom& room : darkRooms()) {
        if (!room.shares) continue;
        const Baked baked = bakedRoom(room.scene, 4.0f, 8, Denoiser::none);
        const World world(baked.scene, Content::staticOnly);
        const Owners owners = findOwners(world, baked.places, {ivec2(baked.lightmaps[0].width, baked.lightmaps[0].height)});
        ASSERT_EQ(baked.lightmaps.size(), 1u);
        struct Outside {
            uint chart;
            vec2 texel;
        };
        std::vector<Outside> outside;
        const auto isDark = [&](const LookedAt& look) { return room.dark(look.position + kAbove * look.front); };
        lookAround(world, baked, kFineLookup, [&](const LookedAt& look) {
            if (!isDark(look)) outside.push_back({owners.chartOf[look.triangle], look.texel});
        });
        lookAround(world, baked, kFineLookup, [&](const LookedAt& look) {
            if (!isDark(look) || !(largestTouched(look) > kLeak)) return;
            float nearest = kFloatMax;
            for (const Outside& point : outside)
                if (point.chart == owners.chartOf[look.triangle])
                    nearest = min(nearest, largestOf(vec3(abs(point.texel - look.texel), 0.0f)));
            EXPECT_LE(nearest, 1.5f + kFineLookup)
                << room.name << " at " << look.position.x << ' ' << look.position.y << ' ' << look.position.z;
        });
    }
}

// H79: slivers, specks, triangles without area, and a second uv of the level's own that lies on itself, outside the page, or on its last edge.
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
