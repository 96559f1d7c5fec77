// Charts: surfaces of every kind have a place of their own, little stretched, in few pieces.
#include "tests/baker/sound_atlas.hpp"

namespace afterglow
{
TEST(Atlas, ABoxIsSixRectangles)
{
    Atlas atlas;
    AtlasAudit audit = expectSound(box(vec3(4, 3, 2)), {}, atlas);
    EXPECT_EQ(audit.charts, 6);
    EXPECT_EQ(atlas.report.charts, 6);
    EXPECT_EQ(atlas.report.pages, 1);
    EXPECT_NEAR(atlas.report.texelsPerMetre, 16.0f, 16.0f / 32); // half a texel on the shortest edge, 32 texels
    EXPECT_NEAR(atlas.report.stretch, 1.0f, 1e-3f);
    EXPECT_GT(atlas.report.utilisation, 0.6f);
}

TEST(Atlas, BordersOfARectangleRunThroughTexelCentres)
{
    Scene scene = levelOf(box(vec3(4, 3, 2)));
    Atlas atlas = makeAtlas(scene, {});
    for (const Vertex& v : scene.vertices)
        for (int axis = 0; axis < 2; ++axis) {
            float texel = v.uv1[axis] * float(atlas.pageSizes[0][axis]) - 0.5f;
            EXPECT_NEAR(texel, std::round(texel), 1.0f / 32); // and a little beyond, so that the centre is covered
        }
}

TEST(Atlas, AFlippedOrDoubledFaceHasItsOwnPlace)
{
    Shape shape = box(vec3(1));
    append(shape, box(vec3(1)));          // each face twice
    append(shape, flipped(box(vec3(1)))); // and once from behind
    Atlas atlas;
    AtlasAudit audit = expectSound(shape, {}, atlas);
    EXPECT_GE(audit.charts, 18);
}

TEST(Atlas, AnEdgeOfFiveFacesKeepsAllFive)
{
    Atlas atlas;
    Scene scene = levelOf(fins(5));
    EXPECT_EQ(expectSound(scene, {}, atlas).charts, 5);
    EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST(Atlas, BoxesThatShareEdgesKeepTheirFacesWhole)
{
    // A frame: at either end of the rail, four faces meet in one edge.
    Shape frame = box(vec3(1, 4, 1));
    append(frame, moved(box(vec3(1, 4, 1)), vec3(4, 0, 0)));
    append(frame, moved(box(vec3(3, 1, 1)), vec3(2, -1.5f, 0)));
    Atlas atlas;
    EXPECT_LE(expectSound(frame, {}, atlas).charts, 3 * 6);
}

TEST(Atlas, ASurfaceAboveItselfIsCutWhereItOverlaps)
{
    Atlas atlas;
    AtlasAudit audit = expectSound(spiralRamp(3), {}, atlas);
    EXPECT_GE(audit.charts, 3); // three turns above each other
    EXPECT_LE(audit.charts, 8);
}

TEST(Atlas, CurvedSurfacesDoNotShatter)
{
    Atlas atlas;
    for (const Shape& shape : {icosphere(4), bumpySphere(5), torus(2.0f, 0.7f, 64, 32)}) {
        AtlasAudit audit = expectSound(shape, {}, atlas);
        EXPECT_LE(audit.charts, 60);
        EXPECT_EQ(audit.steep, 0);
        EXPECT_LT(atlas.report.stretch, 1.1f);
        EXPECT_NEAR(atlas.report.texelsPerMetre, 16.0f, 1.0f);
    }
}

TEST(Atlas, ABallThatFillsItsPageIsSixCharts)
{
    Atlas atlas;
    for (const Shape& ball : {icosphere(3), icosphere(4)}) {
        EXPECT_LE(expectSound(ball, {.pageSize = 1024, .pages = 1}, atlas).charts, 6); // as the faces of a cube
        EXPECT_LT(atlas.report.stretch, 1.01f);
    }
}

TEST(Atlas, NoChartRunsAroundABevel)
{
    // A square tube of 1 by 1 by 2 m, whose edges are rounded by 1 cm in three steps
    Shape tube;
    for (const float y : {0.0f, 2.0f})
        for (int i = 0; i < 16; i++) {
            const float quarter = float(i / 4) * 0.25f * kTurn, angle = quarter + float(i % 4) * kTurn / 12.0f;
            const vec2 middle = 0.49f * std::sqrt(2.0f) * vec2(std::cos(quarter + kTurn / 8.0f), std::sin(quarter + kTurn / 8.0f));
            tube.positions.push_back(vec3(middle.x + 0.01f * std::cos(angle), y, middle.y + 0.01f * std::sin(angle)));
        }
    for (uint i = 0; i < 16; i++) {
        const uint next = (i + 1) % 16;
        for (const uint corner : {i, i + 16, next, next, i + 16, next + 16}) tube.indices.push_back(corner);
    }
    Atlas atlas;
    EXPECT_GE(expectSound(tube, {}, atlas).charts, 4);
}

TEST(Atlas, TrianglesFarSmallerThanATexelStillGetOne)
{
    Shape dust;
    for (int i = 0; i < 100; ++i) append(dust, moved({{{0, 0, 0}, {1e-4f, 0, 0}, {0, 2e-4f, 1e-5f}}, {0, 1, 2}}, vec3(float(i), 0, 0)));
    Atlas atlas;
    EXPECT_EQ(expectSound(dust, {}, atlas).charts, 100);
}

TEST(Atlas, AFineMeshBelowTheTexelIsEnclosedInOneChart)
{
    Shape fine = grid(100, 100, [](float u, float v) { return vec3(u, 0, -v) * 0.1f; });
    Atlas atlas;
    EXPECT_EQ(expectSound(fine, {}, atlas).charts, 1);
}

TEST(Atlas, DegenerateTrianglesAreKept)
{
    Shape shape = box(vec3(1));
    uint n = uint(shape.positions.size());
    append(shape, {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {0, 1, 2, 0, 0, 1, 2, 2, 2}});
    shape.indices.insert(shape.indices.end(), {0, n, 0});
    Atlas atlas;
    expectSound(shape, {}, atlas);
}

TEST(Atlas, ACylinderUnrollsIntoARectangle)
{
    const Shape mantle = grid(48, 8, [](float u, float v) {
        const float a = u == 1.0f ? 0.0f : u * kTurn;
        return vec3(std::cos(a), 2.0f * v, -std::sin(a));
    });
    Atlas atlas;
    EXPECT_EQ(expectSound(mantle, {.texelsPerMetre = 64}, atlas).charts, 1);
    EXPECT_NEAR(atlas.report.stretch, 1.0f, 1e-3f);
    const ivec2 size = atlas.pageSizes[0]; // 48 chords of a turn, and 2 m
    EXPECT_NEAR(max(size.x, size.y), 64 * 96 * std::sin(kTurn / 96), 12.0);
    EXPECT_NEAR(min(size.x, size.y), 128.0, 12.0);
}

TEST(Atlas, AConeUnrollsIntoASector)
{
    const Shape mantle = grid(64, 6, [](float u, float v) {
        const float a = u == 1.0f ? 0.0f : u * kTurn, r = 0.2f + 0.8f * v;
        return vec3(r * std::cos(a), -1.5f * v, -r * std::sin(a));
    });
    Atlas atlas;
    EXPECT_LE(expectSound(mantle, {.texelsPerMetre = 64}, atlas).charts, 2);
    EXPECT_LT(atlas.report.stretch, 1.002f);
}

TEST(Atlas, TheSameLevelGivesTheSameAtlas)
{
    Scene a = levelOf(bumpySphere(4)), b = levelOf(bumpySphere(4));
    makeAtlas(a, {});
    makeAtlas(b, {});
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (std::size_t i = 0; i < a.vertices.size(); ++i) EXPECT_EQ(a.vertices[i].uv1, b.vertices[i].uv1);
}
}
