// What planes tell of a region's section before it is cut: never more than it is.
#include "baker/planes.hpp"
#include "rooms.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static vec3 anywhere(Sampler& random, float reach)
{
    const vec2 across = next2(random);
    return reach * (2.0f * vec3(across.x, across.y, next1(random)) - 1.0f);
}

TEST(Planes, cutNoLessThanTheyTell)
{
    int told = 0;
    for (uint round = 0; round < 200; round++) {
        Sampler random = makeSampler(0x706c616eu, round);
        Scene scene;
        for (int i = 0; i < 4; i++) addSurface(scene, moved(box(vec3(0.2f + next1(random))), anywhere(random, 1.0f)), shining(1.0f));
        scene.lower = vec3(-2.0f), scene.upper = vec3(2.0f);
        const World world(scene, Content::staticOnly);
        Region region = boxRegion(dvec3(-1.0), dvec3(1.0));
        for (int i = 0; i < 3; i++) // slanted, as walls cut it
            if (const Region cut = clipped(region, dvec3(normalize(anywhere(random, 1.0f))), double(next1(random)), false, 1e-3);
                !cut.empty())
                region = cut;
        std::vector<uint> triangles(world.triangles().size());
        for (uint i = 0; i < triangles.size(); i++) triangles[i] = i;
        for (const Plane& plane : planesIn(world, region, 1e-3, triangles)) {
            const double section = area(sectionOf(region, plane.normal, plane.offset));
            EXPECT_LE(plane.leastSection, section * (1.0 + 1e-9)) << round;
            EXPECT_GT(plane.area, 0.0);
            told += plane.leastSection > 0.1 * section ? 1 : 0;
        }
    }
    EXPECT_GT(told, 200) << "a bound that tells something";
}
}
