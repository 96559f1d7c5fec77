// Paths go where they lessen most what lookups err by, and what is stated is what they err by.
#include "baker/probe_noise.hpp"
#include "engine/baked/probe_read.hpp"
#include "rooms.hpp"
#include "tests/shaders/statistics.hpp"

namespace afterglow
{
using test::Random;

// Paths are as many as the noise of lookups needs, and what is stated is what lookups are off by: a level whose paths stopped where halves
// happen to agree would state less. The rooms are the same but for their paths, so that their probes stand at the same places.
TEST(Probes, stateTheNoiseOfLookups)
{
    constexpr float kNoise = 0.02f;
    Bakery bakery(halfLitRoom());
    ProbeEffort effort{.spacing = 0.25, .samples = 32, .noise = double(kNoise)};
    const ProbesResult baked = bakeProbes(bakery.context, effort);
    effort.samples = 8192;
    const ProbesResult truth = bakeProbes(bakery.context, effort);
    ASSERT_EQ(baked.tree.positions, truth.tree.positions);
    Random random;
    double square = 0.0;
    constexpr int kPoints = 4000;
    for (int i = 0; i < kPoints; i++) {
        const vec3 position = vec3(-1.0f) + 2.0f * vec3(random.next(), random.next(), random.next());
        double off = 0.0, light = 0.0;
        for (vec3 normal : kSphereNormal) {
            const double told = double(probeLookup(ProbeSet{&baked.tree}, position, normal).y),
                         is = double(probeLookup(ProbeSet{&truth.tree}, position, normal).y);
            off += (told - is) * (told - is) / double(kSphereNormals), light += is / double(kSphereNormals);
        }
        square += off / (light * light) / kPoints;
    }
    EXPECT_GT(baked.samples, 32.0) << "noise said how many";
    EXPECT_LT(baked.samples, 32.0 * kMoreProbePaths);
    // Some 700 probes of six independent bands: the standard error of either RMS is 1.1 %, and what paths are allotted by varies as much
    EXPECT_LT(std::sqrt(square), 1.05 * double(kNoise));
    EXPECT_NEAR(double(baked.estimatedError) / std::sqrt(square), 1.0, 0.05);
}

// With a multiplier: d(paths) / d(error) is the same for each that is within the bounds, and no other choice has fewer paths.
TEST(ProbeNoise, allotsPathsWhereTheyLessenMost)
{
    const std::vector<double> adds{1.0, 4.0, 100.0, 0.0, 1e-6}, least(5, 10.0);
    const auto leftBy = [&](const std::vector<double>& paths) {
        double square = 0.0;
        for (std::size_t i = 0; i < adds.size(); i++) square += adds[i] / paths[i];
        return std::sqrt(square);
    };
    const std::vector<double> paths = allotted(adds, 0.5, least, 1e6);
    EXPECT_NEAR(leftBy(paths), 0.5, 1e-6);
    EXPECT_NEAR(paths[1] / paths[0], 2.0, 1e-9);
    EXPECT_NEAR(paths[2] / paths[0], 10.0, 1e-9);
    EXPECT_EQ(paths[3], 10.0);
    EXPECT_EQ(paths[4], 10.0);
    EXPECT_EQ(allotted(adds, 100.0, least, 1e6), std::vector<double>(5, 10.0)) << "the least do";
    const std::vector<double> bounded = allotted(adds, 1e-9, least, 1000.0);
    for (std::size_t i : {0, 1, 2, 4}) EXPECT_NEAR(bounded[i], 1000.0, 1e-6) << "no more than there may be";

    // What hardly adds takes no paths from the others: a probe deep in fog
    std::vector<double> even(1000, 1e-4);
    for (double fog : {0.0, 1e-38, 1e-300}) {
        even.push_back(fog);
        EXPECT_NEAR(allotted(even, 0.01, std::vector<double>(even.size(), 256.0), 8192.0).front(), 1000.0, 1e-3) << fog;
        even.pop_back();
    }
    EXPECT_EQ(allotted({0.0, 0.0}, 0.1, {1.0, 1.0}, 2.0), std::vector<double>(2, 1.0)) << "all is dark";
}

// One channel that is no number makes none of the sums one.
TEST(ProbeNoise, isLeftOutWhereItIsNoNumber)
{
    Scene scene = halfLitRoom();
    scene.materials[0].emission = vec3(1.0f, 1e38f, 1.0f);
    Bakery bakery(scene);
    const ProbesResult result = bakeProbes(bakery.context, {.spacing = 1.0, .samples = 16, .noise = 0.01});
    EXPECT_TRUE(std::isfinite(result.estimatedError));
    for (const Probe& probe : result.tree.probes)
        for (const vec3& c : probe.irradiance.c) EXPECT_TRUE(isFinite(c)) << c.y;
    EXPECT_GT(bakery.context.rays().notFinite, 0u);
}
}
