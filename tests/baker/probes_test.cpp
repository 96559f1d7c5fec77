// Irradiance probes in rooms whose light is known everywhere.
#include "baker/probe_light.hpp"
#include "baker/probes.hpp"
#include "engine/baked/probe_read.hpp"
#include "engine/core/error.hpp"
#include "engine/core/interrupt.hpp"
#include "rooms.hpp"
#include "tests/shaders/statistics.hpp"
#include <algorithm>
#include <csignal>

namespace afterglow
{
using test::Mean;
using test::Random;

static constexpr int kSamples = 4096;

static ProbeLight lit(Bakery& bakery, vec3 position, uint seed, RayCount& rays)
{
    ProbeSums sums = noPaths(seed, kSamples);
    tracePaths(bakery.context, position, kSamples, rays, sums);
    return lightOf(sums);
}

TEST(Probes, holdTheOneRadianceOfAFurnace)
{
    Bakery bakery(furnace(0.5f));
    const ProbesResult result = bakeProbes(bakery.context, {.spacing = 1.0, .samples = kSamples});
    EXPECT_EQ(result.tree.probes.size(), 27u);
    for (vec3 axis : kAxes) {
        Mean mean;
        for (const Probe& probe : result.tree.probes) mean.add(double(probeIrradiance(probe, axis).y));
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

// Light from half of all directions. The step x > 0 has no second band, so that order 2 is nearly all: irradiance / pi = (1 + n.x) / 2, on
// the plane between the halves, whatever y and z.
TEST(Probes, knowWhereTheLightComesFrom)
{
    Bakery bakery(halfLitRoom());
    Random random;
    RayCount rays;
    Mean about[6];
    for (uint i = 0; i < 25; i++) {
        const vec3 position = anywhere(random, vec3(0, -0.8f, -0.8f), vec3(0, 0.8f, 0.8f));
        const Probe probe = lit(bakery, position, i, rays).probe();
        for (int side = 0; side < 6; side++) about[side].add(double(probeIrradiance(probe, kAxes[side]).y));
    }
    for (int side = 0; side < 6; side++)
        EXPECT_NEAR(about[side].value(), 0.5 * (1.0 + double(kAxes[side].x)), 4.0 * about[side].error() + 1e-3) << side;
}

// One small lamp, which order 2 alone would answer with 3/32 of its light from the side.
TEST(Probes, holdACompactLightToItsEdge)
{
    Scene scene;
    addSurface(scene, flipped(box(vec3(2.0f))), shining(0.0f));
    addSurface(scene, moved(box(vec3(0.1f)), vec3(0, 0.9f, 0)), shining(100.0f));
    scene.lower = vec3(-1.0f), scene.upper = vec3(1.0f);
    Bakery bakery(scene);
    RayCount rays;
    const ProbeLight light = lit(bakery, vec3(0.0f, -0.5f, 0.0f), 1, rays);
    const float solidAngle = 0.1f * 0.1f / (1.35f * 1.35f), whole = 100.0f * solidAngle / kPi; // of its lower face
    for (vec3 axis : kAxes) EXPECT_NEAR(probeIrradiance(light.probe(), axis).y, max(axis.y, 0.0f) * whole, 0.02f * whole) << axis.y;
    EXPECT_GT(std::abs(light.toward.y), 0.99f); // the remainder is even: its axis has no sense
}

// Light from half of all directions has no second band: order 1 is as good, of four numbers a channel in the place of nine.
TEST(Probes, ofOrder1HoldWhatHasNoSecondBand)
{
    Bakery bakery(halfLitRoom());
    const ProbesResult result = bakeProbes(bakery.context, {.spacing = 1.0, .samples = kSamples, .order = 1});
    EXPECT_EQ(result.tree.order, 1);
    Random random;
    Mean toward;
    for (int i = 0; i < 25; i++) {
        const vec3 position = anywhere(random, vec3(0, -0.8f, -0.8f), vec3(0, 0.8f, 0.8f));
        toward.add(double(probeLookup(ProbeSet{&result.tree}, position, vec3(1, 0, 0)).y));
    }
    EXPECT_NEAR(toward.value(), 1.0, 0.05);
    for (const Probe& probe : result.tree.probes) {
        EXPECT_EQ(probe.lobe, vec3(0.0f));
        for (int i = 4; i < 9; i++) EXPECT_EQ(probe.irradiance.c[i], vec3(0.0f));
    }
    const ProbesResult whole = bakeProbes(bakery.context, {.spacing = 1.0, .samples = 64});
    EXPECT_LT(bytesOf(result.tree), bytesOf(whole.tree));
}
}
