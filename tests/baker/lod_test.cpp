#include "baker/atlas.hpp"
#include "baker/lod.hpp"
#include "baker/lod_decimate.hpp"
#include "shaders/camera.h"
#include "tests/baker/surfaces.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
std::vector<LodLevel> levels(const Scene& scene, const LodOptions& options = {}) { return makeLods(scene, options, 1)[0].primitives[0]; }

Shape flatGrid()
{
    return grid(40, 40, [](float u, float v) { return vec3(u, 0, -v); });
}
}

// e N / (2 d tan(fov / 2)): 1 cm at 10 m, 1080 pixels over 60 degrees
TEST(Lod, AnErrorIsJudgedInPixels) { EXPECT_NEAR(sizeInPixels(0.01f, 10.0f, 1080.0f, kPi / 3.0f), 0.9353074361f, 9e-6f); }

TEST(Lod, ASphereKeepsItsShapeAndStaysClosed)
{
    Scene scene = levelOf(icosphere(4)); // 5120 triangles
    std::vector<LodLevel> lods = levels(scene);
    ASSERT_EQ(lods.size(), 3u);
    std::vector<Corners> fine = corners(scene, scene.indices);
    double expected = 0.00453; // of the icosphere itself, per 1280 triangles: as good as a sphere of so many can be, and n^-1
    for (const LodLevel& level : lods) {
        std::vector<Corners> coarse = corners(scene, level.indices);
        EXPECT_EQ(openEdges(coarse), 0);
        EXPECT_LT(double(level.error), 4 * expected * 1280.0 / double(coarse.size()));
        // The stated error is no less than the two-sided distance by samples ten times as dense.
        double spacing = 0.1 * std::sqrt(2 * area(fine) / double(fine.size())), largest = 0;
        DistanceTree toFine(fine), toCoarse(coarse);
        for (const dvec3& p : samples(coarse, spacing)) largest = max(largest, toFine(p));
        for (const dvec3& p : samples(fine, spacing)) largest = max(largest, toCoarse(p));
        EXPECT_LE(largest, 1.02 * double(level.error));
        EXPECT_GE(largest, 0.8 * double(level.error));
    }
}

TEST(Lod, AFlatGridStaysFlatWholeAndTheRightWayUp)
{
    Scene scene = levelOf(flatGrid());
    for (Vertex& v : scene.vertices) v.uv0 = v.uv1 = {v.position.x, -v.position.z};
    std::vector<LodLevel> lods = levels(scene, {.ratios = {0.5f, 0.1f, 0.0f}});
    ASSERT_EQ(lods.size(), 3u);
    for (const LodLevel& level : lods) {
        std::vector<Corners> surface = corners(scene, level.indices);
        EXPECT_NEAR(area(surface), 1.0, 1e-6);
        for (const Corners& t : surface) EXPECT_GT(unitNormal(t).y, std::cos(1e-3));
        EXPECT_LT(level.error, 1e-6f);
        EXPECT_LT(level.turn, 1e-3f);
    }
    EXPECT_LE(lods.back().indices.size(), 3u * 8); // a square's two, and what the rule against needles keeps
}

// Where nothing strays the normals may: those of a level of a flat grid, against those that the grid itself has there.
TEST(Lod, SaysHowFarItsNormalsTurn)
{
    const auto normalAt = [](float x) { return normalize(vec3(0.4f * std::sin(9.0f * x), 1, 0)); };
    Scene scene = levelOf(flatGrid());
    for (Vertex& v : scene.vertices) v.normal = normalAt(v.position.x);
    const std::vector<LodLevel> lods = levels(scene, {.ratios = {0.5f, 0.1f, 0.0f}});
    ASSERT_EQ(lods.size(), 3u);
    for (const LodLevel& level : lods) {
        double turned = 0, whole = 0;
        for (std::size_t i = 0; i < level.indices.size(); i += 3) {
            const Vertex *a = &scene.vertices[level.indices[i]], *b = &scene.vertices[level.indices[i + 1]],
                         *c = &scene.vertices[level.indices[i + 2]];
            const double area = double(length(cross(b->position - a->position, c->position - a->position)));
            for (int k = 0; k < 256; ++k) {
                const float root = std::sqrt((float(k) + 0.5f) / 256.0f), along = float(k * 97 % 256) / 256.0f;
                const vec3 w(1 - root, root * (1 - along), root * along);
                const vec3 n = normalize(w.x * a->normal + w.y * b->normal + w.z * c->normal);
                const vec3 p = w.x * a->position + w.y * b->position + w.z * c->position;
                const double turn = double(std::acos(std::min(dot(n, normalAt(p.x)), 1.0f)));
                turned += turn * turn * area / 256;
            }
            whole += area;
        }
        EXPECT_LT(level.error, 1e-6f);
        EXPECT_NEAR(double(level.turn), std::sqrt(turned / whole), 0.1 * double(level.turn) + 2e-3);
    }
    EXPECT_GT(lods.back().turn, 0.1f);
}

