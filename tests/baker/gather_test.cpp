// Neighbours that share what their paths find, against each one alone: the same irradiance, with less noise.
#include "baker/gather.hpp"
#include "baker/irradiance.hpp"
#include "engine/scene/scene.hpp"
#include "rooms.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
// Sums of samples that are drawn independently.
struct Sum {
    double sum = 0.0, squares = 0.0, count = 0.0;
    void add(double x) { sum += x, squares += x * x, count += 1.0; }
    double mean() const { return sum / count; }
    double variance() const { return std::max(squares / count - mean() * mean(), 0.0); } // of one
    double error() const { return std::sqrt(variance() / count); }                       // of the mean, standard
};

// Sixteen points in one place of a triangle; every fourth on another triangle, as where charts meet in a page.
std::vector<Surface> somewhere(const World& world, uint seed)
{
    Sampler random = makeSampler(seed, 0);
    const auto pick = [&] { return std::min(uint(next1(random) * float(world.triangles().size())), uint(world.triangles().size() - 1)); };
    const uint triangles[] = {pick(), pick()};
    const vec2 middle = next2(random);
    std::vector<Surface> points;
    for (int i = 0; i < kPacket; i++) {
        const uint triangle = triangles[i % 4 == 3 ? 1 : 0];
        const World::Triangle& t = world.triangles()[triangle];
        const vec2 u = clamp(middle + 0.1f * (next2(random) - 0.5f), vec2(0.01f), vec2(0.99f)); // off the edges, as texels' points are
        const float root = std::sqrt(u.x), a = 1.0f - root, b = u.y * root;
        const vec3 p = a * world.vertices()[t.vertex[0]].position + b * world.vertices()[t.vertex[1]].position +
                       (1.0f - a - b) * world.vertices()[t.vertex[2]].position;
        const vec3 normal = safeNormalize(world.front(triangle), vec3(0.0f, 1.0f, 0.0f));
        points.push_back(whiteSurface(p, normal, normal));
    }
    return points;
}

// One round of a group, together or one by one: the mean of its points' irradiance / pi, and the first point's.
std::pair<double, double> sampleGroup(const LightTransport& transport, const std::vector<Surface>& points, uint seed, uint round,
                                      bool together)
{
    RayCount rays;
    const Tracer tracer{&transport, &transport.lights, &rays};
    Neighbours group;
    group.count = int(points.size());
    for (int i = 0; i < group.count; i++) {
        const Surface& white = points[std::size_t(i)];
        group.white.set(i, white.position, leaving(white, white.geometricNormal), white.frame.normal, white.geometricNormal);
        group.lightSeed[i] = hash3(seed + 4242u, uint(i), together);
        group.sample = round;
        group.random[i] = makeSampler(hash3(seed, uint(i), together), round);
        Sampler direction = makeSampler(hash2(seed, 99u + together), round * uint(group.count) + uint(i));
        group.rays[i] = cosineRay(white, next2(direction));
        if (!together)
            group.irradiance.set(
                i, irradianceSample(tracer, tracer, white, group.rays[i], closestHit(tracer, group.rays[i]), group.random[i]));
    }
    if (together) gather(tracer, tracer, group);
    double sum = 0.0;
    for (int i = 0; i < group.count; i++) sum += double(luminance(group.irradiance[i]));
    return {sum / group.count, double(luminance(group.irradiance[0]))};
}
}

static void expectUnbiased(const Scene& scene)
{
    constexpr int kGroups = 40;
    constexpr uint kRounds = 256;
    constexpr double kFar = 4.5; // standard errors: one of 10^5 lies beyond
    const World world(scene, Content::staticOnly);
    const LightTransport transport(world, scene.lights);
    double squares = 0.0;
    int told = 0;
    for (uint g = 0; g < kGroups; g++) {
        const std::vector<Surface> points = somewhere(world, 7u + g);
        Sum alone[2], together[2];
        for (uint round = 0; round < kRounds; round++) {
            const auto one = sampleGroup(transport, points, g, round, false), all = sampleGroup(transport, points, g, round, true);
            alone[0].add(one.first), alone[1].add(one.second);
            together[0].add(all.first), together[1].add(all.second);
        }
        for (int k = 0; k < 2; k++) {
            const double error = std::hypot(alone[k].error(), together[k].error());
            if (!(error > 0.0)) {
                EXPECT_NEAR(together[k].mean(), alone[k].mean(), 1e-6) << g;
                continue;
            }
            const double far = (together[k].mean() - alone[k].mean()) / error;
            EXPECT_LT(std::abs(far), kFar) << "group " << g << (k == 0 ? ", all" : ", its first") << ": " << together[k].mean()
                                           << " against " << alone[k].mean() << " +- " << error;
            squares += far * far;
            told++;
        }
    }
    ASSERT_GT(told, kGroups / 2);
    // Even points err less than their variance says: the mean square is 1 at most, up to its own scatter
    EXPECT_LT(squares / told, 1.0 + 4.0 * std::sqrt(2.0 / told));
}

// Levels with lamps, emitters, a sky, dust, masks, metals, mirrors, clear glass and what is blended.
class Gather : public testing::TestWithParam<const char*>
{
};

