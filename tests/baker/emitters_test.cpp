// Emissive triangles as lights: points are drawn by power, and the density says by how much.
#include "baker/emitters.hpp"
#include "rooms.hpp"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
namespace
{
// A box whose faces shine with 1, 2, 0, 0.5, 4 and 1: none hides another from a point inside.
Scene lantern()
{
    Scene scene;
    const Shape walls = flipped(box(vec3(2.0f)));
    const float radiance[6] = {1.0f, 2.0f, 0.0f, 0.5f, 4.0f, 1.0f};
    for (int face = 0; face < 6; ++face)
        addSurface(scene, part(walls, [=](vec3 p) { return (face % 2 == 0 ? -1.0f : 1.0f) * p[face / 2] > 0.999f; }),
                   shining(radiance[face]));
    return scene;
}

double density(const World& world, const Emitters& emitters, vec3 from, vec3 direction)
{
    const Ray ray{from, direction, kRayFar};
    const Hit hit = world.closestHit(ray);
    if (!(hit.distance < kRayFar)) return 0.0;
    return double(emitters.pdf(ray, hit, world.surfaceAt(ray, hit)));
}
}

TEST(Emitters, SamplesFollowTheirDensity)
{
    const Scene scene = lantern();
    const World world(scene, Content::everything);
    const Emitters emitters(world);
    const vec3 from(0.3f, -0.2f, 0.1f);
    const double deviation = directionChiSquare(
        [&](Random& r, vec3& d) {
            const float choice = r.next();
            const LightSample s = emitters.sample(from, choice, r.next2());
            EXPECT_GT(s.pdf, 0.0f);
            d = s.direction;
            return s.pdf > 0.0f;
        },
        [&](vec3 d) { return density(world, emitters, from, d); }, 50000);
    EXPECT_LT(deviation, 4.0);
}

// H41
TEST(Emitters, TheEndsOfTheUnitIntervalAreSafe)
{
    const Scene scene = lantern();
    const World world(scene, Content::everything);
    const Emitters emitters(world);
    for (float choice : {0.0f, 0.5f, kOneMinusEpsilon})
        for (float x : {0.0f, 0.5f, kOneMinusEpsilon})
            for (float y : {0.0f, 0.5f, kOneMinusEpsilon}) {
                const LightSample s = emitters.sample(vec3(0.3f, -0.2f, 0.1f), choice, vec2(x, y));
                EXPECT_NEAR(length(s.direction), 1.0f, 1e-6f);
                EXPECT_GT(s.pdf, 0.0f);
                EXPECT_TRUE(s.radiance.x > 0.0f && std::isfinite(s.radiance.x / s.pdf));
            }
}

// Both ways of asking agree, and the radiance is the face's.
TEST(Emitters, SayTheSameOfASampleAndOfARay)
{
    const Scene scene = lantern();
    const World world(scene, Content::everything);
    const Emitters emitters(world);
    const vec3 from(0.3f, -0.2f, 0.1f);
    Random random;
    for (int i = 0; i < 2000; ++i) {
        const float choice = random.next();
        const LightSample s = emitters.sample(from, choice, random.next2());
        expectRelative(density(world, emitters, from, s.direction), double(s.pdf), 1e-3);
        const Ray ray{from, s.direction, kRayFar};
        EXPECT_EQ(s.radiance, world.surfaceAt(ray, world.closestHit(ray)).emission);
    }
}

// The integral of the radiance over all directions is known: by solid angle, sum of radiance * 4 pi / 6 from the middle.
TEST(Emitters, EstimateWhatArrives)
{
    const Scene scene = lantern();
    const World world(scene, Content::everything);
    const Emitters emitters(world);
    Random random;
    Mean mean;
    for (int i = 0; i < 20000; ++i) {
        const float choice = random.next();
        const LightSample s = emitters.sample(vec3(0.0f), choice, random.next2());
        mean.add(s.pdf > 0.0f ? double(s.radiance.x / s.pdf) : 0.0);
    }
    EXPECT_NEAR(mean.value(), (1.0 + 2.0 + 0.0 + 0.5 + 4.0 + 1.0) * 4.0 * M_PI / 6.0, 4.0 * mean.error());
}

// From behind, a one-sided triangle sends nothing.
TEST(Emitters, AreDarkFromBehind)
{
    Scene scene;
    addSurface(scene, {{{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}}, {0, 1, 2}}, shining(1.0f));
    const World world(scene, Content::everything);
    const Emitters emitters(world);
    EXPECT_GT(emitters.sample(vec3(0, 1, 0), 0.5f, vec2(0.3f)).pdf, 0.0f);
    EXPECT_EQ(emitters.sample(vec3(0, -1, 0), 0.5f, vec2(0.3f)).pdf, 0.0f);
}
}
