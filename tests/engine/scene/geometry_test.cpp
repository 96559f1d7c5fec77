// Primitives as triangles: topologies, indices that are wrong, what is dropped, what is computed.
#include "tests/engine/scene/builder.hpp"
#include <limits>

namespace afterglow::test
{
using Geometry = LevelTest;

const std::vector<float> kFive = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}; // a zigzag upwards

vec3 faceNormal(const Scene& scene, std::size_t triangle)
{
    vec3 p[3];
    for (std::size_t i = 0; i < 3; ++i) p[i] = scene.vertices[scene.indices[3 * triangle + i]].position;
    return normalize(cross(p[1] - p[0], p[2] - p[0]));
}

TEST_F(Geometry, UnrollsAStripWithOneWinding)
{
    json one = primitive(kFive);
    one["mode"] = 5;
    place(one);
    const Scene scene = load();
    ASSERT_EQ(triangles(scene), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(near(faceNormal(scene, i), {0, 0, 1}));
}

TEST_F(Geometry, UnrollsAFan)
{
    json one = primitive({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    one["mode"] = 6;
    place(one);
    const Scene scene = load();
    ASSERT_EQ(triangles(scene), 2u);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(near(faceNormal(scene, i), {0, 0, 1}));
}

TEST_F(Geometry, DropsPointsAndLines)
{
    json line = triangle();
    line["mode"] = 1;
    place(line);
    place(triangle());
    const Scene scene = load();
    EXPECT_EQ(triangles(scene), 1u);
    EXPECT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(count(scene, "primitives that are points or lines"), 1);
}

TEST_F(Geometry, NamesThePrimitiveWhoseIndexPointsPastItsVertices)
{
    const json right = triangle();
    json wrong = triangle();
    wrong["indices"] = indices({0, 1, 3});
    node({{"mesh", add("meshes", {{"name", "Wall"}, {"primitives", {right, wrong}}})}});
    EXPECT_NE(sentence().find("level.glb"), std::string::npos);
    EXPECT_NE(sentence().find("mesh \"Wall\", primitive 1: index 3 points past its 3 vertices"), std::string::npos);
    gltf["accessors"].back()["bufferView"] = view(std::vector<std::uint32_t>{0, 1, 0xFFFFFFFF}.data(), 12);
    EXPECT_NE(sentence().find("index 4294967295 points past"), std::string::npos);
}

TEST_F(Geometry, RefusesIndicesThatAreNotWholeTriangles)
{
    json one = primitive(kFive);
    one["indices"] = indices({0, 1, 2, 3});
    place(one);
    EXPECT_NE(sentence().find("mesh \"Wall\", primitive 0: its 4 indices are not whole triangles"), std::string::npos);
}

TEST_F(Geometry, RefusesAttributesOfAnotherLength)
{
    json one = triangle();
    one["attributes"]["NORMAL"] = floats({0, 0, 1, 0, 0, 1}, "VEC3");
    place(one);
    EXPECT_NE(sentence().find("NORMAL has 2 elements for 3 vertices"), std::string::npos);
}

// H01: equal corners; three on a line, exactly and after rounding to float. What is left is the mesh without them.
TEST_F(Geometry, DropsDegenerateTriangles)
{
    const float third = 0.1f, two = 0.2f, three = 0.3f;
    json one = primitive({0, 0, 0, 1,     0,   0,     0,         1,       0,         // sound
                          5, 5, 5, 5,     5,   5,     6,         7,       8,         // two equal corners
                          0, 0, 0, 1,     1,   1,     3,         3,       3,         // on a line
                          0, 0, 0, third, two, three, 3 * third, 3 * two, 3 * three, // on a line but for rounding
                          2, 2, 2, 2,     2,   2,     2,         2,       2});       // a point
    place(one);
    const Scene scene = load();
    EXPECT_EQ(triangles(scene), 1u);
    EXPECT_EQ(count(scene, "degenerate triangles"), 4);
    EXPECT_EQ(scene.vertices.size(), 3u);
    EXPECT_EQ(scene.upper, vec3(1, 1, 0));
}

// The sliver of pbrt's bad cases (H02) is on a line; the skinny triangle of H03 is not, nor one that is a float step high far away.
TEST_F(Geometry, KeepsThinTrianglesThatHaveAnArea)
{
    const float far = 1048576.0f, step = 0.125f; // the spacing of floats from 2^20 on
    json one = primitive({-1113.45459f,
                          -79.049614f,
                          -56.2431908f,
                          -1113.45459f,
                          -87.0922699f,
                          -56.2431908f,
                          -1113.45459f,
                          -79.2090149f,
                          -56.2431908f, // H02
                          0,
                          0,
                          0,
                          11.2f,
                          0,
                          0,
                          9.7f,
                          0.0014f,
                          0, // thin
                          far,
                          far,
                          0,
                          far + 1,
                          far,
                          0,
                          far + 1,
                          far + step,
                          0}); // one step high
    place(one);
    const Scene scene = load();
    EXPECT_EQ(triangles(scene), 2u);
    EXPECT_EQ(count(scene, "degenerate triangles"), 1);
}

// H12, H13: dropped by triangle, whichever coordinate it is.
TEST_F(Geometry, DropsCoordinatesThatAreNoNumberOrTooLarge)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    place(primitive({0,   0,   0, 1,     0, 0,    0, 1, 0,    // sound
                     nan, 0,   0, 1,     0, 0,    0, 1, 0,    // NaN in x
                     0,   nan, 0, 1,     0, 0,    0, 1, 0,    // NaN in y
                     0,   0,   0, 1,     0, -inf, 0, 1, 0,    // infinite
                     0,   0,   0, 1e19f, 0, 0,    0, 1, 0})); // beyond what rays meet
    const Scene scene = load();
    EXPECT_EQ(triangles(scene), 1u);
    EXPECT_EQ(count(scene, "triangles with a coordinate that is no number"), 3);
    EXPECT_EQ(count(scene, "triangles with a coordinate beyond 1e18 m"), 1);
}

// H14: a denormal is 0 here, so that no thread's mode matters later.
TEST_F(Geometry, FlushesDenormals)
{
    place(primitive({1e-40f, 0, 0, 1, 0, 0, 0, 1, -1e-42f}));
    const Scene scene = load();
    EXPECT_EQ(count(scene, "denormal coordinates"), 2);
    for (const Vertex& vertex : scene.vertices) EXPECT_EQ(vertex.position.z, 0.0f);
    EXPECT_EQ(scene.vertices[0].position, vec3(0.0f));
}

TEST_F(Geometry, MakesFlatNormalsWhereThereAreNone)
{
    json one = primitive({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}); // two faces share an edge
    one["indices"] = indices({0, 1, 2, 0, 2, 3});
    place(one);
    const Scene scene = load();
    ASSERT_EQ(scene.vertices.size(), 6u); // no corner is shared
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(near(scene.vertices[scene.indices[i]].normal, {0, 0, 1}));
        EXPECT_TRUE(near(scene.vertices[scene.indices[3 + i]].normal, {1, 0, 0}));
    }
    EXPECT_TRUE(scene.dropped.empty());
}

TEST_F(Geometry, RepairsNormalsThatAreNoDirection)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    json one = triangle();
    one["attributes"]["NORMAL"] = floats({0, 0, 0, nan, 0, 1, 0, 3, 4}, "VEC3");
    place(one);
    const Scene scene = load();
    EXPECT_TRUE(near(scene.vertices[0].normal, {0, 0, 1}));
    EXPECT_TRUE(near(scene.vertices[1].normal, {0, 0, 1}));
    EXPECT_TRUE(near(scene.vertices[2].normal, {0, 0.6f, 0.8f})); // made a unit vector
    EXPECT_EQ(count(scene, "normals that are no direction"), 2);
}

TEST_F(Geometry, KeepsOnlyVerticesThatAreUsed)
{
    json one = primitive({9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0, 8, 8, 8});
    one["attributes"]["NORMAL"] = floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    one["indices"] = indices({1, 2, 3});
    place(one);
    const Scene scene = load();
    EXPECT_EQ(scene.vertices.size(), 3u);
    EXPECT_EQ(scene.upper, vec3(1, 1, 0));
}

TEST_F(Geometry, ZeroesTextureCoordinatesThatAreNoNumber)
{
    json one = triangle();
    one["attributes"]["TEXCOORD_0"] = floats({std::numeric_limits<float>::quiet_NaN(), 0, 1, 0, 0, 1e30f}, "VEC2");
    place(one);
    const Scene scene = load();
    EXPECT_EQ(scene.vertices[0].uv0, vec2(0.0f));
    EXPECT_EQ(scene.vertices[2].uv0, vec2(0.0f));
    EXPECT_EQ(count(scene, "texture coordinates that are no number"), 2);
}
}
