// Where irradiance probes stand, and which walls their cells keep to.
#include "baker/probes.hpp"
#include "engine/baked/probe_read.hpp"
#include "engine/core/error.hpp"
#include "rooms.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
using test::Random;

// A dark room beside a lit one. Between them a wall of some thickness, or a sheet.
static constexpr float kWall = 0.3f; // m, its x
static Scene twoRooms(float thickness)
{
    const Shape shell = flipped(box(vec3(4.0f, 2.0f, 2.0f)));
    Scene scene;
    addSurface(scene, part(shell, [](vec3 p) { return p.x < -1.9f; }), shining(10.0f, 0.5f)); // the far wall of the left room
    addSurface(scene, part(shell, [](vec3 p) { return p.x >= -1.9f; }), shining(0.0f, 0.5f));
    addSurface(scene, moved(box(vec3(thickness, 2.0f, 2.0f)), vec3(kWall, 0, 0)), shining(0.0f, 0.5f));
    scene.lower = vec3(-2, -1, -1), scene.upper = vec3(2, 1, 1);
    return scene;
}

// The dark room stays dark, a centimetre from the wall, with probes 2 m apart; a grid as others bake it lights it by a good share.
TEST(Probes, doNotLeakThroughWalls)
{
    for (float thickness : {0.0f, 0.01f, 0.05f, 0.1f})
        for (bool walls : {true, false}) {
            Bakery bakery(twoRooms(thickness));
            const ProbesResult result = bakeProbes(bakery.context, {.spacing = 2.0, .samples = 64, .walls = walls});
            Random random;
            float dark = 0.0f, lit = kFloatMax;
            for (int i = 0; i < 4000; i++) {
                const float nearest = kWall + 0.5f * thickness + 0.01f;
                vec3 p = anywhere(random, vec3(nearest, -0.99f, -0.99f), vec3(1.99f, 0.99f, 0.99f));
                if (i % 2) p.x = nearest + 0.05f * random.next();
                if (i % 3 == 0) p = offsetRay(vec3(nearest - 0.01f, p.y, p.z), vec3(1, 0, 0)); // on the wall, as surfaces ask
                dark = max(dark, probeLookup(ProbeSet{&result.tree}, p, kAxes[i % 6]).x);
                p = anywhere(random, vec3(-1.99f, -0.99f, -0.99f), vec3(kWall - 0.5f * thickness - 0.01f, 0.99f, 0.99f));
                lit = min(lit, probeLookup(ProbeSet{&result.tree}, p, vec3(-1, 0, 0)).x);
            }
            if (!walls) {
                EXPECT_GT(dark, 0.1f) << thickness;
                continue;
            }
            EXPECT_EQ(dark, 0.0f) << thickness;
            EXPECT_GT(lit, 1.0f) << thickness;
        }
}

// H82: none stands inside a solid, or outside of the room, and points there are answered all the same.
TEST(Probes, standInFreeSpace)
{
    Scene scene = furnace(0.5f);
    addSurface(scene, moved(box(vec3(0.8f)), vec3(0.3f, -0.2f, 0.1f)), shining(0.5f, 0.5f));
    Bakery bakery(scene);
    const ProbesResult result = bakeProbes(bakery.context, {.spacing = 0.5, .samples = 256});
    for (vec3 p : result.tree.positions) {
        const vec3 inBlock = abs(p - vec3(0.3f, -0.2f, 0.1f));
        EXPECT_GT(largestOf(inBlock), 0.4f) << p.x << " " << p.y << " " << p.z;
        EXPECT_LT(largestOf(abs(p)), 1.0f);
    }
    for (vec3 p : {vec3(0.3f, -0.2f, 0.1f), vec3(0.0f, 5.0f, 0.0f)})
        EXPECT_NEAR(probeLookup(ProbeSet{&result.tree}, p, vec3(0, 1, 0)).x, 1.0f, 0.1f);
}

