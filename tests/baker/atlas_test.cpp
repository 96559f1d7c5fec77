#include "baker/atlas.hpp"
#include "tests/baker/atlas_audit.hpp"
#include "tests/baker/shapes.hpp"
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
double area(const Scene& scene) // of all static objects, m2
{
    double sum = 0;
    for (const Object& object : scene.objects)
        for (const Primitive& p : scene.meshes[object.mesh].primitives)
            for (uint i = 0; object.isStatic && i < p.indexCount; i += 3) {
                dvec3 c[3];
                for (uint k = 0; k < 3; ++k)
                    c[k] = dvec3(object.toWorld *
                                 dvec4(dvec3(scene.vertices[p.firstVertex + scene.indices[p.firstIndex + i + k]].position), 1.0));
                sum += length(cross(c[1] - c[0], c[2] - c[0])) / 2;
            }
    return sum;
}

// Every triangle has a place, its own, and no bilinear lookup reaches the texels of another chart.
AtlasAudit expectSound(Scene& scene, const AtlasOptions& options, Atlas& atlas)
{
    double before = area(scene);
    std::size_t triangles = scene.indices.size();
    atlas = makeAtlas(scene, options);
    AtlasAudit audit = auditAtlas(scene, atlas);
    EXPECT_EQ(scene.indices.size(), triangles);
    EXPECT_NEAR(audit.area, before, 1e-6 * before);
    EXPECT_EQ(audit.sharedTexels, 0);
    EXPECT_EQ(audit.folded, 0);
    EXPECT_EQ(audit.outside, 0);
    EXPECT_EQ(audit.flipped, 0);
    EXPECT_EQ(audit.unlit, 0);
    EXPECT_EQ(atlas.places.size(), scene.objects.size());
    for (const ivec2& size : atlas.pageSizes) {
        EXPECT_EQ(size.x % 8, 0);
        EXPECT_EQ(size.y % 8, 0);
    }
    return audit;
}

AtlasAudit expectSound(const Shape& shape, const AtlasOptions& options, Atlas& atlas)
{
    Scene scene = levelOf(shape);
    return expectSound(scene, options, atlas);
}
}

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

TEST(Atlas, DensityCountsMetresOfTheWorld)
{
    Scene scene;
    addObject(scene, addMesh(scene, box(vec3(1))), glm::scale(dmat4(1.0), dvec3(4, 4, 1)));
    Atlas atlas;
    expectSound(scene, {}, atlas);
    EXPECT_NEAR(atlas.report.texelsPerMetre, 16.0f, 0.5f);
    EXPECT_NEAR(atlas.report.stretch, 1.0f, 1e-3f);
}

TEST(Atlas, AnObjectsOwnDensityWins)
{
    Scene scene;
    addObject(scene, addMesh(scene, box(vec3(4)))).texelsPerMetre = 8.0f;
    Atlas atlas;
    expectSound(scene, {}, atlas);
    EXPECT_NEAR(atlas.report.texelsPerMetre, 8.0f, 0.25f);
}

TEST(Atlas, ObjectsThatShareAMeshGetARectangleEach)
{
    Scene scene;
    uint mesh = addMesh(scene, icosphere(2));
    for (int i = 0; i < 5; ++i) addObject(scene, mesh, glm::scale(glm::translate(dmat4(1.0), dvec3(3 * i, 0, 0)), dvec3(1.0 + 0.5 * i)));
    addObject(scene, mesh).isStatic = false;
    Atlas atlas;
    expectSound(scene, {}, atlas);
    EXPECT_EQ(atlas.places[5].page, -1);
    EXPECT_NEAR(atlas.report.texelsPerMetre, 16.0f, 0.5f);
    for (const Vertex& v : scene.vertices) {
        EXPECT_GE(min(v.uv1.x, v.uv1.y), 0.0f);
        EXPECT_LE(max(v.uv1.x, v.uv1.y), 1.0f);
    }
    for (int i = 1; i < 5; ++i) { // equal texels per metre: rectangles as the scales
        vec2 first = atlas.places[0].scale * vec2(atlas.pageSizes[std::size_t(atlas.places[0].page)]);
        vec2 texels = atlas.places[std::size_t(i)].scale * vec2(atlas.pageSizes[std::size_t(atlas.places[std::size_t(i)].page)]);
        EXPECT_NEAR(texels.x / first.x, 1.0f + 0.5f * float(i), 1e-4f);
    }
}