TEST(Lod, SheetsThatMeetInAnEdgeOfThreeKeepTheirArea)
{
    Shape shape;
    for (int i = 0; i < 3; ++i) {
        float a = kTurn * float(i) / 3.0f;
        append(shape, grid(12, 12, [=](float u, float v) { return vec3(u * std::cos(a), v, u * std::sin(a)); }));
    }
    append(shape, flipped(moved(flatGrid(), vec3(2, 0, 0))));
    append(shape, moved(flatGrid(), vec3(2, 0, 0))); // the same square from above
    Scene scene = levelOf(shape);
    double before = area(corners(scene, scene.indices));
    std::vector<LodLevel> lods = levels(scene);
    ASSERT_FALSE(lods.empty());
    for (const LodLevel& level : lods) {
        EXPECT_NEAR(area(corners(scene, level.indices)), before, 1e-6 * before);
        EXPECT_LT(level.error, 1e-6f);
    }
}

TEST(Lod, LightmapChartsKeepTheirBordersAndTheirArea)
{
    Shape shape; // a box of fine grids: six flat charts
    for (int axis = 0; axis < 3; ++axis)
        for (float side : {0.0f, 1.0f}) {
            Shape face = grid(16, 16, [=](float u, float v) {
                vec3 p(0.0f);
                p[axis] = side, p[(axis + 1) % 3] = u, p[(axis + 2) % 3] = v;
                return p;
            });
            append(shape, side > 0.0f ? face : flipped(face));
        }
    Scene scene = levelOf(shape);
    makeAtlas(scene, {});
    auto uvArea = [&](const std::vector<uint>& indices) {
        double sum = 0;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            dvec2 a(scene.vertices[indices[i]].uv1), b(scene.vertices[indices[i + 1]].uv1), c(scene.vertices[indices[i + 2]].uv1);
            double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            EXPECT_GT(twice, 0.0);
            sum += twice / 2;
        }
        return sum;
    };
    double before = uvArea(scene.indices);
    std::vector<LodLevel> lods = levels(scene);
    ASSERT_EQ(lods.size(), 3u);
    for (const LodLevel& level : lods) {
        EXPECT_NEAR(uvArea(level.indices), before, 1e-4 * before);
        EXPECT_EQ(openEdges(corners(scene, level.indices)), 0);
    }
}

TEST(Lod, BordersOfCurvedChartsStrayNoFurtherThanAllowed)
{
    Scene scene = levelOf(torus(2.0f, 0.7f, 64, 32));
    makeAtlas(scene, {});
    using Segment = std::array<dvec2, 2>;
    auto borders = [&](const std::vector<uint>& indices) { // of the charts: sides that one triangle has
        std::map<std::pair<uint, uint>, int> uses;
        for (std::size_t i = 0; i < indices.size(); ++i) {
            uint a = indices[i], b = indices[i % 3 == 2 ? i - 2 : i + 1];
            ++uses[{min(a, b), max(a, b)}];
        }
        std::vector<Segment> result;
        for (const auto& [side, count] : uses)
            if (count == 1) result.push_back({dvec2(scene.vertices[side.first].uv1), dvec2(scene.vertices[side.second].uv1)});
        return result;
    };
    auto away = [](const dvec2& p, const std::vector<Segment>& segments) {
        double nearest = 1e300;
        for (const Segment& s : segments) {
            dvec2 way = s[1] - s[0];
            nearest = min(nearest, distance(p, s[0] + way * clamp(dot(p - s[0], way) / dot(way, way), 0.0, 1.0)));
        }
        return nearest;
    };
    const std::vector<Segment> before = borders(scene.indices);
    const LodOptions options{.uvDrift = 0.001f};
    std::vector<LodLevel> lods = levels(scene, options);
    ASSERT_GE(lods.size(), 2u);
    for (const LodLevel& level : lods) {
        EXPECT_EQ(openEdges(corners(scene, level.indices)), 0);
        std::vector<Segment> after = borders(level.indices);
        EXPECT_LT(after.size(), before.size());
        double largest = 0;
        for (const Segment& s : after)
            for (double t : {0.1, 0.3, 0.5, 0.7, 0.9}) largest = max(largest, away(mix(s[0], s[1], t), before));
        EXPECT_LE(largest, double(options.uvDrift) + 1e-5);
    }
}