// A pebble in a corner of cells: the probe stands beside it, and the file says why.
TEST(Probes, sayWhyTheyWereMoved)
{
    Scene scene = furnace(0.5f);
    addSurface(scene, box(vec3(0.02f)), shining(0.5f, 0.5f));
    Bakery bakery(scene);
    const ProbeTree tree = bakeProbes(bakery.context, {.spacing = 1.0, .samples = 16}).tree;
    ASSERT_EQ(tree.stands.size(), tree.positions.size());
    const auto told = [&](ProbeStand stand) { return std::count(tree.stands.begin(), tree.stands.end(), stand); };
    EXPECT_GT(told(ProbeStand::buried), 0);
    EXPECT_EQ(told(ProbeStand::buried) + told(ProbeStand::corner), std::ptrdiff_t(tree.stands.size())) << "of no other reason";
    for (vec3 position : tree.positions) EXPECT_GT(largestOf(abs(position)), 0.01f) << "none is left in the pebble";
}

// Where light changes fast there are more of them, as many as the error takes; a budget of bytes ends that.
TEST(Probes, areDenseWhereTheErrorAsksForIt)
{
    Scene scene = twoRooms(0.1f);
    addSurface(scene, moved(box(vec3(0.1f)), vec3(-1.0f, 0.9f, 0.0f)), shining(200.0f));
    Bakery bakery(scene);
    const auto baked = [&](double error, std::uint64_t bytes) {
        return bakeProbes(bakery.context, {.spacing = 1.0, .samples = 256, .error = error, .bytes = bytes});
    };
    const ProbesResult coarse = baked(0.4, ~0ull), fine = baked(0.05, ~0ull), bound = baked(0.05, 20000);
    EXPECT_LE(fine.interpolationError, 0.05f);
    EXPECT_LT(fine.interpolationError, coarse.interpolationError);
    EXPECT_GT(fine.tree.probes.size(), 2 * coarse.tree.probes.size());
    EXPECT_LE(bytesOf(bound.tree), 20000u);
    EXPECT_GT(bound.tree.probes.size(), coarse.tree.probes.size());
    const auto dark = [](const ProbesResult& result) { // nothing changes there that calls for more
        return std::count_if(result.tree.positions.begin(), result.tree.positions.end(), [](vec3 p) { return p.x > kWall; });
    };
    EXPECT_EQ(dark(fine), dark(coarse));

    bakery.context.threads = 1;
    const ProbesResult again = baked(0.05, ~0ull);
    ASSERT_EQ(again.tree.positions, fine.tree.positions);
    for (std::size_t i = 0; i < again.tree.probes.size(); i++) {
        EXPECT_EQ(again.tree.probes[i].lobe, fine.tree.probes[i].lobe);
        for (int c = 0; c < 9; c++) EXPECT_EQ(again.tree.probes[i].irradiance.c[c], fine.tree.probes[i].irradiance.c[c]);
    }
}

TEST(Probes, standAsCloseAsABoxPlacedByHandSays)
{
    Scene scene = furnace(0.5f);
    ProbeVolumeRequest request;
    request.toWorld = mat4(vec4(1, 0, 0, 0), vec4(0, 1, 0, 0), vec4(0, 0, 1, 0), vec4(0.5f, 0.5f, 0.5f, 1));
    request.spacing = 0.25f;
    scene.probeVolumes = {request};
    Bakery bakery(scene);
    const ProbesResult result = bakeProbes(bakery.context, {.spacing = 1.0, .samples = 16});
    Random random;
    for (int i = 0; i < 100; i++) {
        const ProbeCell cell = probeCellOf(ProbeSet{&result.tree}, anywhere(random, vec3(0.01f), vec3(0.99f)));
        for (int axis = 0; axis < 3; axis++) EXPECT_LE(1.0f / cell.perExtent[axis], 0.2501f);
    }
    EXPECT_GT(1.0f / probeCellOf(ProbeSet{&result.tree}, vec3(-0.9f)).perExtent.x, 0.4f);
}

