// A thing that moved: what it does not reach is kept, and the stated error bounds what that is off by.
#include "again.hpp"
#include "baker/reach.hpp"

namespace afterglow
{
// Two rooms, one above the other, of which the lower one holds what moves.
static Scene twoFloors(float x)
{
    Scene scene;
    addSurface(scene, flipped(box(vec3(2.0f))), shining(0.0f, 0.5f));
    addSurface(scene, moved(flipped(box(vec3(2.0f))), vec3(0.0f, 3.0f, 0.0f)), shining(0.0f, 0.5f));
    addSurface(scene, box(vec3(0.3f)), shining(0.0f, 0.7f));
    scene.objects.back().toWorld[3] = dvec4(double(x), -0.7, 0.0, 1.0);
    scene.lower = vec3(-1.0f), scene.upper = vec3(1.0f, 4.0f, 1.0f);
    for (const float y : {0.6f, 3.6f}) scene.lights.push_back(lampAt(vec3(0.3f, y, 0.2f), vec3(2.0f)));
    return scene;
}

static BakeOptions incremental()
{
    BakeOptions options = lightmapsOnly(48);
    options.incremental = true;
    return options;
}

// The other room is kept, to the bit; against a bake that is as good as true, the stated error is the true one or more.
TEST(Incremental, tracesWhatAMoveReaches)
{
    const Scene after = twoFloors(0.3f);
    const Again made = bakeAgain(twoFloors(0.0f), after, incremental());
    EXPECT_GT(made.again.kept(), 0.4);
    EXPECT_LT(made.again.kept(), 0.98);
    EXPECT_LT(double(made.again.rays), 0.8 * double(made.anew.rays));
    EXPECT_LE(offBy(made.again.baked, made.anew.baked), std::sqrt(2.0 * kGivenUp) * made.anew.error()) << "what is kept is off by";
    EXPECT_GE(made.again.error(), 0.99 * made.anew.error());
    EXPECT_LE(made.again.error(), 1.1 * made.anew.error());

    BakeOptions longer = incremental();
    longer.samples = 384;
    longer.seed = 7;
    const Made truth = make(after, longer);
    EXPECT_LE(offBy(made.again.baked, truth.baked), 1.05 * std::hypot(made.again.error(), truth.error()));
}

TEST(Incremental, ofAnUnchangedLevelTracesNothing)
{
    const Again made = bakeAgain(twoFloors(0.0f), twoFloors(0.0f), incremental());
    EXPECT_EQ(made.again.rays, 0u);
    EXPECT_EQ(made.again.kept(), 1.0);
    EXPECT_EQ(bitsOf(made.again.baked), bitsOf(made.anew.baked));
}

TEST(Incremental, reachesItsTargetAfterAMove)
{
    BakeOptions options = incremental();
    options.targetError = 0.03f;
    const Again made = bakeAgain(twoFloors(0.0f), twoFloors(0.3f), options);
    EXPECT_LE(made.again.error(), 0.03);
    EXPECT_LT(double(made.again.rays), 0.9 * double(made.anew.rays));
}

// Of two lamps that are layers of their own, the one upstairs sees nothing of it.
TEST(Incremental, asksEachLayerOfLight)
{
    BakeOptions options = incremental();
    options.lightLayers = true;
    const double kept = bakeAgain(twoFloors(0.0f), twoFloors(0.3f), options).again.kept();
    EXPECT_GT(kept, 0.7);
    EXPECT_LT(kept, 0.99);
}

// A lamp's shade is opened: everything that it lights changes, and nothing of that is kept.
TEST(Incremental, keepsNothingThatALampLightsAnew)
{
    Scene closed = twoFloors(0.0f), open = closed;
    for (Scene* scene : {&closed, &open}) {
        addSurface(*scene, box(vec3(0.2f)), shining(0.0f, 0.5f));
        scene->objects.back().toWorld[3] = dvec4(0.3, scene == &closed ? 0.6 : -0.8, 0.2, 1.0);
    }
    const Again made = bakeAgain(closed, open, incremental());
    EXPECT_LE(offBy(made.again.baked, made.anew.baked), 1e-6);
    EXPECT_LT(double(made.again.rays), 0.8 * double(made.anew.rays)) << "but the room above";
}

// Small steps: each is compared with the level that a tile was traced in.
TEST(Incremental, doesNotDrift)
{
    const std::string key(64, 'k');
    const Ground ground[2] = {Ground("odd"), Ground("even")};
    const auto journal = [&](int i) { return std::make_unique<Journal>(ground[i % 2].place, key, Journal::Start::afresh); };
    make(twoFloors(0.0f), incremental(), journal(0).get());
    Made made;
    constexpr int kSteps = 8;
    for (int step = 1; step <= kSteps; step++) {
        testing::internal::CaptureStderr(); // an unfinished bake lies there
        const Journal earlier(ground[(step - 1) % 2].file);
        made = make(twoFloors(0.4f * float(step) / kSteps), incremental(), journal(step).get(), &earlier);
        testing::internal::GetCapturedStderr();
    }
    const Made anew = make(twoFloors(0.4f), incremental());
    EXPECT_LE(offBy(made.baked, anew.baked), std::sqrt(2.0 * kGivenUp) * anew.error());
    EXPECT_GT(made.kept(), 0.4);
}

static std::vector<TexelLight> texels(double seen, double told)
{
    TexelLight light;
    light.half[0] = dvec3(8.0 * seen), light.half[1] = dvec3(8.0 * told);
    light.count[0] = light.count[1] = 8;
    light.points = 1;
    return std::vector<TexelLight>(kTileTexels, light);
}

TEST(Reach, decidesByOneHalfAndTellsByTheOther)
{
    const TileChange change = changeOf(texels(1.0, 1.0), texels(1.5, 3.0));
    EXPECT_TRUE(change.kept);
    EXPECT_NEAR(change.seen, kTileTexels * 0.25, 1e-9);
    EXPECT_NEAR(change.told.y, kTileTexels * 4.0, 1e-9);
    std::vector<TexelLight> moved = texels(1.0, 1.0);
    moved[5].position.x = 1e-6;
    EXPECT_FALSE(changeOf(texels(1.0, 1.0), moved).kept) << "it is another place";
}

TEST(Reach, keepsTheLeastChangedWithinItsShare)
{
    std::vector<TileChange> tiles(40, {.seen = 0.5, .error = 1.0, .kept = true}); // room for 2 in all
    tiles[3].seen = 0.0;
    tiles[4].seen = 0.0, tiles[4].kept = false;
    tiles[5].seen = 0.2, tiles[5].error = 0.1;
    keepLeastChanged(tiles);
    EXPECT_TRUE(tiles[3].kept);
    EXPECT_FALSE(tiles[4].kept);
    EXPECT_FALSE(tiles[5].kept) << "by more than its own noise: its edge would show";
    EXPECT_EQ(std::count_if(tiles.begin(), tiles.end(), [](const TileChange& t) { return t.kept; }), 1 + 3);
}
}