TEST(Lod, PrimitivesOfAMeshDoNotPartAtTheirBorder)
{
    // A bumpy sphere in two materials: its halves meet in one line.
    Shape sphere = bumpySphere(4), halves[2];
    for (Shape& half : halves) half.positions = sphere.positions;
    for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
        vec3 middle =
            sphere.positions[sphere.indices[i]] + sphere.positions[sphere.indices[i + 1]] + sphere.positions[sphere.indices[i + 2]];
        Shape& half = halves[middle.y > 0.0f];
        half.indices.insert(half.indices.end(), {sphere.indices[i], sphere.indices[i + 1], sphere.indices[i + 2]});
    }
    Scene scene;
    addMesh(scene, halves[0]);
    addMesh(scene, halves[1]);
    scene.meshes[0].primitives.push_back(scene.meshes[1].primitives[0]);
    scene.meshes.pop_back();
    MeshLods lods = makeLods(scene, {}, 1)[0];
    ASSERT_EQ(lods.primitives.size(), 2u);
    ASSERT_FALSE(lods.primitives[0].empty());
    ASSERT_FALSE(lods.primitives[1].empty());
    std::vector<Corners> whole = corners(scene, lods.primitives[0].back().indices);
    std::vector<uint> second = lods.primitives[1].front().indices; // any two levels fit together
    for (uint& i : second) i += scene.meshes[0].primitives[1].firstVertex;
    std::vector<Corners> rest = corners(scene, second);
    whole.insert(whole.end(), rest.begin(), rest.end());
    EXPECT_EQ(openEdges(whole), 0);
}

TEST(Lod, TargetsOutOfRangeGiveTheInputOrTheLeast)
{
    Scene scene = levelOf(icosphere(3));
    EXPECT_TRUE(levels(scene, {.ratios = {1.0f, 2.0f, NAN}}).empty()); // the input itself
    EXPECT_TRUE(levels(scene, {.ratios = {}}).empty());
    for (float ratio : {0.0f, -1.0f, 1e-6f}) {
        std::vector<LodLevel> lods = levels(scene, {.ratios = {ratio}, .maxError = 10.0f});
        ASSERT_EQ(lods.size(), 1u);
        EXPECT_GE(lods[0].indices.size(), 3u * 4); // a tetrahedron closes a surface
        EXPECT_EQ(openEdges(corners(scene, lods[0].indices)), 0);
    }
    std::vector<bool> free(scene.vertices.size());
    EXPECT_EQ(decimate({scene.vertices, scene.indices, free}, {scene.indices.size()})[0], scene.indices);
}

TEST(Lod, SmallPrimitivesAndErrorsBeyondTheBoundHaveNone)
{
    EXPECT_TRUE(levels(levelOf(icosphere(1))).empty()); // 80 triangles
    EXPECT_TRUE(levels(levelOf(bumpySphere(3)), {.ratios = {0.1f}, .maxError = 1e-4f}).empty());
}

TEST(Lod, ThreadsDoNotChangeTheResult)
{
    Scene scene;
    for (int i = 0; i < 4; ++i) addMesh(scene, bumpySphere(3));
    std::vector<MeshLods> one = makeLods(scene, {}, 1), two = makeLods(scene, {}, 2);
    for (std::size_t m = 0; m < 4; ++m)
        for (std::size_t l = 0; l < one[m].primitives[0].size(); ++l) {
            EXPECT_EQ(one[m].primitives[0][l].indices, two[m].primitives[0][l].indices);
            EXPECT_EQ(one[m].primitives[0][l].error, two[m].primitives[0][l].error);
        }
}
}