// A floor and the sky: there is room above it.
TEST(Probes, standAboveAMereFloor)
{
    Scene scene;
    addSurface(scene, box(vec3(8.0f, 0.0f, 8.0f)), shining(0.0f, 0.5f));
    scene.sky.radiance = vec3(1.0f);
    scene.lower = vec3(-4, 0, -4), scene.upper = vec3(4, 0, 4);
    Bakery bakery(scene);
    const ProbesResult result = bakeProbes(bakery.context, {.spacing = 2.0, .samples = 1024});
    ASSERT_FALSE(result.tree.empty());
    EXPECT_NEAR(probeLookup(ProbeSet{&result.tree}, vec3(0.3f, 0.5f, 0.2f), vec3(0, 1, 0)).x, 1.0f, 0.05f);
    EXPECT_NEAR(probeLookup(ProbeSet{&result.tree}, vec3(0.3f, 0.05f, 0.2f), vec3(0, -1, 0)).x, 0.5f, 0.05f);
}

// However wide a level, or close the probes that it asks for: as many cells as memory has room for.
TEST(Probes, areNoMoreThanThereIsRoomFor)
{
    EXPECT_EQ(spacingWithin(dvec3(4, 2, 2), 1.0, 100.0), 1.0);
    for (const dvec3 extent : {dvec3(1e6, 1, 1e6), dvec3(1e18), dvec3(10.0), dvec3(1e4, 0, 1e4)}) {
        const dvec3 along = max(extent / spacingWithin(extent, 1e-3, 1e5), dvec3(1.0));
        EXPECT_LE(along.x * along.y * along.z, 1e5) << extent.x;
        EXPECT_GT(along.x * along.y * along.z, 1e4) << extent.x;
    }
    EXPECT_EQ(spacingWithin(dvec3(0.0), 0.0, 1e5), 0.0);
}

// Nothing to stand around.
TEST(Probes, areNoneOfAnEmptyLevel)
{
    Scene scene;
    scene.sky.radiance = vec3(1.0f);
    Bakery bakery(scene);
    EXPECT_TRUE(bakeProbes(bakery.context, {.spacing = 0.0, .samples = 16}).tree.empty());
}

// A room of 33 cells an axis, which halving makes 64: their number is bounded as it is, not as it is asked for.
TEST(Probes, areNoMoreThanMemoryTakes)
{
    Scene scene = furnace(0.5f);
    Bakery bakery(scene);
    const ProbesResult result = bakeProbes(bakery.context, {.spacing = 2.0 / 33.0, .samples = 2, .walls = false});
    EXPECT_LE(result.tree.cells.size(), 200000u);
    EXPECT_GE(result.tree.cells.size(), 32768u);
}

// Of a lamp without a size in its middle.
static Scene furnaceWithLamp()
{
    Scene scene = furnace(0.5f);
    Light lamp{};
    lamp.type = kLightPoint;
    lamp.intensity = vec3(1.0f);
    scene.lights.push_back(lamp);
    return scene;
}

// A lamp without a size stands where a probe would: there is no end to its light there. So far as the spacing there says.
TEST(Probes, keepAwayFromLampsInBoxesOfTheirOwnSpacing)
{
    Scene scene = furnaceWithLamp();
    ProbeVolumeRequest asked;
    asked.toWorld = mat4(2.0f);
    asked.toWorld[3].w = 1.0f;
    scene.probeVolumes = {asked};
    Bakery bakery(scene);
    bakery.context.direct = scene.lights;
    for (const double elsewhere : {0.25, 4.0}) {
        const ProbesResult result = bakeProbes(bakery.context, {.spacing = elsewhere, .samples = 2});
        float nearest = 9.0f;
        for (vec3 p : result.tree.positions) nearest = min(nearest, length(p));
        EXPECT_GE(nearest, 0.125f) << elsewhere;
        EXPECT_LT(nearest, 0.3f) << elsewhere;
    }
}

// The same where nobody placed a box.
TEST(Probes, keepAwayFromLampsWithoutASize)
{
    Scene scene = furnaceWithLamp();
    Bakery bakery(scene);
    bakery.context.direct = scene.lights;
    const ProbesResult result = bakeProbes(bakery.context, {.spacing = 1.0, .samples = 256});
    for (vec3 p : result.tree.positions) EXPECT_GE(length(p), 0.125f);
    EXPECT_GT(std::count(result.tree.stands.begin(), result.tree.stands.end(), ProbeStand::lamp), 0) << "and says why";
    EXPECT_LT(probeLookup(ProbeSet{&result.tree}, vec3(0.4f), vec3(0, 1, 0)).x, 30.0f);
}
}
