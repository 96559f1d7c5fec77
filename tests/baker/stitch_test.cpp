// Seams of lightmaps: where one surface goes on from chart to chart, mesh to mesh, object to object, both sides show the same; where it
// does not, no texel moves for it. No lookup is further from the truth for being stitched.
#include "baker/baker.hpp"
#include "baker/seam_rounding.hpp"
#include "baker/stitch.hpp"
#include "bits.hpp"
#include "dark_rooms.hpp"
#include "rooms.hpp"
#include "shaders/lightmap.h"
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
struct StitchedBake {
    Baked baked;
    nlohmann::json seams; // what bake.json says of them
};

static StitchedBake bakedAs(const Scene& scene, BakeOptions options)
{
    Progress silent(ProgressStyle::none);
    options.probes = options.reflections = options.lods = options.voxels = false;
    nlohmann::json told;
    Baked baked = bakeScene(scene, options, silent, told);
    return {std::move(baked), told["products"]["lightmaps"]["seams"]};
}

static BakeOptions sampled(int samples, bool stitch = true)
{
    BakeOptions options;
    options.texelsPerMetre = 8.0f;
    options.samples = samples;
    options.stitch = stitch;
    return options;
}

static void measureScene(Scene& scene)
{
    scene.lower = vec3(-4.0f), scene.upper = vec3(4.0f);
    scene.sky.radiance = vec3(1.0f, 0.9f, 0.7f);
}

// A floor of 3 by 3 tiles under a board, in its soft shadow: eight are one mesh, placed eight times, one is a mesh of its own.
static Scene tiledFloor()
{
    constexpr float kTile = 0.97f; // m: no whole number of texels
    Scene scene;
    add(scene, plate(vec3(0.0f), kTile / 2.0f), matte(0.7f));
    scene.objects.clear();
    for (int i = 0; i < 9; i++) {
        dmat4 place(1.0);
        place[3] = dvec4(double(kTile) * (i % 3 - 1), 0.0, double(kTile) * (i / 3 - 1), 1.0);
        if (i != 4) addObject(scene, 0, place);
    }
    add(scene, plate(vec3(0.0f), kTile / 2.0f), matte(0.3f));
    add(scene, brick(vec3(-0.7f, 0.6f, -0.3f), vec3(0.4f, 0.65f, 0.5f)), matte(0.5f));
    measureScene(scene);
    return scene;
}

// Beside a board that hides half of the sky.
static Scene besideABoard(const Shape& shape)
{
    Scene scene;
    add(scene, shape, matte(0.5f));
    add(scene, brick(vec3(1.5f, -2.0f, -2.0f), vec3(1.6f, 2.0f, 2.0f)), matte(0.2f));
    measureScene(scene);
    return scene;
}

// With smooth normals, of 64 sides; where it is cut it faces the board's edge.
static Scene tube()
{
    const auto angle = [](float u) { return (u == 1.0f ? 0.0f : u * kTurn) + 0.5f * kTurn; };
    Scene scene = besideABoard(grid(64, 3, [&](float u, float v) { return vec3(std::cos(angle(u)), v, -std::sin(angle(u))); }));
    for (uint i = 0; i < scene.meshes[0].primitives[0].vertexCount; i++)
        scene.vertices[i].normal = normalize(vec3(scene.vertices[i].position.x, 0.0f, scene.vertices[i].position.z));
    return scene;
}

static Scene ball()
{
    Scene scene = besideABoard(icosphere(4));
    for (uint i = 0; i < scene.meshes[0].primitives[0].vertexCount; i++) scene.vertices[i].normal = normalize(scene.vertices[i].position);
    return scene;
}

// Unstitched they step; stitched, no point of any seam does so by more than one step of a display.
static void expectNoSteps(const char* what, const Scene& scene, int least)
{
    for (int samples : {16, 256}) {
        const StitchedBake bake = bakedAs(scene, sampled(samples));
        EXPECT_GE(int(bake.seams["points"]), least) << what;
        EXPECT_GT(double(bake.seams["step_unstitched"]["worst"]), 2.0) << what << ", " << samples << " paths";
        EXPECT_LE(double(bake.seams["step"]["worst"]), 1.0) << what << ", " << samples << " paths";
    }
}

TEST(Stitch, TilesOfOneFloorShowNoSeam) { expectNoSteps("a floor of tiles", tiledFloor(), 300); }

TEST(Stitch, ATubeShowsNoSeam) { expectNoSteps("a tube", tube(), 20); }

TEST(Stitch, ABallShowsNoSeam) { expectNoSteps("a ball", ball(), 100); }

// Of eight texels around: too few to tell how light turns on it, and still one smooth surface.
TEST(Stitch, ABallOfFewTexelsShowsNoSeam)
{
    BakeOptions options = sampled(64);
    options.texelsPerMetre = 8.0f / kTurn;
    const StitchedBake bake = bakedAs(ball(), options);
    EXPECT_GE(int(bake.seams["points"]), 20);
    EXPECT_GT(double(bake.seams["step_unstitched"]["worst"]), 10.0);
    EXPECT_LE(double(bake.seams["step"]["worst"]), 1.0);
}

