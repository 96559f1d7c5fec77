// Density and pages: how many texels a metre gets, how full pages are, and what gives way where there are too many.
#include "tests/baker/sound_atlas.hpp"
#include <glm/gtc/matrix_transform.hpp>
#include <regex>

namespace afterglow
{
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
    ASSERT_EQ(scene.warnings.size(), 1u + 30u); // the level, and each box: a face of 192 texels
    EXPECT_TRUE(std::regex_search(scene.warnings[0], std::regex("is lowered to [0-9.]{1,4} % of"))) << scene.warnings[0];
    EXPECT_TRUE(std::regex_search(scene.warnings[1], std::regex("at [0-9.]{1,5} texels per metre: it gets [0-9.]{1,5}$")))
        << scene.warnings[1];
    EXPECT_LE(atlas.report.pages, 64);
}
}
