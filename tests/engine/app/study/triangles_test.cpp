// Rows of time by triangles: whatever the times, rays meet what every triangle says, asked in turn. Needs a device for its own rays.
#include "baker/ray_kinds.hpp"
#include "engine/app/study/clutter.hpp"
#include "engine/app/study/files.hpp"
#include "engine/app/study/triangles.hpp"
#include "shaders/triangle.h"
#include "tests/engine/gpu/validated.hpp"
#include <cmath>

namespace afterglow
{
namespace
{
std::vector<Sweep> few()
{
    std::vector<Sweep> sweeps = triangleSweeps();
    for (Sweep& sweep : sweeps) sweep.values = {500, 1000, 2000};
    return sweeps;
}

void demandRow(const Curve& curve, bool hits)
{
    ASSERT_EQ(curve.points.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const Point& point = curve.points[i];
        EXPECT_EQ(point.value, double(clutter(std::size_t(curve.sweep.values[i])).indices.size() / 3));
        EXPECT_GT(point.ms, 0.0);
        if (hits) {
            EXPECT_EQ(point.error, 0.0) << curve.sweep.knob << " at " << point.value;
        } else {
            EXPECT_TRUE(std::isnan(point.error)) << "no ray was asked";
        }
    }
    EXPECT_TRUE(curve.fit);
    EXPECT_NE(curve.verdict.find("measured triangles^"), std::string::npos) << curve.verdict;
    EXPECT_NE(csvOf({.subjects = {{"triangles", "", "", {curve}}}}).find("\ntriangles," + curve.sweep.knob + ","), std::string::npos);
}
}

TEST(TrianglesByTheCpu, agree_with_every_triangle_asked_in_turn)
{
    const Scene scene = clutter(5000);
    const World world(scene, Content::everything);
    const LightTransport transport(world, {});
    for (const Ray& ray : RayKinds(transport).incoherent(2048)) {
        float nearest = kRayFar;
        for (const World::Triangle& t : world.triangles())
            nearest = std::min(nearest, triangleDistance(ray, world.vertices()[t.vertex[0]].position,
                                                         world.vertices()[t.vertex[1]].position, world.vertices()[t.vertex[2]].position));
        EXPECT_NEAR(world.closestHit(ray).distance, nearest, 1e-5f * nearest);
    }
    for (const Sweep& sweep : few())
        if (sweep.clock == Clock::cpuRays) demandRow(timedCurve(nullptr, sweep, unheard), /* hits= */ true);
}

class TrianglesByTheDevice : public Validated
{
};

TEST_F(TrianglesByTheDevice, agree_too_and_are_drawn)
{
    for (const Sweep& sweep : few())
        if (sweep.clock != Clock::cpuRays && (gpu.device.rayQuery || !sweep.rays))
            demandRow(timedCurve(&gpu, sweep, unheard), /* hits= */ sweep.rays);
}
}