// At no point of any seam does a draft step by more than one step of a display. The Cornell box is left out: no light falls on its seams.
TEST(Stitch, LevelsShowNoSeam)
{
    for (const char* level : {"still_life/still_life", "hanging_cube/hanging_cube", "two_rooms/two_rooms_open",
                              "two_rooms/two_rooms_closed", "pool/pool", "gallery/gallery"}) {
        BakeOptions options;
        options.quality = Quality::draft;
        const StitchedBake bake = bakedAs(loadLevel("content/" + std::string(level) + ".glb"), options);
        const nlohmann::json &before = bake.seams["step_unstitched"], &after = bake.seams["step"];
        std::printf("| %s | %d | %d | %.1f / %.0f / %.0f | %.2f / %.2f / %.2f |\n", level, int(bake.seams["points"]),
                    int(bake.seams["points_turning"]), double(before["mean"]), double(before["p95"]), double(before["worst"]),
                    double(after["mean"]), double(after["p95"]), double(after["worst"]));
        EXPECT_GT(double(before["worst"]), 5.0) << level;
        EXPECT_LE(double(after["p95"]), 0.75) << level;
        EXPECT_LE(double(after["worst"]), 1.0) << level;
    }
}

// A texel is moved by no more than it is off: seen by lookups all over the floor, light is nearer to that of a long bake.
TEST(Stitch, BringsLightNearerToTheTruth)
{
    const Scene scene = tiledFloor();
    const Baked truth = bakedAs(scene, sampled(4096, false)).baked, plain = bakedAs(scene, sampled(16, false)).baked,
                stitched = bakedAs(scene, sampled(16)).baked;
    ASSERT_EQ(truth.lightmaps.size(), stitched.lightmaps.size());
    double before = 0.0, after = 0.0;
    int changed = 0;
    for (std::size_t p = 0; p < truth.lightmaps.size(); p++)
        for (std::size_t i = 0; i < truth.lightmaps[p].texels.size(); i++) {
            if (truth.lightmaps[p].valid[i] != 1) continue;
            const vec3 was = plain.lightmaps[p].texels[i], is = stitched.lightmaps[p].texels[i], wanted = truth.lightmaps[p].texels[i];
            before += double(dot(was - wanted, was - wanted)), after += double(dot(is - wanted, is - wanted));
            changed += was != is ? 1 : 0;
        }
    EXPECT_GT(changed, 50);
    EXPECT_LT(after, before);
}

static void expectUntouched(const char* what, const Scene& scene)
{
    const StitchedBake stitched = bakedAs(scene, sampled(16)), plain = bakedAs(scene, sampled(16, false));
    EXPECT_EQ(stitched.seams["points"], 0) << what;
    EXPECT_EQ(bitsOf(stitched.baked), bitsOf(plain.baked)) << what;
}

// Two tiles side by side, of which the second is turned up by an angle about the side that they share.
static Scene bent(float degrees)
{
    const float a = degrees * kPi / 180.0f;
    const vec3 out(std::cos(a), std::sin(a), 0.0f), depth(0.0f, 0.0f, 1.0f);
    Scene scene;
    add(scene, {{vec3(-1, 0, 0), vec3(-1, 0, 1), vec3(0, 0, 1), vec3(0.0f)}, {0, 1, 2, 0, 2, 3}}, matte(0.5f));
    add(scene, {{vec3(0.0f), depth, out + depth, out}, {0, 1, 2, 0, 2, 3}}, matte(0.5f));
    measureScene(scene);
    return scene;
}

TEST(Stitch, LeavesCreasesAlone)
{
    EXPECT_GT(int(bakedAs(bent(0.0f), sampled(16)).seams["points"]), 10);
    expectUntouched("a fold of 10 degrees", bent(10.0f));
    expectUntouched("a fold of 90 degrees", bent(90.0f));
    Scene cube;
    add(cube, brick(vec3(-0.5f), vec3(0.5f)), matte(0.5f));
    measureScene(cube);
    expectUntouched("a cube", cube);
}

// A wall without thickness stands where two tiles meet: one lies in the light of a lamp, the other in the dark.
TEST(Stitch, PullsNoLightThroughAWall)
{
    Scene scene = bent(0.0f);
    scene.sky.radiance = vec3(0.0f);
    Material both = matte(0.5f);
    both.flags |= kMaterialDoubleSided;
    add(scene, {{vec3(0, 0, -4), vec3(0, 0, 4), vec3(0, 4, 4), vec3(0, 4, -4)}, {0, 1, 2, 0, 2, 3}}, both);
    add(scene, plate(vec3(-0.5f, 0.5f, 0.5f), 0.2f, false), shining(20.0f));
    expectUntouched("a wall on a seam", scene);
}

