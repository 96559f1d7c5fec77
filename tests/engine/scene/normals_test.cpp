// Tangents: along +u, perpendicular, with the hand of the texture; a defined one where nothing defines it.
#include "engine/scene/normals.hpp"
#include "tests/engine/scene/builder.hpp"

namespace afterglow::test
{
// A quad in the xy plane facing +z, its texture upright: u grows with x, v downwards.
std::vector<Vertex> quad()
{
    std::vector<Vertex> vertices(4);
    for (int i = 0; i < 4; ++i) {
        const float x = float(i % 2), y = float(i / 2);
        vertices[i].position = vec3(x, y, 0);
        vertices[i].normal = vec3(0, 0, 1);
        vertices[i].uv0 = vec2(x, 1 - y);
    }
    return vertices;
}
const std::vector<uint> kQuad = {0, 1, 3, 0, 3, 2};

vec3 bitangent(const Vertex& v) { return cross(v.normal, vec3(v.tangent)) * v.tangent.w; }

TEST(Tangents, FollowTheTexture)
{
    std::vector<Vertex> vertices = quad();
    std::vector<uint> indices = kQuad;
    computeTangents(vertices, indices);
    ASSERT_EQ(vertices.size(), 4u);
    for (const Vertex& v : vertices) {
        EXPECT_TRUE(near(vec3(v.tangent), {1, 0, 0}));
        EXPECT_TRUE(near(bitangent(v), {0, 1, 0})); // green of a normal map is up, v is down
    }
}

TEST(Tangents, KnowAMirroredTexture)
{
    std::vector<Vertex> vertices = quad();
    for (Vertex& v : vertices) v.uv0.x = 1 - v.uv0.x;
    std::vector<uint> indices = kQuad;
    computeTangents(vertices, indices);
    for (const Vertex& v : vertices) {
        EXPECT_TRUE(near(vec3(v.tangent), {-1, 0, 0}));
        EXPECT_TRUE(near(bitangent(v), {0, 1, 0}));
    }
}

// Two halves that share an edge, the texture mirrored along it: the edge's vertices are split, and each keeps its own hand.
TEST(Tangents, SplitAVertexBetweenMirroredHalves)
{
    std::vector<Vertex> vertices(4);
    const vec2 at[] = {{-1, 0}, {0, 0}, {0, 1}, {1, 0}};
    for (int i = 0; i < 4; ++i) {
        vertices[i].position = vec3(at[i], 0);
        vertices[i].normal = vec3(0, 0, 1);
        vertices[i].uv0 = vec2(std::abs(at[i].x), 1 - at[i].y);
    }
    std::vector<uint> indices = {0, 1, 2, 1, 3, 2};
    computeTangents(vertices, indices);
    ASSERT_EQ(vertices.size(), 6u);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(near(vec3(vertices[indices[i]].tangent), {-1, 0, 0}));
    for (int i = 3; i < 6; ++i) EXPECT_TRUE(near(vec3(vertices[indices[i]].tangent), {1, 0, 0}));
    for (uint i : indices) EXPECT_TRUE(near(bitangent(vertices[i]), {0, 1, 0}));
}

TEST(Tangents, AreDefinedWhereTheTextureIsNot)
{
    std::vector<Vertex> vertices = quad();
    for (Vertex& v : vertices) v.uv0 = vec2(0.5f);
    std::vector<uint> indices = kQuad;
    computeTangents(vertices, indices);
    EXPECT_EQ(completeTangents(vertices), 4);
    for (const Vertex& v : vertices) {
        EXPECT_NEAR(length(vec3(v.tangent)), 1.0f, 1e-6f);
        EXPECT_NEAR(dot(vec3(v.tangent), v.normal), 0.0f, 1e-6f);
    }
}

TEST(Tangents, AreMadePerpendicular)
{
    std::vector<Vertex> vertices = quad();
    vertices[0].tangent = vec4(1, 0, 5, -1);    // leans
    vertices[1].tangent = vec4(0, 0, 2, 1);     // along the normal
    vertices[2].tangent = vec4(NAN, 0, 0, 1);   // no number
    vertices[3].tangent = vec4(0, 1e20f, 0, 1); // long
    EXPECT_EQ(completeTangents(vertices), 2);
    EXPECT_EQ(vertices[0].tangent, vec4(1, 0, 0, -1));
    EXPECT_EQ(vertices[3].tangent, vec4(0, 1, 0, 1));
    for (const Vertex& v : vertices) {
        EXPECT_NEAR(length(vec3(v.tangent)), 1.0f, 1e-6f);
        EXPECT_NEAR(dot(vec3(v.tangent), v.normal), 0.0f, 1e-6f);
    }
}

using TangentsOfALevel = LevelTest;

TEST_F(TangentsOfALevel, AreComputedForANormalMap)
{
    add("images", {{"uri", "data:image/png;base64,AAAA"}});
    add("textures", {{"source", 0}});
    json one = triangle();
    one["attributes"]["TEXCOORD_0"] = floats({0, 0, 0, -1, 1, 0}, "VEC2"); // u grows with y, v falls with x
    one["material"] = add("materials", {{"normalTexture", {{"index", 0}}}});
    place(one);
    const Scene scene = load();
    for (const Vertex& v : scene.vertices) {
        EXPECT_TRUE(near(vec3(v.tangent), {0, 1, 0}));
        EXPECT_TRUE(near(bitangent(v), {1, 0, 0})); // -dP/dv
    }
}
}