TEST(Atlas, AskedPagesAreFilled)
{
    for (int pages : {1, 3}) {
        Scene scene;
        for (int i = 0; i < 16; ++i)
            addObject(scene, addMesh(scene, box(vec3(0.3f + 0.13f * float(i % 13), 0.2f + 0.21f * float(i % 7), 0.9f))));
        addObject(scene, addMesh(scene, box(vec3(0.7f)))).texelsPerMetre = 32.0f;
        Atlas atlas;
        expectSound(scene, {.pageSize = 512, .pages = pages}, atlas);
        EXPECT_EQ(atlas.pageSizes, std::vector<ivec2>(std::size_t(pages), ivec2(512)));
        EXPECT_GT(atlas.report.utilisation, 0.75f);
        EXPECT_LE(atlas.report.stretch, 1.02f);
        EXPECT_TRUE(scene.warnings.empty());
    }
}

// A density a tenth higher does not fit any more: the one that was found is the largest, but for the whims of packing.
TEST(Atlas, TheDensityOfFilledPagesIsTheirs)
{
    const auto level = [] {
        Scene scene;
        for (int i = 0; i < 12; ++i)
            addObject(scene, addMesh(scene, box(vec3(1.0f + 0.1f * float(i)))), glm::translate(dmat4(1.0), dvec3(3 * i, 0, 0)));
        return scene;
    };
    Scene filled = level(), higher = level(), lower = level();
    const float density = makeAtlas(filled, {.pageSize = 256, .pages = 1}).report.texelsPerMetre;
    EXPECT_EQ(makeAtlas(lower, {.texelsPerMetre = 0.98f * density, .pageSize = 256}).report.pages, 1);
    EXPECT_GT(makeAtlas(higher, {.texelsPerMetre = 1.1f * density, .pageSize = 256}).report.pages, 1);
    EXPECT_NEAR(density, std::sqrt(0.8f * 256.0f * 256.0f / float(area(filled))), 0.1f * density);
}

TEST(Atlas, DegenerateInputFillsNoPages)
{
    Scene empty, line = levelOf({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {0, 1, 2}});
    EXPECT_EQ(makeAtlas(empty, {.pages = 1}).report.charts, 0);
    EXPECT_EQ(makeAtlas(line, {.pages = 1}).places.size(), 1u);
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

// Of the class of organic meshes: blobs of any outline.
TEST(Atlas, ABumpySphereFillsAPage)
{
    Atlas atlas;
    AtlasAudit audit = expectSound(bumpySphere(5), {.pageSize = 512, .pages = 1}, atlas);
    EXPECT_LE(audit.charts, 40);
    EXPECT_LE(atlas.report.stretch, 1.02f);
    EXPECT_GT(atlas.report.utilisation, 0.6f);
}

TEST(Atlas, ALevelOfBoxesFillsItsPages)
{
    Scene scene;
    for (int i = 0; i < 60; ++i)
        addObject(scene,
                  addMesh(scene, box(vec3(0.3f + 0.13f * float(i % 23), 0.2f + 0.21f * float(i % 13), 0.4f + 0.17f * float(i % 17)))));
    Atlas atlas;
    expectSound(scene, {}, atlas);
    EXPECT_GT(atlas.report.utilisation, 0.7f);
}

TEST(Atlas, AnObjectTooLargeForAPageGetsLessAndItIsSaid)
{
    Scene scene = levelOf(box(vec3(40, 1, 40)));
    Atlas atlas;
    expectSound(scene, {.texelsPerMetre = 16, .pageSize = 256, .maxPageSize = 512}, atlas);
    EXPECT_EQ(scene.warnings.size(), 1u);
    EXPECT_LT(atlas.report.texelsPerMetre, 12.8f); // 512 texels / 40 m
    EXPECT_GT(atlas.report.texelsPerMetre, 6.0f);
    for (const ivec2& size : atlas.pageSizes) EXPECT_LE(max(size.x, size.y), 512);
}

TEST(Atlas, APlaneOfAThousandKilometresIsNoTrouble)
{
    Scene scene = levelOf(box(vec3(1e6f, 1, 1e6f)));
    Atlas atlas = makeAtlas(scene, {.maxPageSize = 1024});
    EXPECT_EQ(scene.warnings.size(), 2u); // the level's density gives way, and then the object's
    EXPECT_EQ(atlas.report.charts, 6);
    EXPECT_LE(max(atlas.pageSizes[0].x, atlas.pageSizes[0].y), 1024);
}

TEST(Atlas, ALevelThatAsksForTooManyPagesGetsLessAndItIsSaid)
{
    Scene scene;
    for (int i = 0; i < 30; ++i) addObject(scene, addMesh(scene, box(vec3(3))));
    Atlas atlas;
    expectSound(scene, {.texelsPerMetre = 64, .pageSize = 128, .maxPageSize = 128}, atlas);
    EXPECT_EQ(scene.warnings.size(), 1u + 30u); // the level, and each box: a face of 192 texels
    EXPECT_LE(atlas.report.pages, 64);
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