TEST(Stitch, IsTheSameForAnyNumberOfThreads)
{
    const Scene scene = tiledFloor();
    BakeOptions options = sampled(16);
    options.directional = true;
    options.threads = 1;
    const Contents one = bitsOf(bakedAs(scene, options).baked);
    options.threads = 3;
    EXPECT_EQ(bitsOf(bakedAs(scene, options).baked), one);
}

// Two charts of a texel's width and a guess beyond it, that meet in the middle between; what they hold is told.
static std::vector<Lightmap> twoCharts(vec3 left, vec3 right)
{
    Lightmap page;
    page.width = 8, page.height = 1;
    page.texels = {left, left, left, vec3(0.0f), vec3(0.0f), right, right, right};
    page.valid = {1, 1, 2, 0, 0, 2, 1, 1};
    return {page};
}

static Seams seamBetween(float variance)
{
    Seams seams{
        {ivec2(8, 1)},
        {SeamPoint{vec3(0.0f), vec3(0, 1, 0), {{0, vec2(2.0f, 0.5f)}, {0, vec2(6.0f, 0.5f)}}, {vec3(-1, 0, 0), vec3(1, 0, 0)}, 1.0f}},
        {}};
    for (uint texel : {1u, 2u, 5u, 6u}) {
        SeamTexel& known = seams.texels.emplace_back(SeamTexel{0, texel});
        known.measured = texel == 1 || texel == 6;
        known.share = known.measured ? 1.0f : 0.0f;
        known.variance = variance;
    }
    return seams;
}

// Of what is known exactly nothing gives way: the guesses beyond the border do. Of what is noisy both sides do, by no more than it.
TEST(Stitch, MovesTexelsAsLittleAsTheyAreKnownWell)
{
    const Shown shown{1.0f, 0};
    std::vector<Lightmap> exact = twoCharts(vec3(0.2f), vec3(0.22f)), noisy = exact;
    stitch(exact, seamBetween(0.0f), shown, 1);
    EXPECT_NEAR(exact[0].texels[1].x, 0.2f, 0.2f * 3e-3f);
    EXPECT_NEAR(exact[0].texels[6].x, 0.22f, 0.22f * 3e-3f);
    EXPECT_NEAR(exact[0].texels[2].x, 0.22f, 0.01f); // as if each chart went on into the other
    EXPECT_LT(stepsOf(exact, seamBetween(0.0f), shown).worst, 0.5);
    stitch(noisy, seamBetween(0.1f * 0.1f), shown, 1);
    EXPECT_GT(noisy[0].texels[1].x, exact[0].texels[1].x);

    std::vector<Lightmap> dark = twoCharts(vec3(0.0f), vec3(5.0f));
    stitch(dark, seamBetween(0.01f * 0.01f), shown, 1);
    EXPECT_LE(dark[0].texels[1].x, 0.1f); // a jump that no noise explains
    for (const vec3& texel : dark[0].texels) EXPECT_GE(texel.x, 0.0f);
}

// A bright red leaves nine bits to a dark blue, whose last one is three steps of a display: both sides take the same.
TEST(Stitch, RoundsBothSidesOfASeamAlike)
{
    const Shown shown{1.0f, 0};
    const StepOf stepOf = [&](double a, double b) { return double(abs(shown(float(a)) - shown(float(b)))); };
    constexpr float kLast = 1.0f / 512.0f; // of 0.9
    std::vector<vec3> light = {vec3(0.9f, 0.9f, 2.55f * kLast), vec3(0.9f, 0.9f, 2.45f * kLast), vec3(0.9f, 0.9f, 2.45f * kLast)};
    const SeamPatch patch{{0}, {0, 1, 2}, {{{{{0, 1.0f}}}}, {{{{1, 0.5f}, {2, 0.5f}}}}}};
    const auto blue = [&](std::size_t texel) { return double(decodeSharedExponent(encodeSharedExponent(light[texel])).z); };
    const auto step = [&] { return stepOf(blue(0), 0.5 * (blue(1) + blue(2))); };
    EXPECT_GT(step(), 2.0);
    roundTogether(patch, light, stepOf, 0.7);
    EXPECT_LE(step(), 0.7);
    for (const vec3& texel : light) EXPECT_NEAR(texel.z, 2.5f * kLast, 1.5f * kLast);
}

// How light changes about a texel, its own chart says, not the one that lies beside it on the page.
TEST(Stitch, LooksAroundInOneChart)
{
    Lightmap page;
    page.width = 4, page.height = 1;
    page.texels = {vec3(1.0f), vec3(1.2f), vec3(9.0f), vec3(9.0f)};
    page.valid = {1, 1, 1, 1};
    const TexelGuides guides{std::vector<vec3>(4), std::vector<vec3>(4, vec3(0, 1, 0)), std::vector<vec3>(4), std::vector<float>(4)};
    Seams seams{{ivec2(4, 1)}, {}, {SeamTexel{0, 1}}};
    remember(seams, 0, page, guides, {7, 7, 8, 8});
    EXPECT_NEAR(seams.texels[0].spread, 0.1f, 1e-5f);
}
}