TEST_P(Gather, IsUnbiased) { expectUnbiased(loadLevel(std::string("content/") + GetParam() + ".glb")); }

INSTANTIATE_TEST_SUITE_P(OfLevels, Gather,
                         testing::Values("cornell/cornell", "two_rooms/two_rooms_open", "gallery/gallery", "pool/pool",
                                         "still_life/still_life"),
                         [](const auto& info) { return std::string(info.param).substr(0, std::string(info.param).find('/')); });

// A lane that is not asked lets everything through: light that touches a texel, whose ray has no length, arrives.
TEST(GatherRays, AreOneWhereNoneIsAsked)
{
    const Scene scene = loadLevel("content/cornell/cornell.glb");
    const World world(scene, Content::staticOnly);
    const vec3 middle = 0.5f * (scene.lower + scene.upper);
    RayLanes rays;
    for (int i = 0; i < kPacket; i++) {
        rays.origin.set(i, middle), rays.direction.set(i, vec3(0.0f, -1.0f, 0.0f)); // down, to the floor or a box
        rays.far[i] = i % 4 == 0 ? -1.0f : i % 4 == 1 ? 1e-3f : kRayFar;
        rays.asked[i] = i % 4 == 0 || i % 4 == 3 ? 0 : -1;
    }
    Lanes3 passed;
    world.transmittances(rays, passed);
    for (int i = 0; i < kPacket; i++) EXPECT_EQ(passed[i], vec3(i % 4 == 2 ? 0.0f : 1.0f)) << i;
}

// Light from all over the sphere, one by one and all at once: the latter by a table of arcs. What comes from behind has no direction to tell.
TEST(GatherDirections, AreThoseOfEachLight)
{
    Sampler random = makeSampler(3u, 0);
    for (int round = 0; round < 500; round++) {
        Neighbours one, all;
        Lanes3 direction, light;
        one.directional = all.directional = true;
        one.count = all.count = kPacket;
        one.begin(), all.begin();
        for (int i = 0; i < kPacket; i++) {
            const vec3 normal = sampleUniformSphere(next2(random));
            for (Neighbours* of : {&one, &all}) of->white.set(i, vec3(0.0f), vec3(0.0f), normal, normal);
            const vec3 from =
                i % 4 == 0 ? normalize(normal + 0.01f * sampleUniformSphere(next2(random))) : sampleUniformSphere(next2(random));
            direction.set(i, from), light.set(i, i % 5 == 0 ? vec3(0.0f) : vec3(next1(random), next1(random), next1(random)));
        }
        for (int i = 0; i < kPacket; i++) one.gain(i, direction[i], light[i]);
        all.gain(direction, light);
        for (int i = 0; i < kPacket; i++) {
            EXPECT_EQ(one.irradiance[i], all.irradiance[i]);
            EXPECT_LT(length(one.turn[i] - all.turn[i]), 1e-4f * max(length(one.turn[i]), 1.0f)) << dot(direction[i], all.white.normal[i]);
        }
    }
}

// Air that dims, scatters and glows, each colour in its own way, in a part of the level.
TEST(GatherInAir, IsUnbiased)
{
    Scene scene = loadLevel("content/cornell/cornell.glb");
    Medium air{};
    air.scattering = vec3(0.6f, 0.3f, 0.1f), air.absorption = vec3(0.05f, 0.2f, 0.4f), air.g = 0.4f,
    air.emission = vec3(0.02f, 0.05f, 0.1f);
    air.lower = scene.lower, air.upper = mix(scene.lower, scene.upper, vec3(0.7f, 0.6f, 1.0f));
    scene.media = {air};
    expectUnbiased(scene);
}

// At the foot of a high black wall under an even sky, every texel has half the sky, for a share of what it met and for fifteen of the others'.
TEST(GatherAtTheFootOfAWall, FindsHalfTheSkyWithLessNoise)
{
    constexpr uint kRounds = 512;
    Scene scene;
    addSurface(scene, moved(box(vec3(1.0f, 2e4f, 2e4f)), vec3(-0.5f, 0.0f, 0.0f)), shining(0.0f));
    scene.sky.radiance = vec3(1.0f);
    scene.lower = vec3(-1e4f), scene.upper = vec3(1e4f);
    const Bakery bakery(std::move(scene));
    std::vector<Surface> points;
    for (int i = 0; i < kPacket; i++)
        points.push_back(whiteSurface(vec3(0.1f, 0.0f, 0.005f * float(i)), vec3(0.0f, 1.0f, 0.0f), vec3(0.0f, 1.0f, 0.0f)));
    Sum alone, together;
    for (uint round = 0; round < kRounds; round++) {
        alone.add(sampleGroup(bakery.transport, points, 3, round, false).second);
        together.add(sampleGroup(bakery.transport, points, 3, round, true).second);
    }
    EXPECT_NEAR(together.mean(), 0.5, 4.0 * together.error() + 1e-4);
    EXPECT_NEAR(alone.mean(), 0.5, 4.0 * alone.error() + 1e-4);
    EXPECT_LT(together.variance(), 0.25 * alone.variance());
}
}
