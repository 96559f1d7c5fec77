// The level whose triangles are counted: as many as are asked for, and nothing leaves it.
#include "baker/world.hpp"
#include "engine/app/study/clutter.hpp"
#include "engine/scene/closed.hpp"
#include "shaders/random.h"
#include "shaders/sampling.h"
#include <gtest/gtest.h>

namespace afterglow
{
TEST(Clutter, has_about_as_many_triangles_as_are_asked_for)
{
    for (const std::size_t asked : {1000u, 3000u, 10000u, 30000u, 100000u}) {
        const Scene scene = clutter(asked);
        EXPECT_NEAR(double(scene.indices.size()) / 3.0 / double(asked), 1.0, asked < 10000u ? 0.07 : 0.02) << asked;
        EXPECT_EQ(scene.objects.size(), 41u);
    }
    EXPECT_EQ(clutter(0).indices.size(), 3u * 41u * 12u) << "no fewer than cubes have";
}

TEST(Clutter, is_closed_bodies_in_a_closed_room)
{
    for (const std::size_t asked : {1000u, 3000u, 20000u}) {
        Scene scene = clutter(asked);
        const Primitive& room = scene.meshes[0].primitives[0];
        EXPECT_FALSE(isClosedBody(scene, room)) << "its fronts look inwards";
        for (uint i = 0; i < room.indexCount; i += 3) std::swap(scene.indices[room.firstIndex + i], scene.indices[room.firstIndex + i + 1]);
        for (const Mesh& mesh : scene.meshes) EXPECT_TRUE(isClosedBody(scene, mesh.primitives[0])) << asked << ", " << mesh.name;
        for (const Vertex& vertex : scene.vertices) {
            EXPECT_TRUE(all(lessThanEqual(abs(vertex.position), scene.upper)));
            EXPECT_NEAR(length(vertex.normal), 1.0f, 1e-5f);
        }
    }
}

// From the camera's place every way ends, at a wall or at a body; both are seen.
TEST(Clutter, lets_no_ray_out)
{
    const Scene scene = clutter(3000);
    const World world(scene, Content::everything);
    int bodies = 0;
    const uint kRays = 10000;
    for (uint i = 0; i < kRays; ++i) {
        shared::Sampler random = makeSampler(1u, i);
        const Hit hit = world.closestHit({vec3(scene.cameras[0].toWorld[3]), sampleUniformSphere(next2(random)), kRayFar});
        ASSERT_LT(hit.distance, kRayFar) << i;
        bodies += world.triangles()[hit.triangle].object > 0u ? 1 : 0;
    }
    EXPECT_GT(bodies, int(kRays) / 20);
    EXPECT_LT(bodies, int(kRays) / 2);
}
}
