// Closed bodies: what an eye outside sees from the front alone.
#include "engine/scene/closed.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
struct Body {
    Scene scene;
    bool closed() const { return isClosedBody(scene, {0, uint(scene.vertices.size()), 0, uint(scene.indices.size()), 0}); }

    // Six sides with their own corners, as normals of their own want them. `outward` false: a room's walls.
    void box(vec3 lower, float edge, bool outward = true, int sides = 6)
    {
        for (int side = 0; side < sides; ++side) {
            const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
            const uint first = uint(scene.vertices.size());
            for (const vec2 at : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)}) {
                Vertex vertex{};
                vertex.position = lower;
                vertex.position[axis] += edge * float(side % 2);
                vertex.position[u] += edge * at.x;
                vertex.position[v] += edge * at.y;
                scene.vertices.push_back(vertex);
            }
            const bool asIs = (side % 2 == 1) == outward; // u x v points along the axis
            for (const uint i : {0u, 1u, 2u, 0u, 2u, 3u}) scene.indices.push_back(first + (asIs ? i : 3u - i));
        }
    }
};
}

TEST(ClosedBody, IsABoxWithSeamsAndOneBesideIt)
{
    Body body;
    body.box(vec3(-7.0f, 0.1f, 3.0f), 0.3f);
    EXPECT_TRUE(body.closed());
    body.box(vec3(1.0f), 2.0f);
    EXPECT_TRUE(body.closed());
}

TEST(ClosedBody, HasNoHoleAndIsNotARoom)
{
    Body open, room, shell, nothing;
    open.box(vec3(0.0f), 1.0f, true, 5);
    EXPECT_FALSE(open.closed());
    room.box(vec3(0.0f), 1.0f, false);
    EXPECT_FALSE(room.closed());
    shell.box(vec3(0.0f), 9.0f);
    shell.box(vec3(20.0f), 1.0f, false); // its backs are seen from outside, however much the other weighs
    EXPECT_FALSE(shell.closed());
    EXPECT_FALSE(nothing.closed());
}

TEST(ClosedBody, DoesNotMindTrianglesWithoutArea)
{
    Body body;
    body.box(vec3(0.0f), 1.0f);
    for (const uint i : {0u, 1u, 1u, 5u, 5u, 5u}) body.scene.indices.push_back(i);
    EXPECT_TRUE(body.closed());
}

// A flap on an edge: run through thrice.
TEST(ClosedBody, IsNotOneWithAFlap)
{
    Body body;
    body.box(vec3(0.0f), 1.0f);
    Vertex tip{};
    tip.position = vec3(5.0f);
    body.scene.vertices.push_back(tip);
    for (const uint i : {0u, 1u, 24u}) body.scene.indices.push_back(i);
    EXPECT_FALSE(body.closed());
}
}
