// Irradiance probes in rooms whose light is known everywhere.
#include "baker/probes.hpp"
#include "engine/core/error.hpp"
#include "engine/core/interrupt.hpp"
#include "rooms.hpp"
#include "shaders/probe.h"
#include "tests/shaders/statistics.hpp"
#include <csignal>

namespace afterglow
{
using test::Mean;

static constexpr int kSamples = 4096;
static const vec3 kAxes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

// Probes within `size` about the origin.
static ProbeVolume volumeOf(ivec3 count, vec3 size)
{
    ProbeVolume volume;
    volume.count = count;
    volume.toWorld = mat4(vec4(size.x, 0, 0, 0), vec4(0, size.y, 0, 0), vec4(0, 0, size.z, 0), vec4(0, 0, 0, 1));
    return volume;
}

// Irradiance / pi about a normal, over the probes of a volume.
static Mean about(const ProbeVolume& volume, vec3 normal)
{
    Mean mean;
    for (const Sh9& probe : volume.irradiance) mean.add(double(shIrradiance(probe, normal).y));
    return mean;
}

TEST(Probes, holdTheOneRadianceOfAFurnace)
{
    Bakery bakery(furnace(0.5f));
    const ProbesResult result = bakeProbes(bakery.context, {volumeOf(ivec3(3), vec3(1.5f))}, kSamples);
    EXPECT_EQ(result.count, 27u);
    EXPECT_EQ(result.valid, 27u);
    for (vec3 axis : kAxes) {
        const Mean mean = about(result.volumes[0], axis);
        EXPECT_NEAR(mean.value(), 1.0, 4.0 * mean.error()) << axis.x << axis.y << axis.z;
    }
}

// One probe in dense fog takes long: Ctrl-C is heard at the next ray of a path.
TEST(Probes, stopWithinOne)
{
    Bakery bakery(furnace(0.5f));
    RayCount rays;
    const Tracer tracer{&bakery.context.transport, &bakery.context.transport.lights, &rays};
    const Ray ray{vec3(0.0f), vec3(0, 1, 0), kRayFar};
    bakery.context.progress.begin("probes", 1, "probes");
    EXPECT_LT(closestHit(tracer, ray).distance, kRayFar);
    std::raise(SIGINT);
    EXPECT_THROW(closestHit(tracer, ray), Error);
    hearInterrupts();
}

// Light from half of all directions. The step x > 0 has no second band, so that order 2 is exact: irradiance / pi = (1 + n.x) / 2. The
// probes stand on the plane between the halves, where it holds whatever their y and z.
TEST(Probes, knowWhereTheLightComesFrom)
{
    Bakery bakery(halfLitRoom());
    const ProbesResult result = bakeProbes(bakery.context, {volumeOf(ivec3(1, 5, 5), vec3(1.0f, 1.5f, 1.5f))}, kSamples);
    EXPECT_EQ(result.valid, 25u);
    for (vec3 axis : kAxes) {
        const Mean mean = about(result.volumes[0], axis);
        EXPECT_NEAR(mean.value(), 0.5 * (1.0 + double(axis.x)), 4.0 * mean.error() + 1e-6) << axis.x << axis.y << axis.z;
    }
}

// Those outside see nothing but the walls' backs.
TEST(Probes, areInvalidOutsideTheRoom)
{
    Bakery bakery(furnace(0.5f));
    const ProbesResult result = bakeProbes(bakery.context, {volumeOf(ivec3(5, 1, 1), vec3(4.0f))}, 256); // x = -2 -1 0 1 2
    EXPECT_EQ(result.volumes[0].validity[0], kProbeBorrowed);
    EXPECT_EQ(result.volumes[0].validity[2], 1.0f);
    EXPECT_EQ(result.volumes[0].validity[4], kProbeBorrowed);
    EXPECT_EQ(result.clearance[0], 0.0f);
    EXPECT_GT(result.clearance[2], 0.9f); // m: no wall is nearer than 1, as harmonic means go
    EXPECT_LT(result.clearance[2], std::sqrt(3.0f));
}

TEST(Probes, fillTheLevelUnlessTheyArePlaced)
{
    Scene scene = furnace(0.5f);
    std::vector<ProbeVolume> placed = placeProbes(scene, 0.5f);
    ASSERT_EQ(placed.size(), 1u);
    EXPECT_EQ(placed[0].count, ivec3(4));
    EXPECT_NEAR(probePosition(placed[0], 0).x, -0.75f, 1e-6f); // in the middle of its cell
    EXPECT_NEAR(probePosition(placed[0], 63).z, 0.75f, 1e-6f);

    ProbeVolumeRequest request;
    request.name = "hall";
    request.spacing = 0.25f;
    scene.probeVolumes = {request};
    placed = placeProbes(scene, 0.5f);
    ASSERT_EQ(placed.size(), 1u);
    EXPECT_EQ(placed[0].name, "hall");
    EXPECT_EQ(placed[0].count, ivec3(5)); // on the faces of the box that was asked for
}
}
