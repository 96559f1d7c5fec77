// What a ray meets of a triangle, where paper says.
#include "shaders/random.h"
#include "shaders/sampling.h"
#include "shaders/triangle.h"
#include <gtest/gtest.h>

namespace afterglow
{
using namespace shared;

const vec3 kA(1, 0, -5), kB(4, 0, -5), kC(1, 2, -5);

TEST(Triangle, is_met_within_its_edges_from_either_side)
{
    const auto met = [](vec3 origin, vec3 direction, float far = kRayFar) {
        return triangleDistance({origin, direction, far}, kA, kB, kC);
    };
    EXPECT_FLOAT_EQ(met(vec3(1.5f, 0.5f, 2), vec3(0, 0, -1)), 7.0f);
    EXPECT_FLOAT_EQ(met(vec3(1.5f, 0.5f, -6), vec3(0, 0, 1)), 1.0f);
    EXPECT_EQ(met(vec3(1.5f, 0.5f, -6), vec3(0, 0, -1)), kRayFar) << "behind";
    EXPECT_EQ(met(vec3(1.5f, 0.5f, 2), vec3(0, 0, -1), 6.9f), kRayFar) << "beyond its end";
    EXPECT_EQ(met(vec3(0.99f, 0.5f, 2), vec3(0, 0, -1)), kRayFar);
    EXPECT_EQ(met(vec3(1.5f, -0.01f, 2), vec3(0, 0, -1)), kRayFar);
    EXPECT_EQ(met(vec3(2.6f, 1.0f, 2), vec3(0, 0, -1)), kRayFar) << "beyond the slanted edge";
    EXPECT_EQ(met(vec3(0, 0.5f, -5), vec3(1, 0, 0)), kRayFar) << "in its plane";
    EXPECT_EQ(met(vec3(0, 0.5f, -4), vec3(1, 0, 0)), kRayFar) << "beside its plane";
}

TEST(Triangle, is_met_where_the_ray_was_aimed)
{
    for (uint i = 0; i < 1000; ++i) {
        Sampler random = makeSampler(2u, i);
        const vec3 b = sampleTriangle(next2(random)), aim = b.x * kA + b.y * kB + b.z * kC;
        const vec3 origin = aim + 10.0f * sampleUniformSphere(next2(random));
        if (std::abs(origin.z + 5.0f) < 0.1f) continue; // nearly in its plane
        EXPECT_NEAR(triangleDistance({origin, (aim - origin) / 10.0f, kRayFar}, kA, kB, kC), 10.0f, 1e-3f) << i;
    }
}
}
